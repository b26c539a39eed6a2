#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "prs/model/study.h"

namespace prs {

/// A factor or companion as a column of a file: numbers in its unit or, where its values are words,
/// their indices.
struct FactorColumn {
  std::string name;                ///< Path with the unit: `mechanism.lead_mm`
  std::vector<std::string> words;  ///< Empty where the values are numbers.
  double base = 0.0;               ///< What the file says; NaN where it says nothing.

  bool is_numeric() const { return words.empty(); }
};

/// A column for each of `drawn_inputs`; a number tells it apart from a response or another one of
/// the same name.
std::vector<FactorColumn> factor_columns(const Study& study);

/// What designs [first, first + count) set: count x columns.
std::vector<double> factor_values(const Study& study, const std::vector<FactorColumn>& columns,
                                  std::size_t first, std::size_t count);

/// A unit as it stands in keys: `N/mm^1.5` is `N_per_mm1_5`.
std::string unit_key(const std::string& unit);

}  // namespace prs
