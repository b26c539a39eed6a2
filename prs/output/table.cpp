#include "prs/output/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "prs/output/case_groups.h"
#include "prs/output/quantities.h"
#include "prs/output/text.h"
#include "prs/output/warnings.h"

namespace prs {
namespace {

constexpr std::size_t kTableWidth = 110;
constexpr std::size_t kMinNameWidth = 12;
constexpr std::size_t kMaxUnfoldedCases = 24;
constexpr std::string_view kAbsent = "–";
constexpr std::string_view kGap = "  ";

std::string fixed(std::optional<double> si, double factor, int decimals) {
  return si ? fmt::format("{:.{}f}", *si * factor, decimals) : std::string(kAbsent);
}

std::string case_name(const LoadCaseResult& result) { return printable(result.load_case.name); }

std::string force(const LoadCaseResult& result) {
  return fixed(result.load_case.axial_force, per_si::kilonewton, 3);
}

std::string direction(const LoadCaseResult& result) {
  const auto& d = result.load_case.direction;
  return std::string(d ? name(*d) : kAbsent);
}

std::string stiffness(const LoadCaseResult& result) {
  return fixed(result.axial_stiffness, per_si::newton_per_micrometre, 1);
}

std::string displacement(const LoadCaseResult& result) {
  return fixed(result.axial_displacement, per_si::micrometre, 2);
}

template <Interface interface>
std::string most_loaded_thread(const LoadCaseResult& result) {
  if (!result.threads) return std::string(kAbsent);
  const std::vector<double>& rates = (*result.threads)[interface].load_rate;
  const auto thread = index_of_largest(rates);
  if (!thread) return std::string(kAbsent);
  return fmt::format("{}: {:5.2f}", *thread + 1, rates[*thread] * per_si::percent);
}

std::string peak_pressure(const LoadCaseResult& result) {
  double peak = 0.0;
  std::string cell(kAbsent);
  if (!result.threads) return cell;
  for (const Interface i : kInterfaces)
    for (const double pressure : (*result.threads)[i].peak_pressure)
      if (pressure > peak) {
        peak = pressure;
        cell = fmt::format("{:.3f} {:5}", pressure * per_si::gigapascal, name(i));
      }
  return cell;
}

std::string iterations(const LoadCaseResult& result) {
  return result.solve ? fmt::to_string(result.solve->iterations()) : std::string(kAbsent);
}

struct Column {
  std::string_view title;
  std::string_view subtitle;
  bool left_aligned;
  std::string (*cell)(const LoadCaseResult&);
};

constexpr Column kColumns[] = {
    {"", "load case", true, case_name},
    {"force", "kN", false, force},
    {"", "direction", true, direction},
    {"stiffness", "N/µm", false, stiffness},
    {"displ.", "µm", false, displacement},
    {"screw max.", "thread: %", false, most_loaded_thread<Interface::screw>},
    {"nut max.", "thread: %", false, most_loaded_thread<Interface::nut>},
    {"pressure", "max. GPa", true, peak_pressure},
    {"Newton", "steps", false, iterations},
};
/// The first columns say what the load is; a failed case has no others.
constexpr std::size_t kLoadColumns = 3;

/// Cells of the first columns, then perhaps a remark in place of the others.
struct Row {
  std::vector<std::string> cells;
  std::string remark;
};

Row case_row(const LoadCaseResult& result) {
  Row row;
  const std::size_t columns = result.converged() ? std::size(kColumns) : kLoadColumns;
  for (std::size_t c = 0; c < columns; ++c) row.cells.push_back(kColumns[c].cell(result));
  if (!result.converged())
    row.remark = fmt::format("NOT CONVERGED ({}), residual {:.1e}", status_name(result),
                             result.solve->relative_residual);
  return row;
}

/// First, middle and last point of a range, and how many there are.
void add_folded_rows(const CaseGroup& group, std::vector<Row>& rows) {
  const std::size_t count = group.cases.size();
  for (const std::size_t k : {std::size_t{0}, count / 2, count - 1})
    rows.push_back(case_row(*group.cases[k]));

  std::vector<std::string> failed;
  for (const LoadCaseResult* result : group.cases)
    if (!result->converged()) failed.push_back(case_name(*result));
  std::string remark = fmt::format("… 3 of {} points; all in load_cases.csv", count);
  if (!failed.empty()) remark += fmt::format("; NOT CONVERGED: {}", folded_names(failed));
  rows.push_back({{}, std::move(remark)});
}

std::vector<Row> header_rows() {
  std::vector<Row> rows(2);
  for (const Column& column : kColumns) {
    rows[0].cells.emplace_back(column.title);
    rows[1].cells.emplace_back(column.subtitle);
  }
  return rows;
}

std::vector<Row> table_rows(const std::vector<LoadCaseResult>& results) {
  const bool fold = results.size() > kMaxUnfoldedCases;
  std::vector<Row> rows = header_rows();
  for (const CaseGroup& group : group_cases(results))
    if (fold && group.cases.size() > 3)
      add_folded_rows(group, rows);
    else
      for (const LoadCaseResult* result : group.cases) rows.push_back(case_row(*result));
  return rows;
}

/// As wide as the widest cell; the names give way where the table would be too wide.
std::vector<std::size_t> column_widths(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(std::size(kColumns));
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.cells.size(); ++c)
      widths[c] = std::max(widths[c], width(row.cells[c]));
  std::size_t others = 0;
  for (std::size_t c = 1; c < widths.size(); ++c) others += kGap.size() + widths[c];
  const std::size_t room = kTableWidth - std::min(others, kTableWidth - kMinNameWidth);
  widths[0] = std::min(widths[0], room);
  return widths;
}

std::string padded(const std::string& text, std::size_t columns, bool left_aligned) {
  const std::string space(columns - std::min(columns, width(text)), ' ');
  return left_aligned ? text + space : space + text;
}

std::string row_line(const Row& row, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t c = 0; c < row.cells.size(); ++c) {
    line += padded(shortened(row.cells[c], widths[c]), widths[c], kColumns[c].left_aligned);
    line += kGap;
  }
  line += row.remark.empty() ? "" : shortened(row.remark, kTableWidth - width(line));
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

// Bars of the chart.
constexpr int kBarCells = 36;
constexpr std::size_t kBarColumn = kBarCells + 9;
constexpr std::string_view kEighths[] = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};

