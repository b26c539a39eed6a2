#include "prs/output/measures_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "prs/quantities/measure_quantities.h"
#include "prs/model/units.h"
#include "prs/output/case_table.h"
#include "prs/output/csv_writer.h"
#include "prs/quantities/response_title.h"
#include "prs/text.h"
#include "prs/output/warnings.h"

namespace prs {
namespace {

constexpr std::size_t kTitleWidth = 62;
constexpr std::size_t kCellWidth = 16;
constexpr std::size_t kMostCases = 3;  ///< That fit beside each other.

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Five digits, of large numbers all before the point.
std::string cell(double shown) {
  if (!std::isfinite(shown)) return std::string(kAbsent);
  return std::abs(shown) >= 1e4 && std::abs(shown) < 1e9 ? fmt::format("{:.0f}", shown)
                                                         : fmt::format("{:.5g}", shown);
}

/// What documents show; not finite where the measure is absent.
template <class Quantity, class Owner>
double shown_value(const Quantity& q, const Owner& measures) {
  return q.value(measures).value_or(kNone) * q.factor;
}

std::string titled(std::string_view title, std::string_view key) {
  const std::string unit = response_title(key).unit;
  return fmt::format("  {}{}{}", title, unit.empty() ? "" : ", ", unit);
}

/// Starts the group of a measure where the one before belongs to another.
void add_group(std::string& text, std::string_view& group, std::string_view next) {
  if (group == next) return;
  group = next;
  text += fmt::format("{}{}\n", text.empty() ? "" : "\n", group);
}

std::string mechanism_table(const Measures& measures) {
  std::string text;
  std::string_view group;
  for (const DesignMeasure& q : kDesignMeasures) {
    const double value = shown_value(q, measures);
    if (!std::isfinite(value)) continue;
    add_group(text, group, q.group);
    text += padded(titled(q.title, q.key), kTitleWidth, true) +
            padded(cell(value), kCellWidth, false) + '\n';
  }
  return text;
}

std::string limit_rows(const MeasuresResult& result, std::size_t first, std::size_t last) {
  std::string text;
  for (const LimitMeasure& q : kLimitMeasures) {
    std::string cells;
    bool any = false;
    for (std::size_t k = first; k < last; ++k) {
      const std::optional<LoadMeasures>& measures = result.load_measures[k];
      const std::optional<StaticLimit> limit = measures ? (*measures).*q.value : std::nullopt;
      any = any || limit;
      cells += padded(limit ? name(*limit) : std::string(kAbsent), kCellWidth, false);
    }
    if (any) text += padded(fmt::format("  {}", q.title), kTitleWidth, true) + cells + '\n';
  }
  return text;
}

/// The load cases [first, last) side by side.
std::string load_table(const MeasuresResult& result, std::size_t first, std::size_t last) {
  std::string text = padded("Load case", kTitleWidth, true);
  for (std::size_t k = first; k < last; ++k)
    text += ' ' + padded(shortened(printable(result.analysis.load_cases[k].load_case.name),
                                   kCellWidth - 1),
                         kCellWidth - 1, false);
  text += '\n' + padded("  force, kN", kTitleWidth, true);
  for (std::size_t k = first; k < last; ++k)
    text += padded(cell(result.analysis.load_cases[k].load_case.axial_force * per_si::kilonewton),
                   kCellWidth, false);
  text += '\n';
  std::string_view group;
  for (const LoadMeasure& q : kLoadMeasures) {
    std::string cells;
    bool any = false;
    for (std::size_t k = first; k < last; ++k) {
      const std::optional<LoadMeasures>& measures = result.load_measures[k];
      const double value = measures ? shown_value(q, *measures) : kNone;
      any = any || std::isfinite(value);
      cells += padded(cell(value), kCellWidth, false);
    }
    if (!any) continue;
    if (group == measure_text::kStrength && q.group != group)
      text += limit_rows(result, first, last);
    add_group(text, group, q.group);
    text += padded(titled(q.title, q.key), kTitleWidth, true) + cells + '\n';
  }
  return text;
}

/// A paragraph behind a word; its later lines stand below the first.
std::string paragraph(std::string_view word, std::string_view text) {
  const std::string indent(4 + word.size(), ' ');
  std::string lines = wrapped(text, indent, kTableWidth);
  return lines.replace(4, word.size(), word);
}

std::string explanation(const auto& q) {
  return fmt::format("{}\n", q.key) + paragraph("", q.title) + paragraph("formula: ", q.formula) +
         paragraph("valid: ", q.validity) + paragraph("source: ", q.source);
}

}  // namespace

std::string measures_table(const MeasuresResult& result) {
  std::string text = mechanism_table(result.measures);
  const std::size_t cases = result.load_measures.size();
  for (std::size_t first = 0; first < cases; first += kMostCases)
    text += '\n' + load_table(result, first, std::min(first + kMostCases, cases));
  text += "\nFormulas, validity and sources: prs measures --explain\n";
  const std::string warnings = warning_summary(result.analysis);
  return warnings.empty() ? text : text + '\n' + warnings;
}

std::string measure_explanations() {
  std::string text = "Measures of the mechanism: `measures` in documents\n\n";
  for (const DesignMeasure& q : kDesignMeasures) text += explanation(q);
  text += "\nMeasures of a load case: `load_cases[].measures` in documents\n\n";
  for (const LoadMeasure& q : kLoadMeasures) text += explanation(q);
  for (const LimitMeasure& q : kLimitMeasures) text += explanation(q);
  for (const ThreadMeasure& q : kThreadMeasures) text += explanation(q);
  return text;
}

std::string measures_csv(const MeasuresResult& result) {
  CsvWriter csv;
  for (const std::string_view name : {"load_case", "measure", "unit", "value"}) csv.text(name);
  csv.end_row();
  const auto row = [&](std::string_view load_case, std::string_view key, double value) {
    if (!std::isfinite(value)) return;
    csv.text(load_case);
    csv.text(key);
    csv.text(response_title(key).unit);
    csv.number(value);
    csv.end_row();
  };
  for (const DesignMeasure& q : kDesignMeasures) row("", q.key, shown_value(q, result.measures));
  for (std::size_t k = 0; k < result.load_measures.size(); ++k)
    if (result.load_measures[k])
      for (const LoadMeasure& q : kLoadMeasures)
        row(result.analysis.load_cases[k].load_case.name, q.key,
            shown_value(q, *result.load_measures[k]));
  return csv.take();
}

std::string yang_csv(const MeasuresResult& result) {
  CsvWriter csv;
  load_header(csv);
  for (const std::string_view name :
       {"thread", "yang_load_rate_percent", "screw_load_rate_percent", "nut_load_rate_percent"})
    csv.text(name);
  csv.end_row();
  for (std::size_t k = 0; k < result.load_measures.size(); ++k) {
    const LoadCaseResult& solved = result.analysis.load_cases[k];
    if (!result.load_measures[k] || !solved.threads) continue;
    const std::vector<double>& yang = result.load_measures[k]->yang_load_rate;
    for (std::size_t thread = 0; thread < yang.size(); ++thread) {
      load_fields(csv, solved.load_case);
      csv.integer(thread + 1);
      csv.number(yang[thread], per_si::percent);
      for (const Interface i : kInterfaces)
        csv.number((*solved.threads)[i].load_rate[thread], per_si::percent);
      csv.end_row();
    }
  }
  return csv.take();
}

}  // namespace prs
