#pragma once

#include "prs/threads/tooth_compliance.h"

namespace prs {

/// Nominal stresses at the root of a thread tooth, a cantilever of the root's width a under an
/// axial load F [N] at the pitch line, the height c above the root, over `width` w of thread [m]:
///
///     shear    tau = F/(a w)            mean over the root
///     bending  sigma = 6 F c/(a^2 w)    at the root's surface
///
/// as handbooks have it for power screws. The radial part of the contact load, which relieves the
/// loaded side, and the notch at the root are left out; teeth of roller screws are shorter than
/// wide (c < a), where beams give no more than an order of magnitude and shear rules. What width a
/// point contact loads, theory does not say.
struct RootStress {
  double shear = 0.0;    ///< [Pa]
  double bending = 0.0;  ///< [Pa]
};

inline RootStress root_stress(const ToothSection& tooth, double axial_load, double width) {
  const double area = tooth.root_width * width;
  return {axial_load / area, 6.0 * axial_load * tooth.height / (area * tooth.root_width)};
}

}  // namespace prs
