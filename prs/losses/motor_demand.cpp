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
  if (r.load_case.axial_force == 0.0) return r.slip->power.total() / std::abs(r.slip->speed);
  if (r.slip->efficiency) return screw_torque(r.load_case.axial_force, lead, r.slip->driven_by, *r.slip->efficiency);
  return r.slip->driven_by == DrivenBy::load ? r.slip->holding_torque : std::nullopt;
}

namespace {

/// Integral of -min(P, 0) over a time in which P goes from one value to another in a straight line.
double energy_back(double from, double to, double time) {
  if (from >= 0.0 && to >= 0.0) return 0.0;
  if (from <= 0.0 && to <= 0.0) return -0.5 * (from + to) * time;
  const double least = std::min(from, to);
  return 0.5 * least * least / std::abs(to - from) * time;
}

/// Currents, voltages and energies for the torques of a cycle; `speed` is that of the motor over that of the axis.
ElectricDemand electric_demand(std::span<const DrivenStep> cycle, const DriveMotor& motor, double speed,
                               const MotorDemand& demand) {
  const double k = *motor.torque_constant;
  ElectricDemand e{.rms_current = demand.rms_torque / k, .peak_current = demand.peak_torque / k};
  if (!motor.resistance) return e;
  const double r = *motor.resistance;
  double voltage = 0.0, loss = 0.0, energy = 0.0, back = 0.0, duration = 0.0, largest = 0.0;
  for (std::size_t j = 0; j < cycle.size(); ++j) {
    const MotorDuty::Step& step = cycle[j].step;
    const double torque = demand.torque[j], current = torque / k, copper = r * current * current;
    const bool moves = step.travel() != 0.0;
    double power[2];
    for (int end = 0; end < 2; ++end) {
      const double turning = moves ? speed * std::abs(end == 0 ? step.start_speed : step.end_speed) : 0.0;
      voltage = std::max(voltage, std::abs(r * current + k * turning));
      power[end] = copper + torque * turning;
    }
    loss += copper * step.duration;
    energy += 0.5 * (power[0] + power[1]) * step.duration;
    back += energy_back(power[0], power[1], step.duration);
    duration += step.duration;
    if (moves) largest = std::max(largest, torque);
  }
  e.peak_voltage = voltage;
  e.copper_loss = loss / duration;
  e.energy = energy;
  e.regenerated = back;
  if (motor.supply.voltage) e.voltage_speed = std::max(0.0, (*motor.supply.voltage - r * largest / k) / k);
  return e;
}

}  // namespace

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
  if (motor.torque_constant) demand.electric = electric_demand(cycle, motor, speed, demand);
  return demand;
}

}  // namespace prs
