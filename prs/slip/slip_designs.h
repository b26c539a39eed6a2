#pragma once

#include "prs/slip/slip_equilibrium.h"
#include "prs/slip/slip_kernel.h"
#include "simd/instruction_set.h"

namespace prs {

/// Finds the equilibria of many screws with equal shares side by side. Memory stays from one call
/// to the next.
class SlipDesignSolver {
 public:
  explicit SlipDesignSolver(simd::InstructionSet set) : set_(set) {}

  void clear() { screws_.clear(), tasks_.clear(); }
  /// Adds a model with equal shares; its patches are not needed.
  void add(const SlipModel& model);
  /// Solves all models that were added.
  void solve(const contact::PatchGrid& grid);
  /// Fills `found` with the result that `find_slip_equilibrium` gives for the model added as number k.
  void get(std::size_t k, SlipEquilibrium& found) const;

 private:
  simd::InstructionSet set_;
  std::vector<SlipNumbers<double>> screws_;
  std::vector<SlipTask> tasks_;
  std::vector<double> viscosity_ratio_, memory_;
};

}  // namespace prs
