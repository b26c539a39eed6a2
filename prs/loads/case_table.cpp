#include "prs/loads/case_table.h"

#include <fmt/ranges.h>

#include <charconv>
#include <map>

#include "prs/indices.h"
#include "prs/loads/load_record.h"
#include "prs/record/table_layout.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kMaxLabels = 12;

struct PointName {
  std::string_view base;
  std::optional<int> point;  ///< Absent for a case outside ranges.
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
    runs.push_back(first == last ? fmt::to_string(points[first]) : fmt::format("{}–{}", points[first], points[last]));
    first = last + 1;
  }
  return fmt::to_string(fmt::join(runs, ", "));
}

/// The name without the direction at its end.
std::string configuration_name(const CaseGroup& group) {
  if (!group.direction) return group.name;
  const std::string_view word = name(*group.direction);
  if (!group.name.ends_with(word)) return group.name;
  std::string stem = group.name.substr(0, group.name.size() - word.size());
  while (!stem.empty() && std::string_view("-_ .").find(stem.back()) != std::string_view::npos) stem.pop_back();
  return stem.empty() ? group.name : stem;
}

constexpr std::size_t kMinNameWidth = 12;
constexpr std::string_view kGap = "  ";

/// Cells of the first columns, and possibly a remark that replaces the others.
struct Row {
  std::vector<std::string> cells;
  std::string remark;
};

Row case_row(const CaseTable& table, const LoadCaseResult& result) {
  Row row{{}, table.failure(result)};
  const std::size_t columns = row.remark.empty() ? table.columns.size() : table.load_columns;
  for (const auto c : up_to(columns)) row.cells.push_back(table.columns[c].cell(result));
  return row;
}

/// Adds first, middle and last point of a range, and the number of points.
void add_folded_rows(const CaseTable& table, const CaseGroup& group, std::vector<Row>& rows) {
  const std::size_t count = group.cases.size();
  for (const std::size_t k : {std::size_t{0}, count / 2, count - 1}) rows.push_back(case_row(table, *group.cases[k]));

  std::vector<std::string> failed;
  for (const LoadCaseResult* result : group.cases)
    if (!table.failure(*result).empty()) failed.push_back(case_name_cell(*result));
  std::string remark = fmt::format("… 3 of {} points; {}", count, all_in(table.file));
  if (!failed.empty()) remark += fmt::format("; NOT CONVERGED: {}", folded_names(failed));
  rows.push_back({{}, std::move(remark)});
}

std::vector<Row> header_rows(const CaseTable& table) {
  std::vector<Row> rows(2);
  for (const CaseColumn& column : table.columns) {
    rows[0].cells.emplace_back(column.title);
    rows[1].cells.push_back(with_table_unit(column.subtitle));
  }
  return rows;
}

std::vector<Row> table_rows(const CaseTable& table, const std::vector<LoadCaseResult>& results) {
  const bool fold = results.size() > kMaxUnfoldedCases;
  std::vector<Row> rows = header_rows(table);
  for (const CaseGroup& group : group_cases(results))
    if (fold && group.cases.size() > 3)
      add_folded_rows(table, group, rows);
    else
      for (const LoadCaseResult* result : group.cases) rows.push_back(case_row(table, *result));
  return rows;
}

/// Widths of the widest cells; names are shortened if the table would be too wide.
std::vector<std::size_t> column_widths(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().cells.size());
  for (const Row& row : rows)
    for (const auto c : indices(row.cells)) widths[c] = std::max(widths[c], width(row.cells[c]));
  std::size_t others = 0;
  for (std::size_t c = 1; c < widths.size(); ++c) others += kGap.size() + widths[c];
  const std::size_t room = kTableWidth - std::min(others, kTableWidth - kMinNameWidth);
  widths[0] = std::min(widths[0], room);
  return widths;
}

std::string row_line(const CaseTable& table, const Row& row, const std::vector<std::size_t>& widths) {
  std::string line;
  for (const auto c : indices(row.cells)) {
    line += fitted(row.cells[c], widths[c], table.columns[c].left_aligned);
    line += kGap;
  }
  return ended(line + (row.remark.empty() ? "" : shortened(row.remark, kTableWidth - width(line))));
}

/// A path without its leading load case.
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
  if (differs ? is_worse(warning, group.worst) : group.worst.load_case.empty()) group.worst = warning;
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
    if (group == groups.end()) group = groups.insert(group, {std::string(name.base), load.direction, {}});
    group->cases.push_back(&result);
  }
  return groups;
}

const CaseGroup* LoadedConfiguration::group(std::optional<Direction> direction) const {
  const auto found =
      std::find_if(groups.begin(), groups.end(), [&](const CaseGroup& g) { return g.direction == direction; });
  return found == groups.end() ? nullptr : &*found;
}

std::vector<LoadedConfiguration> loaded_configurations(const std::vector<LoadCaseResult>& results,
                                                       std::size_t min_points, bool (*keep)(const LoadCaseResult&)) {
  std::vector<LoadedConfiguration> found;
  for (CaseGroup& group : group_cases(results)) {
    std::erase_if(group.cases, [&](const LoadCaseResult* result) { return !keep(*result); });
    if (group.cases.size() < min_points) continue;
    const std::string name = configuration_name(group);
    auto it = std::find_if(found.begin(), found.end(),
                           [&](const LoadedConfiguration& c) { return c.name == name && !c.group(group.direction); });
    if (it == found.end()) it = found.insert(it, {name, {}});
    it->groups.push_back(std::move(group));
  }
  return found;
}

