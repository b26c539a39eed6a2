#include "prs/losses/motor_demand.h"

namespace prs {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

}  // namespace

double screw_torque(double force, double lead, DrivenBy driven_by, double efficiency) {
  return (driven_by == DrivenBy::screw ? 1.0 / efficiency : -efficiency) * force * lead / kTurn;
}

std::optional<double> screw_torque(const LoadCaseResult& r, double lead) {
  if (!r.slip || !r.slip->converged()) return std::nullopt;
  if (r.slip->efficiency) return screw_torque(r.load_case.axial_force, lead, r.slip->driven_by, *r.slip->efficiency);
  return r.slip->driven_by == DrivenBy::load ? r.slip->holding_torque : std::nullopt;
}

MotorDemand motor_demand(std::span<const DrivenStep> cycle, const DriveMotor& motor, double lead, double inertia,
                         double drag_torque, bool is_held) {
  const double ratio = motor.gear_ratio, gear = motor.gear_efficiency;
  // Speeds of the screw and the motor over that of the axis.
  const double per_speed = kTurn / lead, speed = per_speed * ratio;
  MotorDemand demand;
  double square = 0.0, duration = 0.0, mean_back = 0.0;
  for (const auto& [step, screw] : cycle) {
    const double travel = step.travel();
    double torque = 0.0;
    if (travel == 0.0) {
      if (!is_held) torque = std::abs(step.force) / speed;
    } else {
      const double alpha = per_speed * (step.end_speed - step.start_speed) / step.duration * std::copysign(1.0, travel);
      const double at_screw = screw + drag_torque + inertia * alpha;
      torque = (at_screw >= 0.0 ? at_screw / (ratio * gear) : at_screw * gear / ratio) + motor.inertia * ratio * alpha;
    }
    demand.torque.push_back(torque);
    duration += step.duration;
    square += torque * torque * step.duration;
    demand.peak_torque = std::max(demand.peak_torque, std::abs(torque));
    demand.peak_power = std::max(demand.peak_power, std::abs(torque) * speed * step.largest_speed());
    if (torque >= 0.0) continue;
    mean_back -= torque * speed * std::abs(travel);
    demand.regenerated_peak = std::max(demand.regenerated_peak, -torque * speed * step.largest_speed());
  }
  demand.rms_torque = std::sqrt(square / duration);
  demand.regenerated_mean = mean_back / duration;
  return demand;
}

}  // namespace prs