/// A bar to an eighth of a character, and its value. The largest rate has the full length.
std::string bar(double rate, double largest) {
  const double share = largest > 0.0 ? std::clamp(rate / largest, 0.0, 1.0) : 0.0;
  const auto [cells, eighths] = std::div(static_cast<int>(std::lround(8 * kBarCells * share)), 8);
  std::string text;
  for (int k = 0; k < cells; ++k) text += "█";
  text += kEighths[eighths];
  return fmt::format("{} {:.2f} %", text, rate * per_si::percent);
}

double largest_rate(const PerInterface<InterfaceLoads>& threads) {
  double largest = 0.0;
  for (const Interface i : kInterfaces)
    for (const double rate : threads[i].load_rate) largest = std::max(largest, rate);
  return largest;
}

}  // namespace

std::string load_case_table(const Result& result) {
  const std::vector<Row> rows = table_rows(result.load_cases);
  const std::vector<std::size_t> widths = column_widths(rows);
  std::string table;
  for (const Row& row : rows) table += row_line(row, widths);
  const std::string warnings = warning_summary(result);
  return warnings.empty() ? table : table + '\n' + warnings;
}

std::string load_distribution_chart(const LoadCaseResult& result) {
  const std::string title = case_name(result);
  if (!result.threads)
    return fmt::format("{}: no load distribution ({})\n", title, status_name(result));

  const PerInterface<InterfaceLoads>& threads = *result.threads;
  const double largest = largest_rate(threads);
  const std::size_t count = threads.screw.load_rate.size();
  std::string chart = fmt::format("{}: share of each thread, mean {:.2f} %\n", title,
                                  per_si::percent / static_cast<double>(count));
  chart += fmt::format("     {}  nut\n", padded("screw", kBarColumn, true));
  for (std::size_t k = 0; k < count; ++k)
    chart += fmt::format("{:3}  {}  {}\n", k + 1,
                         padded(bar(threads.screw.load_rate[k], largest), kBarColumn, true),
                         bar(threads.nut.load_rate[k], largest));
  return chart;
}

}  // namespace prs
