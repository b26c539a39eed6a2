#pragma once

#include "prs/loads/analysis_options.h"
#include "prs/loads/load_json.h"

namespace prs {

const Analysis<Result>& contact_analysis();

bool all_converged(const Result& result);

/// The warnings of a result for the terminal, each once with its load cases.
std::vector<std::string> summary_of_warnings(const Result& result);

/// A terminal shows a load case thread by thread, but not the points of a range.
inline constexpr std::size_t kMostCharts = 1;

/// Tables of load cases and of their threads, as `solve` writes them.
std::vector<OutputFile> load_files(const Result& result, const CsvStyle& style);

}  // namespace prs
