#pragma once

#include <new>

#include "prs/sector/chain/chain_sector.h"
#include "prs/sector/chain/thread_loads.h"
#include "prs/sector/sector.h"

namespace prs {

/// Memory for a kernel, aligned for the widest batch; grows, never shrinks.
class Workspace {
 public:
  /// Returns memory for at least `numbers` numbers.
  double* reserve(std::size_t numbers) {
    if (numbers > size_) {
      memory_.reset(static_cast<double*>(::operator new(numbers * sizeof(double), kAlignment)));
      size_ = numbers;
    }
    return memory_.get();
  }

 private:
  static constexpr std::align_val_t kAlignment{64};
  struct Free {
    void operator()(double* p) const { ::operator delete(p, kAlignment); }
  };
  std::unique_ptr<double, Free> memory_;
  std::size_t size_ = 0;
};

/// Solves load after load on one sector, bars or refined, station by station along its threads: the same model, start,
/// convergence and results as `SectorSolver`, to 1e-10, several times faster. All that lies between contacts is
/// condensed exactly. A solve allocates nothing once its result has its size. Guides must have no clearance.
class ChainSolver {
 public:
  explicit ChainSolver(const SectorModel& model);

  /// Options of Newton's method; force_scale, length_scale and reuse_factorization_below are not used. On
  /// slender rollers a residual of 1e-12 can leave 1e-10 in a thread's load.
  fe::NewtonOptions options{.residual_tolerance = 1e-13};

  /// Equilibrium under the axial force on the whole mechanism [N], > 0.
  LoadDistribution solve(double axial_force);

  /// Solves into a result that keeps its memory.
  void solve(double axial_force, LoadDistribution& result);

 private:
  ChainSector sector_;
  Workspace workspace_;
  ThreadLoads loads_;
};

/// The sector's numbers as a chain. Nodes of shells between contacts and beyond them are eliminated
/// in extended precision, all else in closed form.
ChainSector condense(const SectorModel& model);

/// Solver by the chain, or by SectorSolver if guides have a clearance, the chain does not converge or its tangent has
/// too few digits: as fast as the first, as reliable as the second.
class FallbackSolver {
 public:
  explicit FallbackSolver(SectorModel model) : model_(std::move(model)) {
    if (!model_.has_loose_guides()) chain_.emplace(model_);
  }

  LoadDistribution solve(double axial_force) {
    if (chain_) {
      LoadDistribution result = chain_->solve(axial_force);
      if (complete(result)) return result;
    }
    if (!sparse_) sparse_ = std::make_unique<SectorSolver>(build_sector(model_));
    return sparse_->solve(axial_force);
  }

  /// Whether a chain's result needs no other solver. Without a tangent stiffness, which is optional, the displacement
  /// must be plausible.
  static bool complete(const LoadDistribution& chain, bool with_tangent = true) {
    return chain.solve.converged() &&
           (chain.tangent_stiffness.has_value() || (!with_tangent && chain.axial_displacement > 0.0));
  }

 private:
  SectorModel model_;
  std::optional<ChainSolver> chain_;
  std::unique_ptr<SectorSolver> sparse_;
};

}  // namespace prs
