#pragma once

#include "prs/loads/result.h"
#include "prs/model/motor_duty.h"

/// What a cycle of the axis asks of motor and brake.
namespace prs {

/// Torque at the part that turns, in the sense of the motion, with the friction of a load case [N m]:
///
///     T = |F l|/(2 pi eta)  the screw drives,     -|F l| eta'/(2 pi)  the load drives
///
/// or, where the screw locks itself, the torque that lowers the load. None without slip.
std::optional<double> screw_torque(const LoadCaseResult& r, double lead);

/// The same for an efficiency of the side that drives.
double screw_torque(double force, double lead, DrivenBy driven_by, double efficiency);

/// What a cycle asks of the motor. SI units.
struct MotorDemand {
  std::vector<double> torque;  ///< At the motor in each step [N m].
  double rms_torque = 0.0, peak_torque = 0.0, peak_power = 0.0, regenerated_mean = 0.0, regenerated_peak = 0.0;
};

/// A step with its torque at the part that turns [N m].
struct DrivenStep {
  MotorDuty::Step step;
  double torque = 0.0;
};

/// Torque at the motor in each step,
///
///     T_L = T + T_drag + J alpha,   T_M = T_L/(i eta_g), or T_L eta_g/i where T_L < 0,  + J_M i alpha
///
/// at rest 0 where it is held by a brake or by the screw itself, else |F l|/(2 pi i); `inertia` is that of the part
/// that turns [kg m^2]. Rms over the whole cycle.
MotorDemand motor_demand(std::span<const DrivenStep> cycle, const DriveMotor& motor, double lead, double inertia,
                         double drag_torque, bool is_held);

}  // namespace prs
