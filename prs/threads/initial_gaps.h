#pragma once

#include "prs/model/deviations.h"
#include "prs/model/load_case.h"
#include "prs/model/materials.h"
#include "prs/model/mechanism.h"

namespace prs {

/// Offsets of a part's threads from their nominal place, one per contact [m].
struct ThreadOffsets {
  std::vector<double> axial;   ///< a_k, away from the loaded end of the screw.
  std::vector<double> radial;  ///< rho_k of the pitch radius.
};

/// Those that `initial_gaps` is made of: measured pitch, pitch error, expansion, diameter,
/// crowning, relief.
ThreadOffsets thread_offsets(const Mechanism& mechanism, const Deviations& deviations,
                             const Materials& materials, Part part);

/// Gaps of an interface, the smallest not taken off [m].
std::vector<double> gaps_between(const ThreadOffsets& body, const ThreadOffsets& roller,
                                 Interface i, double normal_angle, Direction direction);

/// Whether anything sets a thread of one sector off its nominal place; else all gaps are 0.
bool deviates(const Mechanism& mechanism, const Deviations& deviations);

/// Initial gaps of the threads along their contact normals for one direction of the load, the
/// closest thread of each interface touching [m]. With axial offsets a_k of the threads (measured
/// pitch, pitch error, expansion), away from the loaded end, and radial offsets rho_k of their
/// pitch radii (diameter, crowning, relief, expansion):
///
///     screw  g = -s cos(psi)(a_S - a_R) - sin(psi)(rho_S + rho_R),
///     nut    g = -s cos(psi)(a_R - a_N) - sin(psi)(rho_R - rho_N),
///
/// s = -1 in tension, +1 in compression, less the smallest of each interface, which a rigid motion
/// takes up. Materials must state their expansion where a temperature differs.
PerInterface<std::vector<double>> initial_gaps(const Mechanism& mechanism,
                                               const Deviations& deviations,
                                               const Materials& materials,
                                               const PerInterface<double>& normal_angle,
                                               Direction direction);

}  // namespace prs
