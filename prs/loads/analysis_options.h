#pragma once

#include "prs/sector/sector.h"

namespace prs {

class FullSolver;

struct AnalysisOptions {
  Detail detail = Detail::complete;
  Solver solver = Solver::sparse;
  /// Solver of full mechanisms, for a thread that analyses many; null: a new one for each analysis.
  FullSolver* full = nullptr;
  std::optional<double> temperature_limit = {};  ///< Limit whose reaching by the parts of a mission is timed [K].
};

/// Options for one of many designs.
inline constexpr AnalysisOptions kManyDesigns{Detail::numbers, Solver::chain};

}  // namespace prs
