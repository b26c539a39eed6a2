#include "prs/measures/stiffness.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>

#include "prs/model/groove.h"
#include "prs/sector/sector_model.h"
#include "prs/threads/contacts.h"

namespace prs {
namespace {

using std::numbers::pi;
using Ends = MeasureOptions::Ends;

double bending_root(Ends ends) {
  switch (ends) {
    case Ends::fixed_free:
      return 1.87510406871196117;
    case Ends::supported_supported:
      return pi;
    case Ends::fixed_supported:
      return 3.92660231204791878;
    case Ends::fixed_fixed:
      return 4.73004074486270403;
  }
  return 0.0;
}

constexpr double kLargestResidual = 1e-9;

/// Integral of dx/(E A) of the nut between two sections.
double nut_compliance(const Structure::Nut& nut, double bore, double modulus, double from, double to) {
  if (!(to > from)) return 0.0;
  double length = to - from, compliance = 0.0;
  for (const Structure::Flange& f : nut.flanges) {
    const double within = std::min(f.to, to) - std::max(f.from, from);
    if (within <= 0.0) continue;
    length -= within;
    compliance += within / ring_area(f.outer_diameter, bore);
  }
  return (compliance + std::max(length, 0.0) / ring_area(nut.outer_diameter, bore)) / modulus;
}

/// Loads of the threads for an approach of the last one; stops if their sum exceeds F, which is enough for a bracket.
/// Returns the sum.
double find_loads(double last_approach, double force, double coefficient, std::span<const ThreadGap> gaps,
                  std::span<double> loads) {
  const auto load = [&](double approach) {
    if (!(approach > 0.0)) return 0.0;
    const double ratio = approach / coefficient;
    return ratio * std::sqrt(ratio);  // pow(ratio, 1.5) is many times slower.
  };
  double approach = last_approach;
  double sum = loads.back() = load(approach);
  for (std::size_t k = gaps.size(); k-- > 0 && sum <= force;) {
    const ThreadGap& g = gaps[k];
    approach += sum * (g.screw + g.nut_behind_thrust) - (force - sum) * g.nut_before_thrust;
    sum += loads[k] = load(approach);
  }
  return sum;
}

}  // namespace

ShaftSection core_section(const Mechanism& m, const Structure::Screw& screw) {
  const std::optional<ThreadHeight>& thread = m.thread.screw;
  const double depth = thread ? thread->dedendum : default_root_depth(axial_pitch(m), m.flank_angle.screw);
  return {*m.pitch_diameter.screw - 2.0 * depth, screw.bore};
}

double radius_of_gyration(const ShaftSection& s) { return 0.25 * std::hypot(s.diameter, s.bore); }

double effective_length_factor(Ends ends) {
  switch (ends) {
    case Ends::fixed_free:
      return 2.0;
    case Ends::supported_supported:
      return 1.0;
    case Ends::fixed_supported:
      return pi / 4.49340945790906418;
    case Ends::fixed_fixed:
      return 0.5;
  }
  return 0.0;
}

double buckling_load(const ShaftSection& section, double modulus, const MeasureOptions::Shaft& shaft,
                     std::optional<double> yield) {
  const double area = ring_area(section.diameter, section.bore);
  const double slenderness = effective_length_factor(shaft.ends) * shaft.length / radius_of_gyration(section);
  const double euler = pi * pi * modulus / (slenderness * slenderness);
  if (yield && euler > 0.5 * *yield) return area * *yield * (1.0 - 0.25 * *yield / euler);
  return area * euler;
}

double critical_speed(const ShaftSection& section, double modulus, double density, const MeasureOptions::Shaft& shaft) {
  const double wave_number = bending_root(shaft.ends) / shaft.length;
  return wave_number * wave_number * radius_of_gyration(section) * std::sqrt(modulus / density);
}

PerPart<double> section_stiffness(const Mechanism& m, const Structure& s, const Materials& materials) {
  const double pitch = axial_pitch(m);
  const auto rigidity = [&](Part p, double area) { return materials[p].youngs_modulus * area; };
  return {
      .screw = rigidity(Part::screw, ring_area(*m.pitch_diameter.screw, s.screw.bore)) / pitch,
      .roller = loaded_rollers(m) * rigidity(Part::roller, disc_area(*m.pitch_diameter.roller)) / (2.0 * pitch),
      .nut = rigidity(Part::nut, ring_area(s.nut.outer_diameter, *m.pitch_diameter.nut)) / pitch,
  };
}

double tooth_stiffness(const Mechanism& m, const Structure& s, const Materials& materials, Part part, double width) {
  return width / yamamoto_deflection(tooth_section(m, part), materials[part], *m.pitch_diameter[part],
                                     part == Part::nut ? s.nut.outer_diameter : 0.0)
                     .total();
}

double axial_hertz_coefficient(double hertz_constant, double normal_angle) {
  return std::pow(hertz_constant, -2.0 / 3.0) * std::pow(std::cos(normal_angle), -5.0 / 3.0);
}

double thread_stiffness(double force, int threads, double coefficient, double tooth_compliance) {
  return threads / (coefficient / std::cbrt(force / threads) + tooth_compliance);
}

SystemStiffness system_stiffness(double mechanism, const MeasureOptions::System& system, const ShaftSection& section,
                                 const Material& material, double lead) {
  SystemStiffness found;
  SystemStiffness::Contributions& c = found.contributions;
  double compliance = 0.0;
  const auto add = [&](std::optional<SystemStiffness::Contribution>& to, double stiffness) {
    to = {stiffness};
    compliance += 1.0 / stiffness;
  };
  add(c.mechanism, mechanism);
  if (system.shaft) {
    const MeasureOptions::System::Shaft& shaft = *system.shaft;
    const double length = shaft.length, x = shaft.from_bearing.value_or(0.0);
    const double modulus = material.youngs_modulus;
    const double shear_modulus = modulus / (2.0 * (1.0 + material.poisson_ratio));
    const double polar = std::numbers::pi / 32.0 * (std::pow(section.diameter, 4) - std::pow(section.bore, 4));
    add(c.shaft, modulus * ring_area(section.diameter, section.bore) /
                     (shaft.from_bearing ? x * (length - x) / length : length));
    add(c.wind_up,
        shear_modulus * polar / shaft.torsion_length.value_or(length) * std::pow(2.0 * std::numbers::pi / lead, 2));
  }
  if (system.support_bearing) add(c.support_bearing, *system.support_bearing);
  if (system.housing) add(c.housing, *system.housing);
  found.total = 1.0 / compliance;
  for (auto* part : {&c.mechanism, &c.shaft, &c.wind_up, &c.support_bearing, &c.housing})
    if (*part) (*part)->share = found.total / (*part)->stiffness;
  return found;
}

std::vector<ThreadGap> thread_gaps(const Mechanism& m, const Structure& s, const Materials& materials, double thrust,
                                   double position) {
  const double pitch = axial_pitch(m), bore = *m.pitch_diameter.nut;
  const double screw =
      loaded_rollers(m) * pitch / (materials.screw.youngs_modulus * ring_area(*m.pitch_diameter.screw, s.screw.bore));
  const auto nut = [&](double from, double to) {
    return loaded_rollers(m) * nut_compliance(s.nut, bore, materials.nut.youngs_modulus, from, to);
  };
  std::vector<ThreadGap> gaps;
  for (int k = 0; k + 1 < m.contacts_per_roller; ++k) {
    const double from = position + k * pitch, to = position + (k + 1) * pitch;
    const double held = std::clamp(thrust, from, to);
    gaps.push_back({screw, nut(from, held), nut(held, to)});
  }
  return gaps;
}

std::vector<double> yang_distribution(double force, double coefficient, std::span<const ThreadGap> gaps) {
  std::vector<double> loads(gaps.size() + 1);
  const auto excess = [&](double w) { return find_loads(w, force, coefficient, gaps, loads) / force - 1.0; };
  // Without approach of the last thread none carries; with twice that for F it carries more than F.
  const double greatest = 2.0 * coefficient * std::pow(force, 2.0 / 3.0);
  std::uintmax_t evaluations = 400;
  const auto root = boost::math::tools::toms748_solve(excess, 0.0, greatest, -1.0, excess(greatest),
                                                      boost::math::tools::eps_tolerance<double>(52), evaluations);
  if (!(std::abs(excess(root.first)) < kLargestResidual)) return {};
  return loads;
}

}  // namespace prs
