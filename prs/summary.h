#pragma once

#include <string>
#include <vector>

#include "prs/case.h"

namespace prs {

/// What follows from the mechanism's input alone. SI units.
struct MechanismSummary {
  double axial_pitch = 0.0;     ///< |lead|/starts of the screw [m]
  double contact_length = 0.0;  ///< From the first to the last contact of a roller [m]
  PerPart<double> helix_angle;  ///< At the pitch radius [rad], sign of the hand.
  double roller_spacing = 0.0;  ///< Distance of neighbouring roller axes [m]
  int rollers_that_fit = 0;     ///< Largest number of rollers whose crests do not touch.
};

/// Of a mechanism that is `resolved`.
MechanismSummary summarize(const Mechanism& mechanism);

/// What is possible and unusual in a case with a `resolved` mechanism: each a sentence with the
/// numbers.
std::vector<std::string> unusual_geometry(const Case& c);

}  // namespace prs
