#include "prs/measures/transmission.h"

#include "prs/threads/kinematics.h"

namespace prs {

using std::numbers::pi;

namespace {

/// pi d mu/l: tangent of the friction angle over that of the lead angle.
double friction_over_lead(double lead, double diameter, double friction) {
  return pi * diameter * friction / std::abs(lead);
}

}  // namespace

double velocity_ratio(double lead) { return std::abs(lead) / (2.0 * pi); }

PlanetaryRatios planetary_ratios(Mechanism::Type type, double gear_ratio) {
  KinematicGeometry g;
  g.type = type;
  g.gear_ratio = gear_ratio;
  const double slip_ratio = type == Mechanism::Type::standard
                                ? (1.0 - 2.0 * gear_ratio) / (2.0 * (1.0 - gear_ratio))
                                : 1.0 / (2.0 * (1.0 + gear_ratio));
  // With the nut at rest the carrier turns by the slip ratio.
  return {kinematics(g, 1.0, slip_ratio).roller_to_carrier + slip_ratio, slip_ratio};
}

PlanetaryRatios ratios_to_frame(Mechanism::Type type, const PlanetaryRatios& nut_at_rest) {
  const auto of = [&](double against_nut) {
    return against_frame(type == Mechanism::Type::standard, against_nut, 1.0) /
           turning_speed(type, 1.0);
  };
  return {of(nut_at_rest.roller), of(nut_at_rest.carrier)};
}

double efficiency(double lead, double diameter, double friction) {
  return 1.0 / (1.0 + friction_over_lead(lead, diameter, friction));
}

std::optional<double> back_driving_efficiency(double lead, double diameter, double friction) {
  const double efficiency = 1.0 - friction_over_lead(lead, diameter, friction);
  return efficiency > 0.0 ? std::optional(efficiency) : std::nullopt;
}

double drive_torque(double force, double lead, double efficiency) {
  return force * velocity_ratio(lead) / efficiency;
}

double roller_inertia(int rollers, double mass, double inertia, double centre_distance,
                      const PlanetaryRatios& to_frame) {
  const double orbit = centre_distance * to_frame.carrier;
  return rollers * (inertia * to_frame.roller * to_frame.roller + mass * orbit * orbit);
}

double travel_inertia(double mass, double lead) {
  const double ratio = velocity_ratio(lead);
  return mass * ratio * ratio;
}

}  // namespace prs
