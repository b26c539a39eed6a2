#include "prs/output/warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "prs/quantities/case_groups.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kWidth = 110;

struct WarningGroup {
  std::string pattern;  ///< The text without its numbers.
  std::string text;     ///< As the last of the cases has it.
  bool texts_differ = false;
  std::vector<std::string> cases;
};

std::string without_numbers(std::string text) {
  std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
  return text;
}

void add(std::string text, const std::string& case_name, std::vector<WarningGroup>& groups) {
  std::string pattern = without_numbers(text);
  auto group = std::find_if(groups.begin(), groups.end(),
                            [&](const WarningGroup& g) { return g.pattern == pattern; });
  if (group == groups.end()) group = groups.insert(group, {std::move(pattern), text, false, {}});
  group->texts_differ = group->texts_differ || group->text != text;
  group->text = std::move(text);
  group->cases.push_back(case_name);
}

std::string group_lines(const WarningGroup& group) {
  const std::string cases = fmt::format("in {}{}", folded_names(group.cases),
                                        group.texts_differ ? "; numbers of the last" : "");
  return wrapped(group.text, "  ", kWidth) + wrapped(cases, "    ", kWidth);
}

}  // namespace

std::string warning_summary(const Result& result) {
  std::vector<WarningGroup> groups;
  for (const LoadCaseResult& load_case : result.load_cases)
    for (const std::string& warning : load_case.warnings)
      add(printable(warning), printable(load_case.load_case.name), groups);

  std::string summary;
  for (const std::string& warning : result.warnings)
    summary += wrapped(printable(warning), "  ", kWidth);
  for (const WarningGroup& group : groups) summary += group_lines(group);
  return summary.empty() ? summary : "Warnings\n" + summary;
}

std::string warning_section(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& warning : warnings) text += wrapped(printable(warning), "  ", kWidth);
  return text.empty() ? text : "\nWarnings\n" + text;
}

}  // namespace prs
