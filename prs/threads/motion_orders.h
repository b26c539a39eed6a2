#pragma once

#include "prs/model/load_case.h"
#include "prs/model/mechanism.h"

namespace prs {

/// Slip ratio d_S/(d_S + d_N), or the stated one; the mechanism must be complete.
double slip_ratio(const Mechanism& mechanism, const Travel& travel);

/// A motion of the mechanism that repeats this many times per turn of the screw against the nut.
struct MotionOrder {
  std::string_view name;
  double order = 0.0;
};

/// Orders of the parts' motions at a slip ratio epsilon: turn 1, carrier epsilon, carrier on the screw 1 - epsilon,
/// spin of the rollers against the carrier, rollers past nut and screw.
std::vector<MotionOrder> motion_orders(const Mechanism& mechanism, double slip_ratio);

/// Number of turns, up to 1,000, after which all repeats that does not depend on places along the parts.
std::optional<int> turns_until_repeat(const Mechanism& mechanism, double slip_ratio);

}  // namespace prs
