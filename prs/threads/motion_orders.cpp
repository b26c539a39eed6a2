#include "prs/threads/motion_orders.h"

#include <cmath>

namespace prs {
namespace {

/// Share of a turn within which positions are the same.
constexpr double kSamePosition = 1e-9;

double spin_order(const Mechanism& m, double slip_ratio) {
  return (carrier_part(m.type) == Part::nut ? slip_ratio : 1.0 - slip_ratio) / gear_ratio(m);
}

}  // namespace

double slip_ratio(const Mechanism& m, const Travel& t) {
  const auto& d = m.pitch_diameter;
  return std::isnan(t.stated_slip_ratio) ? *d.screw / (*d.screw + *d.nut) : t.stated_slip_ratio;
}

std::vector<MotionOrder> motion_orders(const Mechanism& m, double epsilon) {
  return {{"turn", 1.0},
          {"carrier", epsilon},
          {"carrier_on_screw", 1.0 - epsilon},
          {"roller_spin", spin_order(m, epsilon)},
          {"rollers_past_nut", m.rollers * epsilon},
          {"rollers_past_screw", m.rollers * (1.0 - epsilon)}};
}

std::optional<int> turns_until_repeat(const Mechanism& m, double epsilon) {
  const auto whole = [](double x) { return std::abs(x - std::round(x)) <= kSamePosition; };
  for (int turns = 1; turns <= 1000; ++turns)
    if (whole(turns * epsilon) && whole(turns * spin_order(m, epsilon))) return turns;
  return std::nullopt;
}

}  // namespace prs
