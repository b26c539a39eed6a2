#include "prs/loads/warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "prs/loads/case_groups.h"
#include "prs/loads/case_table.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {
namespace {

bool is_of_number(char c) { return (c >= '0' && c <= '9') || c == '.'; }

/// Magnitudes of the numbers in a text, in their order.
std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  for (const char *at = text.data(), *end = at + text.size(); at < end; ++at) {
    double number = 0.0;
    if (*at < '0' || *at > '9') continue;
    at = std::from_chars(at, end, number).ptr - 1;
    numbers.push_back(number);
  }
  return numbers;
}

bool is_worse(std::string_view text, std::string_view than) {
  const std::vector<double> a = numbers_in(text), b = numbers_in(than);
  const auto [x, y] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (x == a.end() || y == b.end()) return false;
  return text.find("at the least") == text.npos ? *x > *y : *x < *y;
}

/// Length of the path of a load case at the head of a text.
std::size_t length_of_place(std::string_view text) {
  return text.starts_with("load_cases[") ? text.find(']') + 1 : 0;
}

/// With the units of tables.
std::string warning_lines(const std::string& warning) {
  return wrapped(in_table_units(printable(warning)), "  ", kTableWidth);
}

}  // namespace

std::string WarningGroup::where() const {
  if (cases.empty()) return {};
  const bool several = cases.size() > 1 && differs && !worst.empty();
  return fmt::format("in {}{}{}", folded_names(cases), several ? "; worst in " : "",
                     several ? worst : "");
}

void WarningGroups::add(std::string text, const std::string& load_case) {
  std::string pattern = text;
  std::erase_if(pattern, is_of_number);
  const std::size_t length = length_of_place(text);
  std::string place = text.substr(0, length);
  text.erase(0, length);
  auto group = std::ranges::find(groups_, pattern, &WarningGroup::pattern);
  if (group == groups_.end())
    group = groups_.insert(group, {std::move(pattern), place, text, {}, load_case});
  if (group->place != place) group->place = "load_cases[..]";
  if (group->text != text) {
    group->differs = true;
    if (is_worse(text, group->text)) {
      group->text = std::move(text);
      group->worst = load_case;
    }
  } else if (group->worst.empty()) {
    group->worst = load_case;
  }
  if (!load_case.empty() && known_.emplace(group->pattern, load_case).second)
    group->cases.push_back(load_case);
}

std::string warning_summary(const Result& result) {
  return warning_summary(result.warnings, result.load_cases);
}

std::string warning_summary(const std::vector<std::string>& warnings,
                            const std::vector<LoadCaseResult>& load_cases) {
  WarningGroups groups;
  for (const LoadCaseResult& load_case : load_cases)
    for (const std::string& warning : load_case.warnings)
      groups.add(printable(warning), printable(load_case.load_case.name));

  std::string summary;
  for (const std::string& warning : warnings) summary += warning_lines(warning);
  for (const WarningGroup& group : std::move(groups).take())
    summary += warning_lines(group.whole()) + wrapped(group.where(), "    ", kTableWidth);
  return summary.empty() ? summary : "Warnings\n" + summary;
}

std::string warning_section(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& warning : warnings) text += warning_lines(warning);
  return text.empty() ? text : "\nWarnings\n" + text;
}

}  // namespace prs
