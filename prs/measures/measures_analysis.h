#pragma once

#include "prs/measures/measures.h"
#include "prs/record/analysis.h"

namespace prs {

/// The measures of the mechanism, then those of each load case side by side.
std::string measures_table(const MeasuresResult& result);

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

// With a group, a title, a formula as the meaning, validity and source each.
Record<Measures> record_of(Type<Measures>);
Record<LoadMeasures> record_of(Type<LoadMeasures>);
Record<SystemStiffness> record_of(Type<SystemStiffness>);
Record<SystemStiffness::Contributions> record_of(Type<SystemStiffness::Contributions>);
Record<SystemStiffness::Contribution> record_of(Type<SystemStiffness::Contribution>);

/// What is computed from the thread loads of a case.
struct Computed {
  bool slip = false, life = false;  ///< By `prs slip` and `prs life`.
  bool static_safety = false;       ///< Computed with the thread loads at the limit.
  bool thread_safety = false;       ///< Computed with those under the load, or at the limit.
  bool thread_loads = false;        ///< Those of every load case, by `prs solve`.
};

/// Keys of the measures that are estimates of what is computed. People see them where they ask for
/// all, so that each quantity has one headline.
std::vector<std::string> estimates_beside(const Computed& computed);

}  // namespace prs
