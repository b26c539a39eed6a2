#pragma once

#include <optional>

namespace prs {

/// Lubricant at operating temperature. SI units.
struct Lubricant {
  double viscosity = 0.0;           ///< eta_0 [Pa s]
  double pressure_viscosity = 0.0;  ///< alpha_B [1/Pa]
  double eyring_stress = 0.0;       ///< tau_0 [Pa]
};

struct Friction {
  enum class Model { jacod, coulomb };
  Model model = Model::jacod;
  double coefficient = 0.0;  ///< Coulomb only.
};

struct Operation {
  double speed = 0.0;  ///< Screw against nut [rad/s]; sign with the force as in Sandu (3.2).
};

/// Imposed resisting torques on the carrier, magnitudes [N m].
struct Carrier {
  double roller_torque = 0.0;
  double screw_torque = 0.0;
  double nut_torque = 0.0;
};

}  // namespace prs
