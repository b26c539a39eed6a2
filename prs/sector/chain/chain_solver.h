#pragma once

#include "prs/sector/chain/chain_sector.h"
#include "prs/sector/chain/thread_loads.h"
#include "prs/sector/chain/workspace.h"
#include "prs/sector/load_distribution.h"
#include "prs/sector/sector_model.h"

namespace prs {

/// Solves load after load on one sector, bars or refined, station by station along its threads:
/// the same model, start, convergence and results as `SectorSolver`, to 1e-10, several times
/// faster. Everything between contacts is condensed exactly. A solve allocates nothing once its
/// result has its size.
class ChainSolver {
 public:
  explicit ChainSolver(const SectorModel& model);

  /// Of Newton's method; force_scale, length_scale and reuse_factorization_below are not used. On
  /// slender rollers a residual of 1e-12 can leave 1e-10 in a thread's load.
  fe::NewtonOptions options{.residual_tolerance = 1e-13};

  /// Equilibrium under the axial force on the whole mechanism [N], > 0.
  LoadDistribution solve(double axial_force);

  /// The same into a result that keeps its memory.
  void solve(double axial_force, LoadDistribution& result);

 private:
  ChainSector sector_;
  Workspace workspace_;
  ThreadLoads loads_;
};

}  // namespace prs
