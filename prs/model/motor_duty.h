#pragma once

#include "prs/model/case.h"
#include "prs/model/problems.h"

namespace prs {

/// A motor at the turning part, with its gear. SI units; a motor without a limit has no criterion.
struct DriveMotor {
  std::optional<double> rated_torque, peak_torque;  ///< [N m]
  std::optional<double> largest_speed;              ///< [rad/s]
  double inertia = 0.0;                             ///< Inertia at the motor's shaft, gear included [kg m^2].
  double gear_ratio = 1.0;                          ///< Turns of the motor per turn of the screw.
  double gear_efficiency = 1.0;
  std::optional<double> torque_constant;     ///< Constant K of the equivalent direct-current motor [N m/A].
  std::optional<double> resistance;          ///< Resistance of its winding [Ohm].
  std::optional<double> continuous_current;  ///< Largest rms current [A].
  struct Supply {
    std::optional<double> voltage, current;  ///< Largest magnitudes [V], [A].
  };
  Supply supply;
};

/// Contradictions between the values of a motor under `motor`.
std::vector<Problem> check_drive_motor(const DriveMotor& motor);

enum class BackDriving { allowed, required, forbidden };

/// One cycle of the axis that the screw drives, and the limits of motor and brake. SI units.
struct MotorDuty {
  /// Constant acceleration, > 0 in the positive sense.
  struct Step {
    std::optional<std::string> load_case;  ///< Load case whose friction the step has; none: at rest or without force.
    double duration = 0.0;                 ///< [s]
    double start_speed = 0.0, end_speed = 0.0;  ///< Speed along the axis [m/s].
    double force = 0.0;  ///< Axial force on the screw, > 0 if it pushes in the positive sense [N].

    double travel() const { return 0.5 * (start_speed + end_speed) * duration; }
    double largest_speed() const { return std::max(std::abs(start_speed), std::abs(end_speed)); }
  };
  DriveMotor motor;
  std::optional<double> brake_torque;  ///< Torque that holds the axis at rest, at the motor's shaft [N m].
  double brake_safety = 1.5;           ///< Least brake torque over the torque of the largest force at rest.
  double drag_torque = 0.0;            ///< Torque against the motion, at the turning part [N m].
  double holding_force = 0.0;          ///< Largest force at rest [N].
  BackDriving back_driving = BackDriving::allowed;
  std::optional<std::string> driven_back;  ///< Back-driven load case, if the screw is not self-locking.
  std::vector<Step> cycle;
};

/// Contradictions between the motor's block and the rest of a case.
std::vector<Problem> check_motor(const MotorDuty& duty, const Conditions& c);

}  // namespace prs
