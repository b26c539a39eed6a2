#pragma once

#include <string_view>
#include <vector>

#include "prs/size/requirement.h"

namespace prs {

/// The load case that the load drives, of every written case.
inline constexpr std::string_view kBackDriving = "back-driving";

/// Segments cut where the speed changes its sign, with their axial forces on the screw
///
///     F = m a + m g sin(theta) + sgn (mu m g |cos(theta)| + f) + F_ext,    at rest sgn = 0
///
/// (THK general catalogue, axial loads), and what follows from them: the cubic mean load over
/// travel, speeds, the holding force. More than 60 are put into classes by senses, 12 steps of
/// force and 8 of speed.
MotionCycle cycle_of(std::vector<MotionSegment> segments, const Requirement& r);

}  // namespace prs
