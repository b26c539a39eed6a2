#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "prs/model/units.h"

namespace prs {

/// What is possible and still unusual about a case or one of its results.
struct Warning {
  /// Which values are worse, of those that the same warning has in other load cases.
  enum class Worse { larger, smaller };

  std::string path;                              ///< Key of the input that it concerns; empty where there is none.
  std::string code;                              ///< Its kind: `screw_peak_pressure`. With `path` it names a group.
  std::string what;                              ///< A sentence; `{value}` and `{limit}` stand for the numbers.
  std::string fix = {};                          ///< How to fix it.
  std::optional<double> value = {}, limit = {};  ///< [SI]
  ShownUnit unit = {};
  Worse worse = Worse::larger;
  std::string load_case = {};  ///< Its name, where it is of one; set where cases are gathered.
  /// A choice of the model that most cases share, as parts without errors: listed by itself, with its effect.
  bool is_assumption = false;

  /// The warning with these numbers.
  Warning with(std::optional<double> of_value, std::optional<double> of_limit = {}, ShownUnit of_unit = {},
               Worse of_worse = Worse::larger) && {
    value = of_value, limit = of_limit, unit = of_unit, worse = of_worse;
    return std::move(*this);
  }
  Warning as_assumption() && {
    is_assumption = true;
    return std::move(*this);
  }
  bool operator==(const Warning&) const = default;
};

/// The part of `warnings` that are assumptions, the one with the largest effect on loads first, or that are not.
std::vector<Warning> selected(std::span<const Warning> warnings, bool assumptions);

/// `PATH: WHAT; FIX`, numbers with three digits, or with as many as tell value and limit apart.
std::string sentence(const Warning& warning);
std::vector<std::string> sentences(std::span<const Warning> warnings);

/// Heading of what `is_assumption`.
inline constexpr std::string_view kAssumptionsTitle = "Assumptions that matter here";

/// Whether the value is nearer to its limit, or further beyond it. Without limits by size.
bool is_worse(const Warning& warning, const Warning& than);

}  // namespace prs
