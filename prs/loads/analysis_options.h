#pragma once

#include "prs/model/model_options.h"

namespace prs {

/// Solver of the load distribution of bars and refined bodies. Both agree within 1e-10.
enum class Solver {
  sparse,  ///< Newton's method on the sparse matrix of the sector.
  chain,   ///< Station by station, several times as fast; `sparse` if that does not converge.
};

class FullSolver;

struct AnalysisOptions {
  Detail detail = Detail::complete;
  Solver solver = Solver::sparse;
  /// Solver of full mechanisms, for a thread that analyses many; null: a new one for each analysis.
  FullSolver* full = nullptr;
};

/// Options for one of many designs.
inline constexpr AnalysisOptions kManyDesigns{Detail::numbers, Solver::chain};

}  // namespace prs
