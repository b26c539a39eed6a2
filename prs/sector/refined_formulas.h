#pragma once

#include "prs/sector/refined/local_compliance.h"
#include "prs/sector/refined/nut_formulas.h"
#include "prs/sector/sector_numbers.h"

/// Refined bodies of a sector, for a number or a batch of numbers: one sector per lane.
namespace prs {

template <class Real>
NutNumbers<Real> nut_numbers(const SectorNumbers<Real>& s, const RefinedNumbers<Real>& b, const Real* sections,
                             const Real* outer_radius, const Real* root) {
  return {sections,
          outer_radius,
          root,
          b.nut_pitch_radius,
          b.ring_inner,
          b.ring_outer,
          b.material.nut.youngs_modulus,
          b.material.nut.poisson_ratio,
          s.rollers,
          s.sense,
          s.cosine.nut,
          s.sine.nut};
}

/// Adds the compliance in series with each contact to those of screw and nut: the screw's surface and the nut's wall
/// under radial loads, and the bodies' concentration of loads in rows of contacts.
template <class Real>
void add_body_compliance(const NutShape& shape, const SectorNumbers<Real>& s, const RefinedNumbers<Real>& b,
                         const Real* outer_radius, Real* at_screw, Real* at_nut) {
  using simd::min;
  const std::size_t contacts = shape.contacts.size(), segments = shape.same.size();
  if (shape.effects.radial) {
    const Real whole =
        cylinder_compliance(b.screw_radius, b.screw_bore, b.material.screw, s.rollers, s.pitch, s.sine.screw);
    const Real decay = band_decay(b.screw_radius, b.screw_bore, b.material.screw.poisson_ratio);
    for (std::size_t k = 0; k < contacts; ++k) {
      // Each end of the band reduces one contact as much as the other end reduces its mirror image.
      const Real taken = whole * taken_by_end(decay, Real((static_cast<double>(k) + 0.5) * s.pitch));
      at_screw[k] += whole - taken;
      at_screw[contacts - 1 - k] -= taken;
    }
    Real of_radius(0.0);
    for (std::size_t k = 0; k < contacts; ++k) {
      const auto node = static_cast<std::size_t>(shape.contacts[k]);
      const auto of = [&](std::size_t segment) { return static_cast<std::size_t>(shape.same[segment]); };
      const std::size_t before = of(node > 0 ? node - 1 : 0), behind = of(node < segments ? node : segments - 1);
      const auto alike = [&](std::size_t other) {
        const std::size_t last = other > 0 ? other - 1 : 0;
        return of(last) == before && of(other < segments ? other : segments - 1) == behind;
      };
      if (k == 0 || !alike(static_cast<std::size_t>(shape.contacts[k - 1])))
        of_radius = wall_compliance(b.nut_pitch_radius, min(outer_radius[before], outer_radius[behind]), b.material.nut,
                                    s.rollers, s.pitch, s.sine.nut);
      at_nut[k] += of_radius;
    }
  }
  if (!shape.effects.concentration) return;
  for (const Interface i : kInterfaces) {
    const Part body = body_of(i);
    const auto of = [&](Part p, const LineReachOf<Real>& reach) {
      return concentration_compliance(reach, b.material[p], s.pitch, s.sine[i], s.cosine[i]);
    };
    const Real radius = body == Part::screw ? b.screw_radius : b.nut_pitch_radius;
    const Real both = of(body, rows_around(radius, s.rollers)) + of(Part::roller, opposite_rows(s.roller_radius));
    for (std::size_t k = 0; k < contacts; ++k) (i == Interface::screw ? at_screw : at_nut)[k] += both;
  }
}

}  // namespace prs
