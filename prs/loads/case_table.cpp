#include "prs/loads/case_table.h"

#include "prs/loads/case_groups.h"
#include "prs/loads/load_record.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kMinNameWidth = 12;
constexpr std::string_view kGap = "  ";

/// Cells of the first columns, then perhaps a remark in place of the others.
struct Row {
  std::vector<std::string> cells;
  std::string remark;
};

Row case_row(const CaseTable& table, const LoadCaseResult& result) {
  Row row{{}, table.failure(result)};
  const std::size_t columns = row.remark.empty() ? table.columns.size() : table.load_columns;
  for (std::size_t c = 0; c < columns; ++c) row.cells.push_back(table.columns[c].cell(result));
  return row;
}

/// First, middle and last point of a range, and how many there are.
void add_folded_rows(const CaseTable& table, const CaseGroup& group, std::vector<Row>& rows) {
  const std::size_t count = group.cases.size();
  for (const std::size_t k : {std::size_t{0}, count / 2, count - 1})
    rows.push_back(case_row(table, *group.cases[k]));

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

/// As wide as the widest cell; the names give way where the table would be too wide.
std::vector<std::size_t> column_widths(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().cells.size());
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.cells.size(); ++c)
      widths[c] = std::max(widths[c], width(row.cells[c]));
  std::size_t others = 0;
  for (std::size_t c = 1; c < widths.size(); ++c) others += kGap.size() + widths[c];
  const std::size_t room = kTableWidth - std::min(others, kTableWidth - kMinNameWidth);
  widths[0] = std::min(widths[0], room);
  return widths;
}

std::string row_line(const CaseTable& table, const Row& row,
                     const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t c = 0; c < row.cells.size(); ++c) {
    line += fitted(row.cells[c], widths[c], table.columns[c].left_aligned);
    line += kGap;
  }
  return ended(line + (row.remark.empty() ? "" : shortened(row.remark, kTableWidth - width(line))));
}

}  // namespace

std::string case_table(const CaseTable& table, const std::vector<LoadCaseResult>& results) {
  const std::vector<Row> rows = table_rows(table, results);
  const std::vector<std::size_t> widths = column_widths(rows);
  std::string text;
  for (const Row& row : rows) text += row_line(table, row, widths);
  return text;
}

std::string not_converged(const LoadCaseResult& result) {
  if (result.converged()) return {};
  return fmt::format("NOT CONVERGED ({}), residual {:.1e}", status_name(result),
                     result.solve->relative_residual);
}

std::string case_name_cell(const LoadCaseResult& result) {
  return printable(result.load_case.name);
}

std::string force_cell(const LoadCaseResult& result) {
  const double force = result.load_case.axial_force;
  return fixed(force, "kN", force_decimals(force));
}

std::string direction_cell(const LoadCaseResult& result) {
  const auto& d = result.load_case.direction;
  return std::string(d ? name(*d) : kAbsent);
}

std::string stiffness_cell(const LoadCaseResult& result) {
  return fixed(result.axial_stiffness, "N/µm", 1);
}

std::string displacement_cell(const LoadCaseResult& result) {
  return fixed(result.axial_displacement, "µm", 2);
}

std::string most_loaded_cell(const LoadCaseResult& result, Interface i) {
  if (!result.threads) return std::string(kAbsent);
  const std::vector<double>& rates = (*result.threads)[i].load_rate;
  const auto thread = index_of_largest(rates);
  if (!thread) return std::string(kAbsent);
  const auto& rollers = (*result.threads)[i].rollers;
  const std::string place =
      rollers ? fmt::format("{}.{}", rollers->largest_roller, rollers->largest_thread)
              : fmt::to_string(*thread + 1);
  return fmt::format("{}: {:5.2f}", place, rates[*thread] * per_si::percent);
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

}  // namespace prs
