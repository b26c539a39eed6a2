#include "prs/measures/measures_analysis.h"

#include "prs/loads/case_table.h"
#include "prs/loads/warnings.h"
#include "prs/measures/measures_record.h"
#include "prs/model/units.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr TableRows kRows{58, 14};
constexpr std::size_t kMostCases = 3;  ///< That fit side by side.

/// What documents have in newtons and single revolutions is that large here.
ShownUnit row_unit(const ShownUnit& unit) {
  if (unit.text == "N") return table_unit("kN");
  if (unit.text == "revolutions") return {"", "10^6 revolutions", 1e-6};
  return table_unit(unit);
}

/// A number or a text; none where the measure is absent.
template <class Owner>
std::optional<std::string> measure_cell(const Quantity<Owner>& q,
                                        const std::optional<Owner>& measures) {
  if (!measures) return std::nullopt;
  if (q.value.number) {
    const std::optional<double> shown = shown_number(q, *measures);
    return shown ? std::optional(significant(*shown * row_unit(q.unit).factor / q.unit.factor))
                 : std::nullopt;
  }
  const auto json = q.value.json(*measures, q.unit);
  return json.is_null() ? std::nullopt
                        : std::optional(words_of_text(json.template get<std::string>()));
}

/// The headings in the order of the table.
template <class Owner>
std::vector<std::string_view> groups_of() {
  std::vector<std::string_view> groups;
  for (const Quantity<Owner>& q : record_of<Owner>().quantities)
    if (std::ranges::find(groups, q.group) == groups.end()) groups.push_back(q.group);
  return groups;
}

using Keys = std::vector<std::string>;

/// Numbers and words group by group, `owners` side by side; what none of them has is left out, and
/// the `hidden` keys.
template <class Owner>
std::string group_rows(std::span<const std::optional<Owner>> owners, const Keys& hidden) {
  std::string text;
  for (const std::string_view group : groups_of<Owner>()) {
    std::string rows;
    for (const Quantity<Owner>& q : record_of<Owner>().quantities) {
      if (q.group != group || q.value.series || q.value.kind == Kind::record) continue;
      if (std::ranges::find(hidden, q.key) != hidden.end()) continue;
      std::vector<std::string> cells;
      bool any = false;
      for (const std::optional<Owner>& owner : owners) {
        const std::optional<std::string> shown = measure_cell(q, owner);
        any = any || shown;
        cells.push_back(shown.value_or(std::string(kAbsent)));
      }
      const std::string_view unit = row_unit(q.unit).text;
      if (any)
        rows += kRows(fmt::format("  {}{}{}", q.title, unit.empty() ? "" : ", ", unit), cells);
    }
    if (!rows.empty()) text += fmt::format("{}{}\n", text.empty() ? "" : "\n", group) + rows;
  }
  return text;
}

/// The parts of an axis that a case has, with their keys.
std::vector<std::pair<std::string_view, SystemStiffness::Contribution>> parts_of_axis(
    const SystemStiffness& axis) {
  const SystemStiffness::Contributions& c = axis.contributions;
  const std::optional<SystemStiffness::Contribution>* parts[] = {&c.mechanism, &c.shaft, &c.wind_up,
                                                                 &c.support_bearing, &c.housing};
  std::vector<std::pair<std::string_view, SystemStiffness::Contribution>> all;
  for (std::size_t k = 0; k < std::size(parts); ++k)
    if (*parts[k])
      all.emplace_back(record_of<SystemStiffness::Contributions>().quantities[k].key, **parts[k]);
  return all;
}

/// Stiffness of the axis and what its parts have of the compliance; all cases have the same parts.
std::string axis_rows(std::span<const std::optional<LoadMeasures>> owners) {
  std::vector<std::string> total;
  std::vector<std::pair<std::string, std::vector<std::string>>> rows;
  for (std::size_t k = 0; k < owners.size(); ++k) {
    const bool known = owners[k] && owners[k]->system_stiffness;
    total.push_back(known ? significant(shown(owners[k]->system_stiffness->total, "N/µm"))
                          : std::string(kAbsent));
    if (!known) continue;
    for (const auto& [key, part] : parts_of_axis(*owners[k]->system_stiffness)) {
      const auto row = std::ranges::find(rows, key, [](const auto& r) { return r.first; });
      auto& cells = row == rows.end()
                        ? rows.emplace_back(key, std::vector<std::string>(owners.size(),
                                                                          std::string(kAbsent)))
                              .second
                        : row->second;
      cells[k] = significant(part.share * per_si::percent);
    }
  }
  if (rows.empty()) return {};
  std::string text = "\nThe axis\n" + kRows(with_table_unit("  all parts in series, N/µm"), total);
  for (const auto& [key, cells] : rows)
    text += kRows(fmt::format("  {}, % of the compliance", words_of(key)), cells);
  return text;
}

