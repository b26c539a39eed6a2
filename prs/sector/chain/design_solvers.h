#pragma once

#include "prs/sector/chain/chain_solver.h"
#include "prs/sector/chain/refined_kernel.h"
#include "prs/sector/chain/sector_kernel.h"
#include "simd/instruction_set.h"

namespace prs {

using simd::InstructionSet, simd::available, simd::batch_size, simd::name;

/// Solves designs of `kBars` side by side: as many sectors as a batch has numbers in lock
/// step, each with its own convergence. Set-up of the sectors is part of it. A design's result does
/// not depend, bit for bit, on the other designs. Workspace is kept from call to call; one
/// solver per thread.
class BarDesignSolver {
 public:
  explicit BarDesignSolver(InstructionSet set = InstructionSet::best) : set_(set) {}

  /// Options of Newton's method; force_scale, length_scale and reuse_factorization_below are not used. On
  /// slender rollers a residual of 1e-12 can leave 1e-10 in a thread's load.
  fe::NewtonOptions options{.residual_tolerance = 1e-13};
  /// Whether to compute the tangent stiffness, which costs one more sweep of the threads.
  bool tangent_stiffness = true;

  /// Solves designs with any mixture of thread counts, each under its axial force on the whole mechanism [N]; results
  /// of refined designs are not touched.
  void solve(std::span<const SectorModel> sectors, std::span<const double> axial_forces,
             std::span<LoadDistribution> results);

 private:
  InstructionSet set_;
  Workspace workspace_;
  BarDesigns designs_;
  std::vector<std::size_t> order_;
  ThreadLoads loads_;
};

/// Solves designs of `kRefined` side by side, from the numbers of their bodies to the loads
/// of their threads, as BarDesignSolver does those of bars. Sectors come from `set_sector_model`;
/// `work_out` need not be called. A design's result does not depend, bit for bit, on the other
/// designs. Workspace is kept from call to call; one solver per thread.
class RefinedDesignSolver {
 public:
  explicit RefinedDesignSolver(InstructionSet set = InstructionSet::best) : set_(set) {}

  /// Options of Newton's method, see BarDesignSolver.
  fe::NewtonOptions options{.residual_tolerance = 1e-13};
  bool tangent_stiffness = true;

  /// Whether a sector can be solved here: one with a nut of shells whose roller's contacts stand opposite each other.
  static bool takes(const SectorModel& s) { return s.is_refined && s.bodies.has_shell() && !s.contacts_apart(); }

  /// Solves the designs that `takes` allows; results of others are not touched.
  void solve(std::span<const SectorModel> sectors, std::span<const double> axial_forces,
             std::span<LoadDistribution> results);

 private:
  /// Solves `sectors_`, whose kind is that of `first`.
  void solve_side_by_side(const SectorModel& first);

  InstructionSet set_;
  Workspace workspace_;
  std::vector<std::size_t> order_;
  std::vector<RefinedSector> sectors_;
  std::vector<double> forces_;
  std::vector<int> segment_of_;
  ThreadLoads loads_;
};

}  // namespace prs
