#include "prs/output/study_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "prs/output/case_table.h"
#include "prs/output/response_title.h"
#include "prs/output/text.h"

namespace prs {
namespace {

constexpr std::size_t kMostRows = 24;  // Of a factor.
constexpr std::size_t kMostReasons = 8;
constexpr std::size_t kMaxValueWidth = 28;
constexpr std::size_t kLongNumber = 14;
constexpr std::size_t kMinCell = 9;
constexpr std::string_view kGap = "  ";
constexpr std::string_view kBaseMark = "as in the file";

/// A response over two lines, the unit at the end.
struct Heading {
  std::string upper, lower;
};

/// Two lines of about the same width.
Heading broken(const std::string& text) {
  Heading best{text, ""};
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1)) {
    const Heading h{text.substr(0, at), text.substr(at + 1)};
    if (std::max(width(h.upper), width(h.lower)) < std::max(width(best.upper), width(best.lower)))
      best = h;
  }
  return best;
}

Heading heading(const std::string& path) {
  const ResponseTitle title = response_title(path);
  return broken(title.unit.empty() ? title.name : fmt::format("{} {}", title.name, title.unit));
}

/// As it is written, long numbers with six digits.
std::string value_text(const Level& level, const std::string& unit) {
  const std::string text = printable(level.text);
  if (!level.number || width(text) <= kLongNumber || text.starts_with('{')) return text;
  return fmt::format("{:.6g}{}{}", *level.number, unit.empty() ? "" : " ", printable(unit));
}

struct Columns {
  std::vector<Heading> headings;
  std::vector<std::size_t> widths;
  std::size_t value_width = 0;
};

/// The responses that fit beside the values.
Columns columns_of(const StudyResult& result) {
  Columns columns;
  columns.value_width = width(kBaseMark);
  for (const StudyRow& row : result.rows)
    for (const auto& [factor, level] : row.design.settings)
      columns.value_width = std::max(
          columns.value_width, width(value_text(level, result.study.factors[factor].unit)) + 2);
  columns.value_width = std::min(columns.value_width, kMaxValueWidth);
  std::size_t used = columns.value_width;
  for (const std::string& path : result.study.responses) {
    const Heading h = heading(path);
    const std::size_t w = std::max({kMinCell, width(h.upper), width(h.lower)});
    if (used + kGap.size() + w > kTableWidth) break;
    used += kGap.size() + w;
    columns.headings.push_back(h);
    columns.widths.push_back(w);
  }
  return columns;
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.5g}", *value) : std::string(kAbsent);
}

std::string row_line(const Columns& columns, const std::string& value, const StudyRow& row) {
  std::string line = padded(shortened(value, columns.value_width), columns.value_width, true);
  if (!row.status.converged()) return fmt::format("{}{}{}\n", line, kGap, row.status.name);
  for (std::size_t c = 0; c < columns.widths.size(); ++c)
    line.append(kGap).append(padded(number(row.responses[c]), columns.widths[c], false));
  return line + '\n';
}

std::string header_lines(const Columns& columns) {
  std::string upper(columns.value_width, ' '), lower = upper;
  for (std::size_t c = 0; c < columns.widths.size(); ++c) {
    upper.append(kGap).append(padded(columns.headings[c].upper, columns.widths[c], false));
    lower.append(kGap).append(padded(columns.headings[c].lower, columns.widths[c], false));
  }
  return upper + '\n' + lower + '\n';
}

/// A row of a factor's table.
struct TableRow {
  const Level* level = nullptr;
  const StudyRow* row = nullptr;
  bool is_base = false;
};

/// The levels of one factor in their order. The base case, unless it is one of them, comes where
/// ascending levels have room for it, else at the end.
std::vector<TableRow> rows_of(const StudyResult& result, std::size_t index) {
  const Factor& factor = result.study.factors[index];
  std::vector<TableRow> rows;
  for (const StudyRow& row : result.rows)
    if (!row.design.settings.empty() && row.design.settings[0].factor == index)
      rows.push_back({&row.design.settings[0].level, &row, is_base(result.study, row.design)});
  if (!factor.base || std::ranges::any_of(rows, &TableRow::is_base)) return rows;
  const auto is_above = [&](const TableRow& row) {
    return factor.base->number && row.level->number && *row.level->number > *factor.base->number;
  };
  rows.insert(std::ranges::find_if(rows, is_above), {&*factor.base, &result.base(), true});
  return rows;
}

std::string factor_table(const StudyResult& result, std::size_t index, const Columns& columns) {
  const Factor& factor = result.study.factors[index];
  const std::vector<TableRow> rows = rows_of(result, index);
  std::string title = printable(factor.label);
  if (factor.label != factor.path) title += fmt::format(" ({})", printable(factor.path));
  std::string text = shortened(title, kTableWidth) + '\n';
  const std::size_t step = (rows.size() + kMostRows - 1) / kMostRows;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto& [level, row, base] = rows[k];
    if (k % step != 0 && k + 1 != rows.size() && !base) continue;
    const std::string value = value_text(*level, factor.unit);
    text += row_line(columns, fmt::format("{} {}", base ? '*' : ' ', value), *row);
  }
  if (step > 1) text += fmt::format("  … of {} values; all in study.csv\n", factor.levels.size());
  return text;
}

std::string design_name(const Study& study, const Design& design) {
  std::string name;
  for (const std::string& setting : overrides(study, design))
    name += fmt::format("{}{}", name.empty() ? "" : ", ", printable(setting));
  return name.empty() ? std::string(kBaseMark) : name;
}

/// What is wrong with the designs that have no answer.
std::string failures(const StudyResult& result) {
  std::string text;
  std::size_t failed = 0;
  for (const StudyRow& row : result.rows) {
    if (row.status.converged() || ++failed > kMostReasons) continue;
    text += wrapped(fmt::format("{} {}: {}", design_name(result.study, row.design), row.status.name,
                                printable(row.status.reason)),
                    "  ", kTableWidth);
  }
  if (failed == 0) return text;
  if (failed > kMostReasons)
    text += fmt::format("  … and {} more in study.csv\n", failed - kMostReasons);
  return fmt::format("\n{} of {} designs without an answer\n{}", failed, result.rows.size(), text);
}

}  // namespace

std::string study_table(const StudyResult& result) {
  const Columns columns = columns_of(result);
  std::string text = header_lines(columns);
  text += row_line(columns, std::string(kBaseMark), result.base());
  for (std::size_t k = 0; k < result.study.factors.size(); ++k)
    text.append("\n").append(factor_table(result, k, columns));
  text += fmt::format("\n* as in the file");
  if (columns.headings.size() < result.study.responses.size())
    text += fmt::format("; {} more responses in study.csv",
                        result.study.responses.size() - columns.headings.size());
  return text + '\n' + failures(result);
}

std::string progress_line(std::size_t done, std::size_t total, double seconds) {
  const double rate = seconds > 0.0 ? static_cast<double>(done) / seconds : 0.0;
  std::string text = fmt::format("{} of {} designs", done, total);
  if (!(rate > 0.0)) return text;
  text +=
      rate < 10.0 ? fmt::format(", {:.1f} a second", rate) : fmt::format(", {:.0f} a second", rate);
  const long left = std::lround(std::ceil(static_cast<double>(total - done) / rate));
  if (left >= 3600)
    return text + fmt::format(", {}:{:02}:{:02} left", left / 3600, left / 60 % 60, left % 60);
  return text + fmt::format(", {}:{:02} left", left / 60, left % 60);
}

}  // namespace prs
