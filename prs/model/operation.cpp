#include "prs/model/operation.h"

#include <cassert>

namespace prs {

namespace {

/// Kinematic viscosity [m^2/s] of a point.
double kinematic(const ViscosityPoint& point, double density) {
  return point.viscosity ? *point.viscosity / density : *point.kinematic_viscosity;
}

/// Dynamic viscosity [Pa s] at the operating temperature. The density, which two dynamic
/// viscosities may do without, only shifts the 0.7 mm^2/s of the line there: 10 % of it change the
/// result by less than 0.5 % between 40 and 100 degC and 20 K above where the points lie at these
/// two.
double viscosity_by_temperature(const Lubricant& l) {
  const double density = l.density.value_or(contact::kTypicalOilDensity);
  if (l.walther) return density * contact::kinematic_viscosity(*l.walther, *l.temperature);
  assert(l.viscosity_at.size() == 2);
  const ViscosityPoint &first = l.viscosity_at[0], &second = l.viscosity_at[1];
  const contact::WaltherLine line = contact::walther_line(
      first.temperature, kinematic(first, density), second.temperature, kinematic(second, density));
  return density * contact::kinematic_viscosity(line, *l.temperature);
}

}  // namespace

contact::Lubricant in_operation(const Lubricant& lubricant) {
  assert(lubricant.viscosity.has_value() != lubricant.temperature.has_value());
  return {
      .viscosity = lubricant.viscosity ? *lubricant.viscosity : viscosity_by_temperature(lubricant),
      .pressure_viscosity = lubricant.pressure_viscosity,
      .eyring_stress = lubricant.eyring_stress};
}

}  // namespace prs
