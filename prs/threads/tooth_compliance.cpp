#include "prs/threads/tooth_compliance.h"

#include "prs/model/groove.h"

namespace prs {

ToothDeflection yamamoto_deflection(const ToothSection& t, const Material& m, double diameter,
                                    double nut_outer_diameter) {
  using std::numbers::pi;
  const double a = t.root_width, b = t.pitch_width, c = t.height, p = t.pitch;
  const double tangent = std::tan(t.flank_angle);
  const double e = m.youngs_modulus, nu = m.poisson_ratio;
  const double plane = (1.0 - nu * nu) / e;
  const double slope = 1.0 - std::pow(2.0 - b / a, 2) + 2.0 * std::log(a / b);
  const double outer = nut_outer_diameter * nut_outer_diameter, inner = diameter * diameter;
  ToothDeflection d;
  d.bending = 0.75 * plane * (slope / std::pow(tangent, 3) - 4.0 * c * c / (a * a) * tangent);
  d.shear = 1.2 * (1.0 + nu) / e / tangent * std::log(a / b);
  d.root_inclination = 12.0 * plane * c / (pi * a * a) * (c - 0.5 * b * tangent);
  d.root_shear = 2.0 * plane / pi *
                 (p / a * std::log((p + 0.5 * a) / (p - 0.5 * a)) +
                  0.5 * std::log(4.0 * p * p / (a * a) - 1.0));
  const double ring = nut_outer_diameter > 0.0 ? (outer + inner) / (outer - inner) + nu : 1.0 - nu;
  d.radial = 0.5 / e * diameter / p * tangent * tangent * ring;
  return d;
}

ToothSection tooth_section(const Mechanism& m, Part part) {
  const double flank = m.flank_angle[part], pitch = axial_pitch(m);
  // The flank's normal leaves the axis by the flank angle.
  const double height = m.thread[part]
                            ? m.thread[part]->dedendum
                            : default_groove(part == Part::nut, pitch, 0.0, flank, flank).dedendum;
  const double width =
      m.thread[part] ? m.thread[part]->thickness.value_or(0.5 * pitch) : 0.5 * pitch;
  return {width + 2.0 * height * std::tan(flank), width, height, flank, pitch};
}

PerInterface<double> yamamoto_compliance(const Mechanism& m, const Structure& structure,
                                         const Materials& materials,
                                         const PerInterface<double>& normal_angle, double width) {
  const auto of = [&](Part part) {
    return yamamoto_deflection(tooth_section(m, part), materials[part], *m.pitch_diameter[part],
                               part == Part::nut ? structure.nut.outer_diameter : 0.0)
               .total() /
           width;
  };
  PerInterface<double> compliance;
  for (const Interface i : kInterfaces)
    compliance[i] = (of(body_of(i)) + of(Part::roller)) * std::pow(std::cos(normal_angle[i]), 2);
  return compliance;
}

}  // namespace prs
