#pragma once

#include "prs/measures/analyze_measures.h"
#include "prs/record/analysis.h"
#include "prs/record/csv_writer.h"

namespace prs {

/// Keys of estimates of what the result or another command computes.
std::vector<std::string> estimates_in(const MeasuresResult& result);

/// The measures of the mechanism, then those of each load case side by side.
std::string measures_table(const MeasuresResult& result);
/// With the estimates of what is computed.
std::string full_measures_table(const MeasuresResult& result);

/// Formula, validity and source of every measure.
std::string measure_explanations();

/// `measures.csv`: one row per measure and load case, that of the mechanism's own empty.
std::string measures_csv(const MeasuresResult& result, const CsvStyle& style = {});

/// `yang.csv`: thread by thread, Yang's load rates next to those of the model.
std::string yang_csv(const MeasuresResult& result, const CsvStyle& style = {});

/// What `solve` gives, with the measures of the mechanism and of each load case.
const Analysis<MeasuresResult>& measures_analysis();

/// Formula, validity and source of every measure, with the key under which documents show it.
Json measure_explanations_json();

}  // namespace prs
