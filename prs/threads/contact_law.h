#pragma once

namespace prs {

/// Force law between the threads of one interface in the load distribution.
struct ContactLaw {
  double hertz_constant = 0.0;  ///< k_0 of N = k_0 delta^1.5 [N/m^1.5]
  double normal_angle = 0.0;    ///< psi, contact normal to axis [rad]
  double compliance = 0.0;      ///< Teeth, in series with the contact [m/N].
};

}  // namespace prs
