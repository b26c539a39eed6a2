#pragma once

#include <string>
#include <vector>

#include "prs/sector/full/full_structure.h"

namespace prs {

/// Motions of rigid parts that nothing resists: no contact, guide, bearing or spring.
struct FreeMotions {
  int count = 0;
  std::vector<std::string> parts;  ///< Those that move: screw, ring, roller 3.
};

/// The rows of contacts, constraints and springs over the rigid motions of the screw, of each roller
/// and of each floating ring, each row scaled to one and rotations taken in 1/r_R; the motions are
/// those of singular values below 1e-9 of the largest. `closed` tells which contacts count, all
/// where it is empty.
FreeMotions free_motions(const FullModel& model, const FullStructure& structure,
                         const std::vector<bool>& closed = {});

/// What is left of a load that no pushing contacts hold: the loads on the rigid parts less what
/// contacts, which only push, and constraints, which do both, can take, by least squares. Forces
/// in N, moments about the loaded section in N m over the centre distance.
struct LoadLeft {
  double share = 0.0;                    ///< Of the axial force.
  std::optional<double> axial_force;     ///< With which the rest of the load could be held [N].
};
// LoadLeft load_left(const FullModel& model, const FullStructure& structure);

}  // namespace prs
