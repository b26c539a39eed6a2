#pragma once

#include <memory>
#include <span>

#include "fe/newton_types.h"
#include "prs/sector/chain/instruction_set.h"
#include "prs/sector/chain/thread_loads.h"
#include "prs/sector/load_distribution.h"
#include "prs/sector/sector.h"

namespace prs {

/// Solves load after load on one sector, bars or refined, station by station along its threads:
/// the same model, start, convergence and results as `SectorSolver`, to 1e-10, several times
/// faster. The numbers come from the sector's model; everything between contacts is condensed
/// exactly. A solve allocates nothing once its result has its size.
class ChainSolver {
 public:
  explicit ChainSolver(const Sector& sector, InstructionSet set = InstructionSet::best);
  ~ChainSolver();
  ChainSolver(ChainSolver&&) noexcept;
  ChainSolver& operator=(ChainSolver&&) noexcept;

  /// Of Newton's method; force_scale, length_scale and reuse_factorization_below are not used. On
  /// slender rollers a residual of 1e-12 can leave 1e-10 in a thread's load.
  fe::NewtonOptions options{.residual_tolerance = 1e-13};

  /// Equilibrium under the axial force on the whole mechanism [N], > 0.
  LoadDistribution solve(double axial_force);

  /// One load, into a result that keeps its memory.
  void solve(double axial_force, LoadDistribution& result);

  /// Many loads side by side; results[k] belongs to axial_forces[k] whatever their order. From the
  /// second batch on in ascending order, a solve starts from the extrapolation of those before it.
  void solve(std::span<const double> axial_forces, std::span<LoadDistribution> results);

  /// The same, as arrays.
  void solve(std::span<const double> axial_forces, const ThreadLoads& results);

  int contacts() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace prs
