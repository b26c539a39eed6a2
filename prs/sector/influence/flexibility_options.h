#pragma once

#include "prs/model/model_options.h"
#include "prs/sector/influence/grooved_body.h"

namespace prs {

/// How exactly the flexibility of the bodies is worked out.
struct FlexibilityOptions {
  MeshDensity mesh;
  /// Harmonics are summed by finite elements up to n a_t/r = this; beyond, the body is taken as a
  /// half-space and its harmonics are added in closed form. More is not better on a coarse mesh,
  /// which represents the short waves worse than the closed form does.
  double largest_wave = 1.0;
  /// A harmonic is followed along the body until it has decayed to this share.
  double block_tolerance = 1e-3;
  /// Cells across the patches of the neighbours, which only feel a harmonic.
  int neighbour_patch_cells = 2;
  /// The thrust face of the nut pushes only; parts of it that would pull are let go.
  bool unilateral_thrust = true;
};

/// Options of an accuracy: `working` are the defaults.
inline FlexibilityOptions flexibility_options(ModelOptions::Accuracy accuracy) {
  FlexibilityOptions options;
  if (accuracy == ModelOptions::Accuracy::reference) {
    options.mesh.patch_cells = 4;
    options.mesh.split = 2;
  }
  return options;
}

}  // namespace prs
