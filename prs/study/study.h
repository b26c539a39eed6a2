#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "prs/check_case.h"

namespace prs {

/// How a study chooses its designs from its factors.
enum class Plan {
  one_at_a_time,  ///< Each value of each factor alone, all others as in the file.
};

/// One value of a factor as it would stand in the file, and where it lies on an axis.
struct Level {
  std::string text;              ///< YAML: `30 mm`, `{convex: 6 mm}`
  std::optional<double> number;  ///< In the factor's unit; absent for words.
};

/// An input that a study varies.
struct Factor {
  std::string path;   ///< `mechanism.pitch_diameter.screw`
  std::string label;  ///< What people read; the path where none is given.
  std::string unit;   ///< Of the numbers; empty for bare ones.
  std::vector<Level> levels;
  std::optional<Level> base;  ///< What the file says; absent where it says nothing.
  bool logarithmic = false;   ///< The levels are equidistant in their logarithm.

  /// Whether every level has its place on an axis.
  bool is_numeric() const;
};

/// What is varied, how, and what is recorded of each design.
struct Study {
  Command command = Command::slip;  ///< contact, solve or slip: the chain of each design.
  Plan plan = Plan::one_at_a_time;
  std::vector<Factor> factors;
  std::vector<std::string> responses;  ///< Paths, see `response`; empty: those of the command.
};

/// A factor that differs from the file, and its value.
struct Setting {
  std::size_t factor = 0;
  Level level;
};

/// One case of a study: the file with these settings; none for the base case.
struct Design {
  std::vector<Setting> settings;
};

inline constexpr std::size_t kMostDesigns = 100'000;

/// Number of designs, the base case included.
std::size_t design_count(const Study& study);

/// Design k, from 0; the base case is the first. A pure function of the study, so that designs can
/// be run in any order, in parts and again.
Design design(const Study& study, std::size_t k);

/// Whether a design leaves every value as it is in the file, be it by the same value.
bool is_base(const Study& study, const Design& design);

/// The settings as `--set` takes them: `mechanism.rollers=9`.
std::vector<std::string> overrides(const Study& study, const Design& design);

}  // namespace prs
