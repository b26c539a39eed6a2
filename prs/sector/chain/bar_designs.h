#pragma once

#include <memory>
#include <span>

#include "fe/newton_types.h"
#include "prs/sector/chain/bar_columns.h"
#include "prs/sector/chain/instruction_set.h"
#include "prs/sector/chain/thread_loads.h"
#include "prs/sector/load_distribution.h"
#include "prs/sector/sector_model.h"

namespace prs {

/// Solves designs of `Bodies::bars` side by side: as many sectors as a batch has numbers in lock
/// step, each with its own convergence. Set-up of the sectors is part of it. A design's result does
/// not depend, bit for bit, on the designs beside it. Workspace is kept from call to call; one
/// solver a thread.
class BarDesignSolver {
 public:
  explicit BarDesignSolver(InstructionSet set = InstructionSet::best);
  ~BarDesignSolver();
  BarDesignSolver(BarDesignSolver&&) noexcept;
  BarDesignSolver& operator=(BarDesignSolver&&) noexcept;

  /// Of Newton's method; force_scale, length_scale and reuse_factorization_below are not used. On
  /// slender rollers a residual of 1e-12 can leave 1e-10 in a thread's load.
  fe::NewtonOptions options{.residual_tolerance = 1e-13};

  /// Designs of any mixture of thread counts under the axial force on the whole mechanism [N]. With
  /// m times as many forces as designs, those of design k are m k .. m k + m - 1: each starts from
  /// the extrapolation of those before it, as far as they ascend.
  void solve(std::span<const SectorModel> sectors, std::span<const double> axial_forces,
             std::span<LoadDistribution> results);

  /// The same into arrays, `results.stride` >= the largest number of contacts.
  void solve(std::span<const SectorModel> sectors, std::span<const double> axial_forces,
             const ThreadLoads& results);

  /// Arrays in, arrays out, several loads a design: no allocation, no copy.
  void solve(const BarDesigns& designs, const ThreadLoads& results);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace prs
