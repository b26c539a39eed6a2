#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "prs/life/analyze_life.h"
#include "prs/output/json.h"

namespace prs {

/// The document of `prs life --json`, its results under `life`; lives that are not finite, without
/// load, are absent.
nlohmann::ordered_json life_json(const LifeResult& result, const DocumentInfo& info);

/// `life_threads.csv`: a row a thread, interface and sense of the load.
std::string life_threads_csv(const LifeResult& result);

/// `cycles.csv`: every cycle in the order in which it closed, its turning points by the row of the
/// history, counted from 1.
std::string cycles_csv(const LoadCycles& cycles);

/// `cycle_matrix.csv`: a row for each bin that is not empty.
std::string cycle_matrix_csv(const CycleMatrix& matrix);

}  // namespace prs
