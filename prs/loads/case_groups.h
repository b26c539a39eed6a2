#pragma once

#include "prs/loads/result.h"

namespace prs {

/// Most cases that a table names one by one; of more, it shows what they share in one line.
inline constexpr std::size_t kMaxUnfoldedCases = 24;

/// The load cases that one range of the input made (`NAME[k]`), in their order, or a single case.
struct CaseGroup {
  std::string name;  ///< NAME, without `[k]`.
  std::optional<Direction> direction;
  std::vector<const LoadCaseResult*> cases;  ///< Never empty; point into the grouped results.
};

/// Groups by name and direction, in the order of the first members.
std::vector<CaseGroup> group_cases(const std::vector<LoadCaseResult>& results);

/// One configuration of the mechanism in one or both directions of load.
struct LoadedConfiguration {
  std::string name;
  std::vector<CaseGroup> groups;  ///< At most one per direction.

  const CaseGroup* group(std::optional<Direction> direction) const;
};

/// Groups of at least `min_points` cases of which `keep` is true, the others left out. Two
/// directions belong together where their names differ in the last word only: `config1-tension` and
/// `config1-compression` make `config1`.
std::vector<LoadedConfiguration> loaded_configurations(const std::vector<LoadCaseResult>& results,
                                                       std::size_t min_points,
                                                       bool (*keep)(const LoadCaseResult&));

/// Lists names with the points of a range folded: `a[0–44], b, c[3, 7–9]`. Beyond
/// twelve entries says how many there are.
std::string folded_names(const std::vector<std::string>& names);

}  // namespace prs
