#include "prs/threads/kinematics.h"

namespace prs {

double turning_speed(Mechanism::Type type, double speed) {
  const bool screw_turns = carrier_part(type) == Part::nut;
  return against_frame(screw_turns, screw_turns ? speed : 0.0, speed);
}

double ideal_slip_ratio(const KinematicGeometry& g) {
  if (contact::is_grooved(g.type)) return slip_estimates(g).simple;
  // The sliding velocity is linear in the slip ratio: v = v_0 + epsilon v'.
  const Interface i = sliding_interface(g.type);
  const auto at_0 = contact_motion(g, kinematics(g, 1.0, 0.0), i).sliding;
  const auto rate = contact_motion(g, kinematics(g, 1.0, 1.0), i).sliding - at_0;
  return -at_0.dot(rate) / rate.dot(rate);
}

SlipEstimates slip_estimates(const KinematicGeometry& g) {
  const double gamma = g.gear_ratio;
  if (!g.carrier_on_nut()) return {1.0 / (2.0 * (1.0 + gamma)), std::nullopt};
  const double simple = (1.0 - 2.0 * gamma) / (2.0 * (1.0 - gamma));
  if (contact::is_grooved(g.type)) return {simple, std::nullopt};
  const double c = g.centre_distance, k = 1.0 / gamma - 1.0;
  const contact::Vector2<double>& on_screw = g.points.screw;
  const contact::Vector2<double> on_roller{on_screw.x - c, on_screw.y};
  const double jones = (c * on_screw.x - k * on_roller.dot(on_screw)) /
                       (k * k * on_roller.dot(on_roller) + c * c - 2.0 * c * k * on_roller.x);
  return {simple, jones};
}

SlipRange slip_range(const KinematicGeometry& g) { return {g.carrier_on_nut() ? 0.0 : 1.0, ideal_slip_ratio(g)}; }

double optimality(const SlipRange& range, double slip_ratio) {
  return std::abs(slip_ratio - range.pure_sliding) / std::abs(range.ideal - range.pure_sliding);
}

}  // namespace prs
