#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "prs/model/units.h"

namespace prs {

/// Possible but unusual property of a case or a result.
struct Warning {
  /// The worse of two values of the same warning in different load cases.
  enum class Worse { larger, smaller };

  std::string path;      ///< Key of the input concerned; may be empty.
  std::string code;      ///< Kind of warning: `screw_peak_pressure`. With `path` it names a group.
  std::string what;      ///< A sentence with `{value}` and `{limit}` in place of the numbers.
  std::string fix = {};  ///< How to fix it.
  std::optional<double> value = {}, limit = {};  ///< [SI]
  ShownUnit unit = {};
  Worse worse = Worse::larger;
  std::string load_case = {};  ///< Name of the load case, if the warning belongs to one; set where cases are gathered.
  /// Whether it is a modelling assumption that most cases share, such as parts without errors: listed separately, with
  /// its effect.
  bool is_assumption = false;

  /// Copy of the warning with these numbers.
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

/// Either the assumptions among `warnings`, largest effect on loads first, or all others.
std::vector<Warning> selected(std::span<const Warning> warnings, bool assumptions);

/// `PATH: WHAT; FIX`, numbers with three digits, or as many as distinguish value and limit.
std::string sentence(const Warning& warning);
std::vector<std::string> sentences(std::span<const Warning> warnings);

/// Heading of the list of assumptions.
inline constexpr std::string_view kAssumptionsTitle = "Assumptions that matter here";

/// Whether the value is nearer to its limit, or further beyond it. Without limits: by size.
bool is_worse(const Warning& warning, const Warning& than);

}  // namespace prs
