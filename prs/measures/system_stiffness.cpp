#include "prs/measures/system_stiffness.h"

#include <cmath>
#include <numbers>

#include "prs/sector/section_properties.h"

namespace prs {

SystemStiffness system_stiffness(double mechanism, const AxisParts& parts,
                                 const ShaftSection& s) {
  SystemStiffness system;
  double compliance = 0.0;
  const auto add = [&](std::string_view name, double stiffness) {
    system.contributions.push_back({name, stiffness});
    compliance += 1.0 / stiffness;
  };
  add("mechanism", mechanism);
  if (parts.shaft) {
    const AxisParts::Shaft& shaft = *parts.shaft;
    const double length = shaft.length, x = shaft.from_bearing.value_or(0.0);
    const double modulus = s.material.youngs_modulus;
    const double shear_modulus = modulus / (2.0 * (1.0 + s.material.poisson_ratio));
    const double polar =
        std::numbers::pi / 32.0 * (std::pow(s.diameter, 4) - std::pow(s.bore, 4));
    add("shaft", modulus * ring_area(s.diameter, s.bore) /
                     (shaft.from_bearing ? x * (length - x) / length : length));
    add("wind_up", shear_modulus * polar / shaft.torsion_length.value_or(length) *
                       std::pow(2.0 * std::numbers::pi / s.lead, 2));
  }
  if (parts.support_bearing) add("support_bearing", *parts.support_bearing);
  if (parts.housing) add("housing", *parts.housing);
  system.total = 1.0 / compliance;
  for (auto& c : system.contributions) c.share = system.total / c.stiffness;
  return system;
}

}  // namespace prs
