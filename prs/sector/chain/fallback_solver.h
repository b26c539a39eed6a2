#pragma once

#include "prs/sector/chain/chain_solver.h"

namespace prs {

/// The chain, and SectorSolver where the chain doesn't converge or its tangent has too few digits:
/// the speed of the one, the verdict of the other.
class FallbackSolver {
 public:
  explicit FallbackSolver(SectorModel model) : model_(std::move(model)), chain_(model_) {}

  LoadDistribution solve(double axial_force) {
    LoadDistribution result = chain_.solve(axial_force);
    if (complete(result)) return result;
    if (!sparse_) sparse_ = std::make_unique<SectorSolver>(build_sector(model_));
    return sparse_->solve(axial_force);
  }

  /// Whether a chain's result needs no other solver. Without a tangent stiffness, which some chains
  /// are not asked for, the displacement must make sense.
  static bool complete(const LoadDistribution& chain, bool with_tangent = true) {
    return chain.solve.converged() && (chain.tangent_stiffness.has_value() ||
                                       (!with_tangent && chain.axial_displacement > 0.0));
  }

 private:
  SectorModel model_;
  ChainSolver chain_;
  std::unique_ptr<SectorSolver> sparse_;
};

}  // namespace prs
