#include "prs/measures/stiffness.h"

#include "prs/sector/section_properties.h"
#include "prs/threads/tooth_compliance.h"

namespace prs {

PerPart<double> section_stiffness(const Mechanism& m, const Structure& s,
                                  const Materials& materials) {
  const double pitch = axial_pitch(m);
  const auto rigidity = [&](Part p, double area) { return materials[p].youngs_modulus * area; };
  return {
      .screw = rigidity(Part::screw, ring_area(*m.pitch_diameter.screw, s.screw.bore)) / pitch,
      .roller =
          m.rollers * rigidity(Part::roller, disc_area(*m.pitch_diameter.roller)) / (2.0 * pitch),
      .nut = rigidity(Part::nut, ring_area(s.nut.outer_diameter, *m.pitch_diameter.nut)) / pitch,
  };
}

double tooth_stiffness(const Mechanism& m, const Structure& s, const Materials& materials,
                       Part part, double width) {
  return width / yamamoto_deflection(tooth_section(m, part), materials[part],
                                     *m.pitch_diameter[part],
                                     part == Part::nut ? s.nut.outer_diameter : 0.0)
                     .total();
}

double axial_hertz_coefficient(double hertz_constant, double normal_angle) {
  return std::pow(hertz_constant, -2.0 / 3.0) * std::pow(std::cos(normal_angle), -5.0 / 3.0);
}

double thread_stiffness(double force, int threads, double coefficient, double tooth_compliance) {
  return threads / (coefficient / std::cbrt(force / threads) + tooth_compliance);
}

}  // namespace prs
