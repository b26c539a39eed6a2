#pragma once

#include "prs/model/load_case.h"
#include "prs/model/mechanism.h"

namespace prs {

/// d_S/(d_S + d_N), or what is stated; the mechanism must be complete.
double slip_ratio(const Mechanism& mechanism, const Travel& travel);

/// A motion of the mechanism that comes back so many times in a turn of the screw against the nut.
struct MotionOrder {
  std::string_view name;
  double order = 0.0;
};

/// Orders of the parts' motions, of a slip ratio epsilon: turn 1, carrier epsilon, carrier on the
/// screw 1 - epsilon, spin of the rollers against the carrier, rollers past nut and screw.
std::vector<MotionOrder> motion_orders(const Mechanism& mechanism, double slip_ratio);

/// Turns up to 1,000 after which all that does not depend on places along the parts repeats.
std::optional<int> turns_until_repeat(const Mechanism& mechanism, double slip_ratio);

}  // namespace prs
