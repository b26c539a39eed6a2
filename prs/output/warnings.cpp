#include "prs/output/warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "prs/output/case_table.h"
#include "prs/output/table_units.h"
#include "prs/quantities/case_groups.h"
#include "prs/text.h"

namespace prs {
namespace {

struct WarningGroup {
  std::string pattern;  ///< The text without its numbers.
  std::string place;    ///< Path of the load case, with which the text begins; else empty.
  std::string text;     ///< As the last of the cases has it.
  bool texts_differ = false;
  std::vector<std::string> cases;
};

std::string without_numbers(std::string text) {
  std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
  return text;
}

void add(std::string text, const LoadCase& load_case, std::vector<WarningGroup>& groups) {
  std::string pattern = without_numbers(text), place;
  if (!load_case.input_path.empty() && text.starts_with(load_case.input_path)) {
    place = load_case.input_path;
    text.erase(0, place.size());
  }
  auto group = std::find_if(groups.begin(), groups.end(),
                            [&](const WarningGroup& g) { return g.pattern == pattern; });
  if (group == groups.end())
    group = groups.insert(group, {std::move(pattern), place, text, false, {}});
  if (group->place != place) group->place = "load_cases[..]";
  group->texts_differ = group->texts_differ || group->text != text;
  group->text = std::move(text);
  group->cases.push_back(printable(load_case.name));
}

/// With the units of tables.
std::string warning_lines(const std::string& warning) {
  return wrapped(in_table_units(printable(warning)), "  ", kTableWidth);
}

std::string group_lines(const WarningGroup& group) {
  const std::string cases = fmt::format("in {}{}", folded_names(group.cases),
                                        group.texts_differ ? "; numbers of the last" : "");
  return warning_lines(group.place + group.text) + wrapped(cases, "    ", kTableWidth);
}

}  // namespace

std::string warning_summary(const Result& result) {
  return warning_summary(result.warnings, result.load_cases);
}

std::string warning_summary(const std::vector<std::string>& warnings,
                            const std::vector<LoadCaseResult>& load_cases) {
  std::vector<WarningGroup> groups;
  for (const LoadCaseResult& load_case : load_cases)
    for (const std::string& warning : load_case.warnings)
      add(printable(warning), load_case.load_case, groups);

  std::string summary;
  for (const std::string& warning : warnings) summary += warning_lines(warning);
  for (const WarningGroup& group : groups) summary += group_lines(group);
  return summary.empty() ? summary : "Warnings\n" + summary;
}

std::string warning_section(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& warning : warnings) text += warning_lines(warning);
  return text.empty() ? text : "\nWarnings\n" + text;
}

}  // namespace prs
