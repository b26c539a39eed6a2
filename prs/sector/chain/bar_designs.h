#pragma once

#include "prs/sector/chain/bar_columns.h"
#include "prs/sector/chain/instruction_set.h"
#include "prs/sector/chain/thread_loads.h"
#include "prs/sector/chain/workspace.h"
#include "prs/sector/load_distribution.h"
#include "prs/sector/sector_model.h"

namespace prs {

/// Solves designs of `Bodies::bars` side by side: as many sectors as a batch has numbers in lock
/// step, each with its own convergence. Set-up of the sectors is part of it. A design's result does
/// not depend, bit for bit, on the other designs. Workspace is kept from call to call; one
/// solver a thread.
class BarDesignSolver {
 public:
  explicit BarDesignSolver(InstructionSet set = InstructionSet::best) : set_(set) {}

  /// Of Newton's method; force_scale, length_scale and reuse_factorization_below are not used. On
  /// slender rollers a residual of 1e-12 can leave 1e-10 in a thread's load.
  fe::NewtonOptions options{.residual_tolerance = 1e-13};
  bool tangent_stiffness = true;  ///< Whether results have it; a sweep of the threads less without.

  /// Designs of any mixture of thread counts, each under its axial force on the whole mechanism
  /// [N]; the results of refined ones stay.
  void solve(std::span<const SectorModel> sectors, std::span<const double> axial_forces,
             std::span<LoadDistribution> results);

 private:
  InstructionSet set_;
  Workspace workspace_;
  BarDesigns designs_;
  std::vector<std::size_t> order_;
  ThreadLoads loads_;
};

}  // namespace prs
