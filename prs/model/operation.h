#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "contact/journal_bearing.h"
#include "contact/lubricant.h"
#include "contact/viscosity.h"

namespace prs {

/// Viscosity at one temperature, dynamic or kinematic.
struct ViscosityPoint {
  double temperature = 0.0;                   ///< [K]
  std::optional<double> viscosity;            ///< [Pa s]
  std::optional<double> kinematic_viscosity;  ///< [m^2/s]
};

/// Lubricant as a data sheet states it. Its viscosity is that at operating temperature, or follows
/// from the temperature by a Walther line: given, or through two points.
struct Lubricant {
  std::optional<double> viscosity;    ///< eta_0 at operating temperature [Pa s]
  double pressure_viscosity = 0.0;    ///< alpha [1/Pa]
  double eyring_stress = 0.0;         ///< tau_0 [Pa]
  std::optional<double> temperature;  ///< In operation [K].
  std::vector<ViscosityPoint> viscosity_at;
  std::optional<contact::WaltherLine> walther;
  std::optional<double> density;  ///< Density, from kinematic to dynamic viscosity [kg/m^3].
};

/// The lubricant at its operating temperature. The case must have passed `check_case`.
contact::Lubricant in_operation(const Lubricant& lubricant);

struct Friction {
  enum class Model { jacod, coulomb };
  Model model = Model::jacod;
  double coefficient = 0.0;  ///< Coulomb only.
};

struct Operation {
  double speed = 0.0;  ///< Screw against nut [rad/s]; sign with the force as in Sandu (3.2).
  std::optional<double> slip_ratio;  ///< Imposed; else from the roller's equilibrium.
};

/// What acts on the rollers besides the threads. Torques are resisting magnitudes [N m].
struct Carrier {
  double roller_torque = 0.0;  ///< C_P/R, both heads of one roller.
  double screw_torque = 0.0;   ///< C_P/S
  double nut_torque = 0.0;     ///< C_P/N
  /// The two heads of a roller in the carrier; in place of `roller_torque`.
  std::optional<contact::JournalBearing> bearing;
  double gear_pressure_angle = std::numbers::pi / 9;  ///< alpha_g [rad]
};

}  // namespace prs
