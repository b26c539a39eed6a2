#include "prs/loads/warnings.h"

#include <map>

#include "prs/loads/case_groups.h"
#include "prs/loads/case_table.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {
namespace {

/// A path without the load case at its head.
std::string without_load_case(const std::string& path) {
  return path.starts_with("load_cases[") ? path.substr(path.find(']') + 1) : path;
}

std::string without_path(Warning warning) {
  warning.path.clear();
  return sentence(warning);
}

void add(const Warning& warning, WarningGroup& group) {
  const bool differs = without_path(warning) != without_path(group.worst);
  group.differs |= differs;
  group.several_paths |= warning.path != group.worst.path;
  if (differs ? is_worse(warning, group.worst) : group.worst.load_case.empty())
    group.worst = warning;
}

}  // namespace

std::string WarningGroup::text() const {
  if (differs || !several_paths) return sentence(worst);
  Warning all = worst;
  all.path = "load_cases[..]" + without_load_case(worst.path);
  return sentence(all);
}

std::string WarningGroup::where() const {
  if (cases.empty()) return {};
  const std::size_t others = cases.size() - 1;
  if (!differs || others == 0 || worst.load_case.empty())
    return fmt::format("in {}", folded_names(cases));
  return fmt::format("worst in {}, and {} other load case{}", worst.load_case, others,
                     others == 1 ? "" : "s");
}

std::vector<WarningGroup> grouped(const std::vector<Warning>& warnings) {
  std::vector<WarningGroup> groups;
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  std::set<std::pair<std::size_t, std::string>> told;
  for (const Warning& warning : warnings) {
    const auto [at, is_new] =
        known.try_emplace({warning.code, without_load_case(warning.path)}, groups.size());
    if (is_new)
      groups.push_back({warning});
    else
      add(warning, groups[at->second]);
    if (!warning.load_case.empty() && told.emplace(at->second, warning.load_case).second)
      groups[at->second].cases.push_back(warning.load_case);
  }
  return groups;
}

std::vector<Warning> all_warnings(std::vector<Warning> of_case,
                                  const std::vector<LoadCaseResult>& load_cases) {
  for (const LoadCaseResult& load : load_cases)
    for (const Warning& warning : load.warnings)
      of_case.emplace_back(warning).load_case = load.load_case.name;
  return of_case;
}

std::vector<Warning> all_warnings(const Result& result) {
  return all_warnings(result.warnings, result.load_cases);
}

std::string warning_summary(const std::vector<Warning>& warnings) {
  std::string summary = warnings.empty() ? "" : "Warnings\n";
  for (const WarningGroup& group : grouped(warnings)) {
    summary += wrapped(in_table_units(printable(group.text())), "  ", kTableWidth);
    if (const std::string where = group.where(); !where.empty())
      summary += wrapped(printable(where), "    ", kTableWidth);
  }
  return summary;
}

std::string warning_section(const std::vector<Warning>& warnings) {
  return warnings.empty() ? "" : '\n' + warning_summary(warnings);
}

}  // namespace prs
