#include "prs/loads/case_groups.h"

#include <fmt/ranges.h>

#include <charconv>

namespace prs {
namespace {

constexpr std::size_t kMaxLabels = 12;

struct PointName {
  std::string_view base;
  std::optional<int> point;  ///< Absent for a case that is no point of a range.
};

PointName split(std::string_view name) {
  const std::size_t open = name.rfind('[');
  if (open == std::string_view::npos || open == 0 || name.back() != ']') return {name, {}};
  const char* end = name.data() + name.size() - 1;
  int point = 0;
  const auto [parsed, error] = std::from_chars(name.data() + open + 1, end, point);
  if (error != std::errc() || parsed != end || point < 0) return {name, {}};
  return {name.substr(0, open), point};
}

/// `0–3, 7` for 0, 1, 2, 3, 7.
std::string folded_points(std::vector<int> points) {
  std::sort(points.begin(), points.end());
  std::vector<std::string> runs;
  for (std::size_t first = 0; first < points.size();) {
    std::size_t last = first;
    while (last + 1 < points.size() && points[last + 1] == points[last] + 1) ++last;
    runs.push_back(first == last ? fmt::to_string(points[first])
                                 : fmt::format("{}–{}", points[first], points[last]));
    first = last + 1;
  }
  return fmt::to_string(fmt::join(runs, ", "));
}

/// The name without the word for the direction at its end.
std::string configuration_name(const CaseGroup& group) {
  if (!group.direction) return group.name;
  const std::string_view word = name(*group.direction);
  if (!group.name.ends_with(word)) return group.name;
  std::string stem = group.name.substr(0, group.name.size() - word.size());
  while (!stem.empty() && std::string_view("-_ .").find(stem.back()) != std::string_view::npos)
    stem.pop_back();
  return stem.empty() ? group.name : stem;
}

}  // namespace

std::vector<CaseGroup> group_cases(const std::vector<LoadCaseResult>& results) {
  std::vector<CaseGroup> groups;
  for (const LoadCaseResult& result : results) {
    const LoadCase& load = result.load_case;
    const PointName name = split(load.name);
    const auto same = [&](const CaseGroup& g) {
      return name.point && g.name == name.base && g.direction == load.direction;
    };
    auto group = std::find_if(groups.begin(), groups.end(), same);
    if (group == groups.end())
      group = groups.insert(group, {std::string(name.base), load.direction, {}});
    group->cases.push_back(&result);
  }
  return groups;
}

const CaseGroup* LoadedConfiguration::group(std::optional<Direction> direction) const {
  const auto found = std::find_if(groups.begin(), groups.end(),
                                  [&](const CaseGroup& g) { return g.direction == direction; });
  return found == groups.end() ? nullptr : &*found;
}

std::vector<LoadedConfiguration> loaded_configurations(const std::vector<LoadCaseResult>& results,
                                                       std::size_t min_points,
                                                       bool (*keep)(const LoadCaseResult&)) {
  std::vector<LoadedConfiguration> found;
  for (CaseGroup& group : group_cases(results)) {
    std::erase_if(group.cases, [&](const LoadCaseResult* result) { return !keep(*result); });
    if (group.cases.size() < min_points) continue;
    const std::string name = configuration_name(group);
    auto it = std::find_if(found.begin(), found.end(), [&](const LoadedConfiguration& c) {
      return c.name == name && !c.group(group.direction);
    });
    if (it == found.end()) it = found.insert(it, {name, {}});
    it->groups.push_back(std::move(group));
  }
  return found;
}

std::string folded_names(const std::vector<std::string>& names) {
  std::vector<std::pair<std::string_view, std::vector<int>>> bases;
  for (const std::string& full : names) {
    const PointName name = split(full);
    auto base = std::find_if(bases.begin(), bases.end(), [&](const auto& b) {
      return name.point && b.first == name.base && !b.second.empty();
    });
    if (base == bases.end()) base = bases.insert(base, {name.base, {}});
    if (name.point) base->second.push_back(*name.point);
  }
  std::vector<std::string> labels;
  for (const auto& [base, points] : bases)
    labels.push_back(points.empty() ? std::string(base)
                                    : fmt::format("{}[{}]", base, folded_points(points)));
  if (labels.size() > kMaxLabels) {
    const std::size_t others = labels.size() - kMaxLabels;
    labels.resize(kMaxLabels);
    labels.push_back(fmt::format("and {} more", others));
  }
  return fmt::to_string(fmt::join(labels, ", "));
}

}  // namespace prs