std::string folded_names(const std::vector<std::string>& names) {
  std::vector<std::pair<std::string_view, std::vector<int>>> bases;
  for (const std::string& full : names) {
    const PointName name = split(full);
    auto base = std::find_if(bases.begin(), bases.end(),
                             [&](const auto& b) { return name.point && b.first == name.base && !b.second.empty(); });
    if (base == bases.end()) base = bases.insert(base, {name.base, {}});
    if (name.point) base->second.push_back(*name.point);
  }
  std::vector<std::string> labels;
  for (const auto& [base, points] : bases)
    labels.push_back(points.empty() ? std::string(base) : fmt::format("{}[{}]", base, folded_points(points)));
  if (labels.size() > kMaxLabels) {
    const std::size_t others = labels.size() - kMaxLabels;
    labels.resize(kMaxLabels);
    labels.push_back(fmt::format("and {} more", others));
  }
  return fmt::to_string(fmt::join(labels, ", "));
}

std::string case_table(const CaseTable& table, const std::vector<LoadCaseResult>& results) {
  const std::vector<Row> rows = table_rows(table, results);
  const std::vector<std::size_t> widths = column_widths(rows);
  std::string text;
  for (const Row& row : rows) text += row_line(table, row, widths);
  return text;
}

std::string not_converged(const LoadCaseResult& result) {
  if (result.converged()) return {};
  return fmt::format("NOT CONVERGED ({}), residual {:.1e}", status_name(result), result.solve->relative_residual);
}

std::string case_name_cell(const LoadCaseResult& result) { return printable(result.load_case.name); }

std::string force_cell(const LoadCaseResult& result) {
  const double force = result.load_case.axial_force;
  return fixed(force, "kN", force_decimals(force));
}

std::string direction_cell(const LoadCaseResult& result) {
  const auto& d = result.load_case.direction;
  return std::string(d ? name(*d) : kAbsent);
}

std::string stiffness_cell(const LoadCaseResult& result) { return fixed(result.axial_stiffness, "N/µm", 1); }

std::string displacement_cell(const LoadCaseResult& result) { return fixed(result.axial_displacement, "µm", 2); }

std::string most_loaded_cell(const LoadCaseResult& result, Interface i) {
  if (!result.threads) return std::string(kAbsent);
  const std::vector<double>& rates = (*result.threads)[i].load_rate;
  const auto thread = index_of_largest(rates);
  if (!thread) return std::string(kAbsent);
  const auto& rollers = (*result.threads)[i].rollers;
  const std::string place =
      rollers ? fmt::format("{}.{}", rollers->largest_roller, rollers->largest_thread) : fmt::to_string(*thread + 1);
  return fmt::format("{}: {:5.2f}", place, rates[*thread] * "%"_per_si);
}

std::string pressure_cell(const LoadCaseResult& result) {
  double peak = 0.0;
  std::string cell(kAbsent);
  if (!result.threads) return cell;
  for (const Interface i : kInterfaces)
    for (const double pressure : (*result.threads)[i].peak_pressure)
      if (pressure > peak) {
        peak = pressure;
        cell = fmt::format("{} {:5}", fixed(pressure, "GPa", 3), name(i));
      }
  return cell;
}

int force_decimals(double force) {
  constexpr double kSmall = 10.0;  // [N]
  return force != 0.0 && std::abs(force) < kSmall ? 6 : 3;
}

std::string WarningGroup::text() const {
  if (differs || !several_paths) return table_sentence(worst);
  Warning all = worst;
  all.path = "load_cases[..]" + without_load_case(worst.path);
  return table_sentence(all);
}

std::string WarningGroup::where() const {
  if (cases.empty()) return {};
  const std::size_t others = cases.size() - 1;
  if (!differs || others == 0 || worst.load_case.empty()) return fmt::format("in {}", folded_names(cases));
  return fmt::format("worst in {}, and {} other load case{}", worst.load_case, others, others == 1 ? "" : "s");
}

std::vector<WarningGroup> grouped(const std::vector<Warning>& warnings) {
  std::vector<WarningGroup> groups;
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  std::set<std::pair<std::size_t, std::string>> named;
  for (const Warning& warning : warnings) {
    const auto [at, is_new] = known.try_emplace({warning.code, without_load_case(warning.path)}, groups.size());
    if (is_new)
      groups.push_back({warning});
    else
      add(warning, groups[at->second]);
    if (!warning.load_case.empty() && named.emplace(at->second, warning.load_case).second)
      groups[at->second].cases.push_back(warning.load_case);
  }
  return groups;
}

std::vector<Warning> all_warnings(std::vector<Warning> of_case, const std::vector<LoadCaseResult>& load_cases) {
  for (const LoadCaseResult& load : load_cases)
    for (const Warning& warning : load.warnings) of_case.emplace_back(warning).load_case = load.load_case.name;
  return of_case;
}

std::vector<Warning> all_warnings(const Result& result) { return all_warnings(result.warnings, result.load_cases); }

std::string warning_summary(const std::vector<Warning>& warnings) {
  std::string summary;
  for (const bool assumptions : {false, true}) {
    const std::vector<WarningGroup> groups = grouped(selected(warnings, assumptions));
    if (groups.empty()) continue;
    summary += fmt::format("{}{}\n", summary.empty() ? "" : "\n", assumptions ? kAssumptionsTitle : "Warnings");
    for (const WarningGroup& group : groups) {
      summary += wrapped(printable(group.text()), "  ", kTableWidth);
      if (const std::string where = group.where(); !where.empty())
        summary += wrapped(printable(where), "    ", kTableWidth);
    }
  }
  return summary;
}

std::string warning_section(const std::vector<Warning>& warnings) {
  return warnings.empty() ? "" : '\n' + warning_summary(warnings);
}

}  // namespace prs