/// The load cases [first, last) side by side.
std::string load_table(const MeasuresResult& result, std::size_t first, std::size_t last,
                       const Keys& hidden) {
  std::vector<std::string> names, forces;
  for (std::size_t k = first; k < last; ++k) {
    const LoadCase& load = result.analysis.load_cases[k].load_case;
    names.push_back(shortened(printable(load.name), kRows.cell_width - 1));
    forces.push_back(significant(shown(load.axial_force, "kN")));
  }
  const std::string text =
      kRows("Load case", names) + kRows(with_table_unit("  force, kN"), forces);
  const auto measures = std::span(result.load_measures).subspan(first, last - first);
  const std::string rows = group_rows(measures, hidden);
  return text + (rows.empty() ? "" : '\n' + rows) + axis_rows(measures);
}

/// A paragraph behind a word.
std::string paragraph(const std::string& word, std::string_view text) {
  return hanging("    " + word, 4 + word.size(), text);
}

template <class Owner>
std::string explanations() {
  std::string text;
  for (const Quantity<Owner>& q : record_of<Owner>().quantities)
    text += fmt::format("{}\n", q.key) + paragraph("", q.title) +
            paragraph("formula: ", q.meaning) + paragraph("valid: ", q.validity) +
            paragraph("source: ", q.source);
  return text;
}

template <class Owner>
void add_rows(CsvWriter& csv, std::string_view load_case, const Owner& measures) {
  for (const Quantity<Owner>& q : record_of<Owner>().quantities) {
    const std::optional<double> value = q.value.number ? shown_number(q, measures) : std::nullopt;
    if (!value) continue;
    csv.row(load_case, q.key, q.unit.text, value);
  }
}

std::string table_without(const MeasuresResult& result, const Keys& hidden) {
  const std::optional<Measures> measures[] = {result.measures};
  std::string text = group_rows<Measures>(measures, hidden);
  const std::size_t cases = result.load_measures.size();
  for (std::size_t first = 0; first < cases; first += kMostCases)
    text += '\n' + load_table(result, first, std::min(first + kMostCases, cases), hidden);
  text += "\nFormulas, validity and sources: prs measures --explain\n";
  if (!hidden.empty())
    text +=
        "Estimates of what prs slip and prs life compute, and with equal shares: prs measures "
        "--all\n";
  return text + warning_section(all_warnings(result.analysis));
}

}  // namespace

std::vector<std::string> estimates_in(const MeasuresResult& result) {
  const auto known = [&](auto member) {
    return std::ranges::any_of(result.load_measures,
                               [&](const auto& m) { return m && (*m).*member; });
  };
  const bool solved = known(&LoadMeasures::solved_static_safety);
  const bool loaded = std::ranges::any_of(
      result.analysis.load_cases, [](const LoadCaseResult& r) { return r.threads.has_value(); });
  return estimates_beside({result.slips, result.lives, solved,
                           solved || known(&LoadMeasures::thread_static_safety), loaded});
}

std::string measures_table(const MeasuresResult& result) {
  return table_without(result, estimates_in(result));
}

std::string full_measures_table(const MeasuresResult& result) { return table_without(result, {}); }

std::string measure_explanations() {
  return "Measures of the mechanism: `measures` in documents\n\n" + explanations<Measures>() +
         "\nMeasures of a load case: `load_cases[].measures` in documents\n\n" +
         explanations<LoadMeasures>();
}

std::string measures_csv(const MeasuresResult& result, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.row("load_case", "measure", "unit", "value");
  add_rows(csv, "", result.measures);
  for (std::size_t k = 0; k < result.load_measures.size(); ++k)
    if (result.load_measures[k]) {
      const std::string& name = result.analysis.load_cases[k].load_case.name;
      const LoadMeasures& measures = *result.load_measures[k];
      add_rows(csv, name, measures);
      if (!measures.system_stiffness) continue;
      csv.row(name, "system_stiffness.total_N_per_um", "N/µm",
              shown(measures.system_stiffness->total, "N/µm"));
      for (const auto& [key, part] : parts_of_axis(*measures.system_stiffness)) {
        const std::string path = fmt::format("system_stiffness.contributions.{}", key);
        csv.row(name, path + ".stiffness_N_per_um", "N/µm", shown(part.stiffness, "N/µm"));
        csv.row(name, path + ".percent", "%", part.share * per_si::percent);
      }
    }
  return csv.take();
}

std::string yang_csv(const MeasuresResult& result, const CsvStyle& style) {
  CsvWriter csv(style);
  load_header(csv);
  csv.row("thread", "yang_load_rate_percent", "screw_load_rate_percent", "nut_load_rate_percent");
  for (std::size_t k = 0; k < result.load_measures.size(); ++k) {
    const LoadCaseResult& solved = result.analysis.load_cases[k];
    if (!result.load_measures[k] || !solved.threads) continue;
    const std::vector<double>& yang = result.load_measures[k]->yang_load_rate;
    for (std::size_t thread = 0; thread < yang.size(); ++thread) {
      load_fields(csv, solved.load_case);
      csv.row(thread + 1, yang[thread] * per_si::percent,
              solved.threads->screw.load_rate[thread] * per_si::percent,
              solved.threads->nut.load_rate[thread] * per_si::percent);
    }
  }
  return csv.take();
}

}  // namespace prs
