#pragma once

#include "prs/loads/result.h"
#include "prs/model/motor_duty.h"

/// Demand of a cycle of the axis on motor and brake.
namespace prs {

/// Torque at the turning part, in the sense of the motion, with the friction of a load case [N m]:
///
///     T = |F l|/(2 pi eta)  the screw drives,     -|F l| eta'/(2 pi)  the load drives
///
/// or, if the screw is self-locking, the torque that lowers the load. None without slip.
std::optional<double> screw_torque(const LoadCaseResult& r, double lead);

/// Torque for an efficiency of the driving side.
double screw_torque(double force, double lead, DrivenBy driven_by, double efficiency);

/// Demand on current and voltage of the equivalent direct-current motor, SI units:
///
///     I = T_M/K,   U = R I + K omega_M,   P = U I
struct ElectricDemand {
  double rms_current = 0.0, peak_current = 0.0;
  // Values that need a resistance.
  std::optional<double> peak_voltage = {}, copper_loss = {};
  std::optional<double> energy = {};         ///< Net energy of a cycle [J].
  std::optional<double> regenerated = {};    ///< Energy of a cycle that flows back, integral of -min(P, 0) [J].
  std::optional<double> voltage_speed = {};  ///< Motor's speed at which the supply's voltage drives the largest torque.
};

/// Demand of a cycle on the motor. SI units.
struct MotorDemand {
  std::vector<double> torque;  ///< Torque of the motor in each step [N m].
  double rms_torque = 0.0, peak_torque = 0.0, peak_power = 0.0, regenerated_mean = 0.0, regenerated_peak = 0.0;
  std::optional<ElectricDemand> electric;  ///< Present with a torque constant.
};

/// A step with its torque at the turning part [N m].
struct DrivenStep {
  MotorDuty::Step step;
  double torque = 0.0;
};

/// Torque at the motor in each step,
///
///     T_L = T + T_drag + J alpha,   T_M = T_L/(i eta_g), or T_L eta_g/i if T_L < 0,  + J_M i alpha
///
/// at rest 0 if it is held by a brake or by the screw itself, else |F l|/(2 pi i); `inertia` is that of the turning
/// part [kg m^2]. Rms over the whole cycle.
MotorDemand motor_demand(std::span<const DrivenStep> cycle, const DriveMotor& motor, double lead, double inertia,
                         double drag_torque, bool is_held);

}  // namespace prs
