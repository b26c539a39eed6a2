#pragma once

#include <string>

#include "prs/record/csv_style.h"

#include "prs/compare/compare_models.h"

namespace prs {

/// A row per load case and model, and the warnings below. Of many load cases the first.
std::string comparison_table(const ModelComparison& result);

/// `comparison.csv`: a row per load case and model.
std::string comparison_csv(const ModelComparison& result, const CsvStyle& style);

}  // namespace prs
