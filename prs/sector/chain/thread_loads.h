#pragma once

#include "fe/newton_types.h"
#include "prs/model/part.h"

namespace prs {

struct LoadDistribution;

/// Output of a chain kernel, solve k at index k of each array. SI units.
struct ThreadLoads {
  std::size_t stride = 0;  ///< Number of threads of a solve.
  /// N of thread i of solve k at `k * stride + i`, thread 1 first [N].
  PerInterface<std::vector<double>> normal_load;
  PerInterface<std::vector<double>> approach;  ///< Hertz approach delta in the same order [m].
  std::vector<double> axial_displacement;      ///< Displacement as in `LoadDistribution` [m].
  /// dF/du [N/m], NaN if it is singular; empty if it is not computed.
  std::vector<double> tangent_stiffness;
  std::vector<fe::NewtonStatus> status;
  std::vector<int> iterations;  ///< Linear solves, the first included.
  std::vector<double> initial_relative_residual;
  std::vector<double> relative_residual;
  std::vector<double> energy;  ///< Energy of one sector [J].

  void resize(std::size_t solves, std::size_t threads, bool with_tangent = true);
  /// Solve k as a LoadDistribution. Its history has only the outcome of the last iteration.
  void copy(std::size_t k, double residual_tolerance, LoadDistribution& result) const;
};

}  // namespace prs
