#pragma once

#include "prs/bodies/body_solver.h"

namespace prs {

// Models of all rollers for kOneDimensional and kMeshed.

std::unique_ptr<RollersOnBodies> rollers_on_beams(const LoadedMechanism& of, const MakeModel& model,
                                                  FullSolver& solver);
std::unique_ptr<RollersOnBodies> rollers_on_meshes(const LoadedMechanism& of, const MakeModel& model,
                                                   FullSolver& solver);

}  // namespace prs
