#pragma once

#include "prs/model/case.h"
#include "prs/model/problems.h"

namespace prs {

/// A motor at the part that turns, with its gear. SI units; without a limit there is no criterion.
struct DriveMotor {
  std::optional<double> rated_torque, peak_torque;  ///< [N m]
  std::optional<double> largest_speed;              ///< [rad/s]
  double inertia = 0.0;                             ///< At its shaft, with its gear [kg m^2].
  double gear_ratio = 1.0;                          ///< Its turns per turn of the screw.
  double gear_efficiency = 1.0;
};

/// Why the peak torque of a motor cannot be; empty of a sound one.
std::string wrong_peak_torque(const DriveMotor& motor);

enum class BackDriving { allowed, required, forbidden };

/// One cycle of the axis that the screw drives, and the limits of motor and brake. SI units.
struct MotorDuty {
  /// Constant acceleration, > 0 in the positive sense.
  struct Step {
    std::optional<std::string> load_case;       ///< Whose friction it has; none: at rest or without force.
    double duration = 0.0;                      ///< [s]
    double start_speed = 0.0, end_speed = 0.0;  ///< Along the axis [m/s].
    double force = 0.0;                         ///< Axial, on the screw, > 0 where it pushes in the positive sense [N].

    double travel() const { return 0.5 * (start_speed + end_speed) * duration; }
    double largest_speed() const { return std::max(std::abs(start_speed), std::abs(end_speed)); }
  };
  DriveMotor motor;
  std::optional<double> brake_torque;  ///< Holds the axis at rest, at the motor's shaft [N m].
  double drag_torque = 0.0;            ///< Against the motion, at the part that turns [N m].
  double holding_force = 0.0;          ///< Largest at rest [N].
  BackDriving back_driving = BackDriving::allowed;
  std::optional<std::string> driven_back;  ///< Load case that the load drives, if the screw does not lock itself.
  std::vector<Step> cycle;
};

/// What the motor's block of a case contradicts.
std::vector<Problem> check_motor(const MotorDuty& duty, const Conditions& c);

}  // namespace prs
