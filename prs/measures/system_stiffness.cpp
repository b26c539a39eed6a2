#include "prs/measures/system_stiffness.h"

#include "prs/sector/section_properties.h"

namespace prs {

SystemStiffness system_stiffness(double mechanism, const MeasureOptions::System& system,
                                 const ShaftSection& section, const Material& material,
                                 double lead) {
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
    const double polar =
        std::numbers::pi / 32.0 * (std::pow(section.diameter, 4) - std::pow(section.bore, 4));
    add(c.shaft, modulus * ring_area(section.diameter, section.bore) /
                     (shaft.from_bearing ? x * (length - x) / length : length));
    add(c.wind_up, shear_modulus * polar / shaft.torsion_length.value_or(length) *
                       std::pow(2.0 * std::numbers::pi / lead, 2));
  }
  if (system.support_bearing) add(c.support_bearing, *system.support_bearing);
  if (system.housing) add(c.housing, *system.housing);
  found.total = 1.0 / compliance;
  for (auto* part : {&c.mechanism, &c.shaft, &c.wind_up, &c.support_bearing, &c.housing})
    if (*part) (*part)->share = found.total / (*part)->stiffness;
  return found;
}

}  // namespace prs
