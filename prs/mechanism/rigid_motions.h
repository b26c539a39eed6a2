#pragma once

#include "prs/mechanism/full_structure.h"

namespace prs {

/// Motions of rigid parts that nothing resists: no contact, guide, bearing or spring.
struct FreeMotions {
  int count = 0;
  std::vector<std::string> parts;  ///< Those that move: screw, ring, roller 3.
};

/// The rows of contacts, constraints and springs over the rigid motions of the screw, of each
/// roller and of each floating ring, each row scaled to one and rotations taken in 1/r_R; the
/// motions are those of singular values below 1e-9 of the largest. `closed` tells which contacts
/// count, all where it is empty.
FreeMotions free_motions(const FullModel& model, const FullStructure& structure,
                         const std::vector<bool>& closed = {});

/// What no forces of contacts, which only push, and of guides, bearings and springs, which do both,
/// can take of the loads on the rigid parts: the smallest by least squares, moments over r_R, as a
/// share of the axial force. 0 where an equilibrium exists (Farkas).
double load_left(const FullModel& model, const FullStructure& structure);

/// The axial force from which on the rest of the load is held [N], up to a thousand times the given
/// one; absent where none holds it.
std::optional<double> holding_force(const FullModel& model);

/// What to tell of a mechanism and of a load that nothing holds.
std::string why_free(const FreeMotions& motions);
std::string why_not_held(const FullModel& model, const FullStructure& structure);

}  // namespace prs
