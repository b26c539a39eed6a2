#pragma once

#include "prs/compare/compare_models.h"
#include "prs/record/analysis.h"

namespace prs {

/// Result of one model for one load case, and its comparison.
struct ComparedModel {
  const ModelComparison* comparison = nullptr;
  std::size_t load_case = 0;
  std::size_t model = 0;

  std::string_view model_name() const { return name_of_model(comparison->models[model].model); }
  const LoadCaseResult& result() const { return comparison->models[model].load_cases[load_case]; }
  const LoadCaseResult& best() const { return comparison->best().load_cases[load_case]; }
};

/// Number, from 1, of the most loaded thread of any roller.
std::optional<std::size_t> most_loaded_thread(const InterfaceLoads& loads);

Record<ComparedModel> record_of(Type<ComparedModel>);
Record<ModelComparison> record_of(Type<ModelComparison>);

/// One row per load case and model, and the warnings below. If there are many load cases, the first ones.
std::string comparison_table(const ModelComparison& result);

/// `comparison.csv`: one row per load case and model.
std::string comparison_csv(const ModelComparison& result, const CsvStyle& style);

const Analysis<ModelComparison>& compare_analysis();

}  // namespace prs
