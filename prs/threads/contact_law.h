#pragma once

#include <cmath>

namespace prs {

/// Force law between the threads of one interface in the load distribution.
struct ContactLaw {
  double hertz_constant = 0.0;  ///< k_0 of N = k_0 delta^1.5 [N/m^1.5]
  double normal_angle = 0.0;    ///< psi, contact normal to axis [rad]
  double compliance = 0.0;      ///< Compliance of the teeth, in series with the contact [m/N].
};

/// A law with values derived from it, for designs side by side.
struct ContactLawNumbers : ContactLaw {
  double cosine = 1.0, sine = 0.0;  ///< Cosine and sine of psi.
  double cbrt_constant = 0.0;       ///< k_0^(1/3) [N^(1/3)/m^(1/2)]
};

inline ContactLawNumbers numbers_of(const ContactLaw& law) {
  return {law, std::cos(law.normal_angle), std::sin(law.normal_angle), std::cbrt(law.hertz_constant)};
}

}  // namespace prs
