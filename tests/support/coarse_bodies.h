#pragma once

#include "prs/sector/influence/grooved_body.h"

namespace test {

/// Meshes for tests of properties that do not depend on them.
inline prs::FlexibilityOptions coarse_bodies() {
  prs::FlexibilityOptions options;
  options.mesh.patch_cells = 2;
  options.mesh.growth = 2.0;
  options.mesh.step_cell = 0.1;
  options.mesh.plain_flank_cells = 1;
  return options;
}

}  // namespace test
