#include "contact/journal_bearing.h"

#include <cassert>
#include <cmath>

#include "contact/journal_bearing_formulas.h"

namespace contact {

JournalBearingState short_bearing(const JournalBearing& bearing, double viscosity, double speed,
                                  double load) {
  assert(bearing.length > 0.0 && bearing.diameter > 0.0 && bearing.radial_clearance > 0.0);
  assert(viscosity > 0.0 && load >= 0.0);
  const auto [eccentricity, torque] =
      short_bearing_of<double, double>({bearing.length, bearing.diameter, bearing.radial_clearance},
                                       viscosity, std::abs(speed), load);
  return {eccentricity, torque};
}

}  // namespace contact
