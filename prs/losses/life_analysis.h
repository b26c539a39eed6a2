#pragma once

#include "prs/life/analyze_life.h"
#include "prs/record/analysis.h"

namespace prs {

inline constexpr std::string_view kStatedCapacityNote =
    "A stated C_a comes from real screws, whose threads share unevenly: the life with real thread "
    "loads counts that twice and is a lower bound.";

/// Life of the mechanism, its limiting parts and the static safety, within 100 columns.
std::string life_table(const LifeResult& result);

/// `life_threads.csv`: one row per thread, interface and sense of the load.
std::string life_threads_csv(const LifeResult& result, const CsvStyle& style = {});

/// `life_rollers.csv`: one row per thread of a roller, interface and sense of the load; for a full mechanism.
std::string life_rollers_csv(const LifeResult& result, const CsvStyle& style = {});

/// `cycles.csv`: every cycle in the order of closing, its turning points by the row of the history, counted from 1.
std::string cycles_csv(const LoadCycles& cycles, const CsvStyle& style = {});

/// `cycle_matrix.csv`: one row for each bin that is not empty.
std::string cycle_matrix_csv(const CycleMatrix& matrix, const CsvStyle& style = {});

/// Analysis of life; infinite lives, without load, are absent.
const Analysis<LifeResult>& life_analysis();

/// Reads the force history that the case refers to.
LifeResult life_of(const input::Source& source, const input::CaseInput& in);

}  // namespace prs
