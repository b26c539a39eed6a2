#pragma once

#include <cstddef>
#include <span>

#include "fe/newton_types.h"
#include "prs/model/part.h"

namespace prs {

/// Where a chain solver writes its results, solve k at place k of each array. An empty array is not
/// wanted and costs nothing. SI units.
struct ThreadLoads {
  /// N of thread i of solve k at `k * stride + i`, thread 1 first [N].
  PerInterface<std::span<double>> normal_load;
  PerInterface<std::span<double>> approach;  ///< Hertz approach delta in the same order [m].
  std::size_t stride = 0;                    ///< >= the threads of every solve.
  std::span<double> axial_displacement;      ///< As in `LoadDistribution` [m].
  std::span<double> tangent_stiffness;       ///< dF/du [N/m], NaN where it is singular.
  std::span<fe::NewtonStatus> status;
  std::span<int> iterations;  ///< Linear solves, the first included.
  std::span<double> initial_relative_residual;
  std::span<double> relative_residual;
  std::span<double> energy;  ///< Of one sector [J].
};

}  // namespace prs
