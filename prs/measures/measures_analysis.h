#pragma once

#include "prs/measures/measures.h"
#include "prs/record/analysis.h"

namespace prs {

/// The measures of the mechanism, then those of each load case side by side.
std::string measures_table(const MeasuresResult& result);

/// Formula, validity and source of every measure.
std::string measure_explanations();

/// `measures.csv`: one row per measure and load case, which is empty for the mechanism itself.
std::string measures_csv(const MeasuresResult& result, const CsvStyle& style = {});

/// `yang.csv`: thread by thread, Yang's load rates next to those of the model.
std::string yang_csv(const MeasuresResult& result, const CsvStyle& style = {});

/// Result of `solve`, with the measures of the mechanism and of each load case.
const Analysis<MeasuresResult>& measures_analysis();

/// Formula, validity and source of every measure, with its key in documents.
Json measure_explanations_json();

// Records with a group, a title, a formula as the meaning, validity and source for each quantity.
Record<Measures> record_of(Type<Measures>);
Record<LoadMeasures> record_of(Type<LoadMeasures>);
Record<SystemStiffness> record_of(Type<SystemStiffness>);
Record<SystemStiffness::Contributions> record_of(Type<SystemStiffness::Contributions>);
Record<SystemStiffness::Contribution> record_of(Type<SystemStiffness::Contribution>);

/// Quantities computed from the thread loads of a case.
struct Computed {
  bool slip = false, life = false;  ///< Whether `prs slip` and `prs life` compute theirs.
  bool static_safety = false;       ///< Whether it is computed with the thread loads at the limit.
  bool thread_safety = false;       ///< Whether it is computed with the thread loads under the load, or at the limit.
  bool thread_loads = false;        ///< Whether `prs solve` computes those of every load case.
};

}  // namespace prs
