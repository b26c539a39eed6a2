#include "prs/measures/measures_analysis.h"

#include "prs/loads/case_table.h"
#include "prs/loads/load_analysis.h"
#include "prs/loads/load_pictures.h"
#include "prs/loads/load_record.h"
#include "prs/measures/measures_criteria.h"
#include "prs/measures/measures_record.h"
#include "prs/model/check_case.h"
#include "prs/record/csv_rows.h"
#include "prs/record/table_layout.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr TableRows kRows{58, 14};
constexpr std::size_t kMostCases = 3;  ///< Largest number of cases side by side.

/// Unit of a row: larger than in documents for newtons and single revolutions.
ShownUnit row_unit(const ShownUnit& unit) {
  if (unit.text == "N") return table_unit("kN");
  if (unit.text == "revolutions") return {"", "10^6 revolutions", 1e-6};
  return table_unit(unit);
}

/// A number or a text; none if the measure is absent.
template <class Owner>
std::optional<std::string> measure_cell(const Quantity<Owner>& q, const std::optional<Owner>& measures) {
  if (!measures) return std::nullopt;
  if (q.value.number) {
    const std::optional<double> shown = shown_number(q, *measures);
    return shown ? std::optional(significant(*shown * row_unit(q.unit).factor / q.unit.factor)) : std::nullopt;
  }
  const auto json = q.value.json(*measures, q.unit);
  return json.is_null() ? std::nullopt : std::optional(words_of_text(json.template get<std::string>()));
}

/// Headings in the order of the table.
template <class Owner>
std::vector<std::string_view> groups_of() {
  std::vector<std::string_view> groups;
  for (const Quantity<Owner>& q : record_of<Owner>().quantities)
    if (std::ranges::find(groups, q.group) == groups.end()) groups.push_back(q.group);
  return groups;
}

using Keys = std::vector<std::string>;

/// Numbers and words group by group, `owners` side by side, without those absent for all, and without the `hidden`
/// keys.
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
      if (any) rows += kRows(fmt::format("  {}{}{}", q.title, unit.empty() ? "" : ", ", unit), cells);
    }
    if (!rows.empty()) text += fmt::format("{}{}\n", text.empty() ? "" : "\n", group) + rows;
  }
  return text;
}

/// Parts of an axis that a case has, with their keys.
std::vector<std::pair<std::string_view, SystemStiffness::Contribution>> parts_of_axis(const SystemStiffness& axis) {
  const SystemStiffness::Contributions& c = axis.contributions;
  const std::optional<SystemStiffness::Contribution>* parts[] = {&c.mechanism, &c.shaft, &c.wind_up, &c.support_bearing,
                                                                 &c.housing};
  std::vector<std::pair<std::string_view, SystemStiffness::Contribution>> all;
  for (std::size_t k = 0; k < std::size(parts); ++k)
    if (*parts[k]) all.emplace_back(record_of<SystemStiffness::Contributions>().quantities[k].key, **parts[k]);
  return all;
}

/// Stiffness of the axis and the shares of its parts in the compliance; all cases have the same parts.
std::string axis_rows(std::span<const std::optional<LoadMeasures>> owners) {
  std::vector<std::string> total;
  std::vector<std::pair<std::string, std::vector<std::string>>> rows;
  for (std::size_t k = 0; k < owners.size(); ++k) {
    const bool known = owners[k] && owners[k]->system_stiffness;
    total.push_back(known ? significant(shown(owners[k]->system_stiffness->total, "N/µm")) : std::string(kAbsent));
    if (!known) continue;
    for (const auto& [key, part] : parts_of_axis(*owners[k]->system_stiffness)) {
      const auto row = std::ranges::find(rows, key, [](const auto& r) { return r.first; });
      auto& cells = row == rows.end()
                        ? rows.emplace_back(key, std::vector<std::string>(owners.size(), std::string(kAbsent))).second
                        : row->second;
      cells[k] = significant(part.share * "%"_per_si);
    }
  }
  if (rows.empty()) return {};
  std::string text = "\nThe axis\n" + kRows(with_table_unit("  all parts in series, N/µm"), total);
  for (const auto& [key, cells] : rows) text += kRows(fmt::format("  {}, % of the compliance", words_of(key)), cells);
  return text;
}

/// The load cases [first, last) side by side.
std::string load_table(const MeasuresResult& result, std::size_t first, std::size_t last, const Keys& hidden) {
  std::vector<std::string> names, forces;
  for (std::size_t k = first; k < last; ++k) {
    const LoadCase& load = result.analysis.load_cases[k].load_case;
    names.push_back(shortened(printable(load.name), kRows.cell_width - 1));
    forces.push_back(significant(shown(load.axial_force, "kN")));
  }
  const std::string text = kRows("Load case", names) + kRows(with_table_unit("  force, kN"), forces);
  const auto measures = std::span(result.load_measures).subspan(first, last - first);
  const std::string rows = group_rows(measures, hidden);
  std::string speeds;
  for (std::size_t k = 0; k < measures.size(); ++k) {
    if (!measures[k] || measures[k]->speeds_to_avoid.empty()) continue;
    std::vector<std::string> each;
    for (const double speed : measures[k]->speeds_to_avoid) each.push_back(significant(shown(speed, "rpm")));
    each.erase(std::unique(each.begin(), each.end()), each.end());
    speeds += hanging(fmt::format("\n{}: ", names[k]), 2,
                      fmt::format("speeds to avoid {} rpm, at which an order of the parts meets the lowest natural "
                                  "frequency, however small what excites it",
                                  fmt::join(each, ", ")));
  }
  return text + (rows.empty() ? "" : '\n' + rows) + axis_rows(measures) + speeds;
}

/// A paragraph after a word.
std::string paragraph(const std::string& word, std::string_view text) {
  return hanging("    " + word, 4 + word.size(), text);
}

template <class Owner>
std::string explanations() {
  std::string text;
  for (const Quantity<Owner>& q : record_of<Owner>().quantities)
    text += fmt::format("{}\n", q.key) + paragraph("", q.title) + paragraph("formula: ", q.meaning) +
            paragraph("valid: ", q.validity) + paragraph("source: ", q.source);
  return text;
}

/// Adds the numbers of a record, then those of the records in it.
void add_rows(CsvWriter& csv, std::string_view load_case, const RecordInfo& info, const Json& object,
              const std::string& path = {}) {
  for (const bool nested : {false, true})
    for (const QuantityInfo& q : info.quantities) {
      const auto value = object.find(q.key);
      if (value == object.end() || q.kind != (nested ? Kind::record : Kind::number)) continue;
      const std::string key = path + std::string(q.key);
      if (nested)
        add_rows(csv, load_case, q.record(), *value, key + ".");
      else
        csv.row(load_case, key, q.unit, value->get<double>());
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
        "Estimates of what prs slip and prs life compute, and with equal thread loads: prs measures "
        "--all\n";
  return text + warning_section(all_warnings(result.analysis));
}

/// Keys of estimates of quantities that the result or another command computes.
std::vector<std::string> estimates_in(const MeasuresResult& result) {
  const auto known = [&](auto member) {
    return std::ranges::any_of(result.load_measures, [&](const auto& m) { return m && (*m).*member; });
  };
  const bool solved = known(&LoadMeasures::solved_static_safety);
  const bool loaded =
      std::ranges::any_of(result.analysis.load_cases, [](const LoadCaseResult& r) { return r.threads.has_value(); });
  return estimates_beside(
      {result.slips, result.lives, solved, solved || known(&LoadMeasures::thread_static_safety), loaded});
}

/// The table with the estimates of computed quantities.
std::string full_measures_table(const MeasuresResult& result) { return table_without(result, {}); }

}  // namespace

std::string measures_table(const MeasuresResult& result) { return table_without(result, estimates_in(result)); }

std::string measure_explanations() {
  return "Measures of the mechanism: `measures` in documents\n\n" + explanations<Measures>() +
         "\nMeasures of a load case: `load_cases[].measures` in documents\n\n" + explanations<LoadMeasures>();
}

std::string measures_csv(const MeasuresResult& result, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.row("load_case", "measure", "unit", "value");
  add_rows(csv, "", describe<Measures>(), object_of(result.measures));
  for (std::size_t k = 0; k < result.load_measures.size(); ++k)
    if (result.load_measures[k])
      add_rows(csv, result.analysis.load_cases[k].load_case.name, describe<LoadMeasures>(),
               object_of(*result.load_measures[k]));
  return csv.take();
}

std::string yang_csv(const MeasuresResult& result, const CsvStyle& style) {
  CsvRows csv(style);
  const auto add_row = [&](const LoadCaseResult& r, const std::vector<double>& yang, std::size_t k) {
    csv.load_case(r.load_case);
    csv("thread", k + 1);
    csv("yang_load_rate_percent", entry_if_any(yang, k));
    for (const Interface i : kInterfaces)
      csv(fmt::format("{}_load_rate_percent", name(i)),
          r.threads ? entry_if_any((*r.threads)[i].load_rate, k) : std::nullopt);
    csv.end_row();
  };
  add_row({}, {}, 0);
  csv.drop_rows();
  for (std::size_t k = 0; k < result.load_measures.size(); ++k) {
    const LoadCaseResult& solved = result.analysis.load_cases[k];
    if (!result.load_measures[k] || !solved.threads) continue;
    const std::vector<double>& yang = result.load_measures[k]->yang_load_rate;
    for (std::size_t thread = 0; thread < yang.size(); ++thread) add_row(solved, yang, thread);
  }
  return csv.take();
}

namespace {

constexpr std::size_t kMostYangPanels = 6;
constexpr std::size_t kMostBarCases = 6;
constexpr std::size_t kMostLabelledCases = 3;  ///< Largest number of cases whose bars are thick enough for a number.

constexpr double kPerMicrometrePerKilonewton = 1e9;  // Factor from m/N.

/// Name and compliance [m/N].
using Compliance = std::pair<std::string, double>;

/// Compliances of the bodies, and of the teeth of all contacts together; for the roller at both interfaces.
std::vector<Compliance> body_compliances(const MeasuresResult& result) {
  const Measures& m = result.measures;
  const Mechanism& mechanism = result.analysis.contacts.mechanism;
  const double contacts = loaded_rollers(mechanism) * mechanism.contacts_per_roller;
  std::vector<Compliance> all;
  for (const Part part : kParts)
    if (m.tooth_stiffness[part] && contacts > 0.0)
      all.push_back({fmt::format("teeth, {}", title(part)),
                     (part == Part::roller ? 2.0 : 1.0) / (*m.tooth_stiffness[part] * contacts)});
  for (const Part part : kParts)
    if (m.section_stiffness[part])
      all.push_back({fmt::format("body over one pitch, {}", part == Part::roller ? "rollers" : title(part)),
                     1.0 / *m.section_stiffness[part]});
  if (m.shaft_stiffness) all.push_back({"shaft of the screw", 1.0 / *m.shaft_stiffness});
  return all;
}

/// Last load case of each range that has a stiffness of its contacts.
std::vector<std::size_t> cases_with_contacts(const MeasuresResult& result) {
  std::vector<std::size_t> cases;
  for (const CaseGroup& group : group_cases(result.analysis.load_cases)) {
    const auto k = static_cast<std::size_t>(group.cases.back() - result.analysis.load_cases.data());
    const auto& measures = result.load_measures[k];
    if (measures && measures->hertz_stiffness.screw && measures->hertz_stiffness.nut) cases.push_back(k);
  }
  return cases;
}

/// Load rates by Yang's formula and by the model, one panel per load case, at most six.
Figures yang(const MeasuresResult& result) {
  Figure figure{"yang", "Load distribution at rest: Yang's formula and the model"};
  figure.y = {"Share of the load", "%"};
  std::size_t threads = 0;
  for (std::size_t k = 0; k < result.load_measures.size(); ++k) {
    const LoadCaseResult& load_case = result.analysis.load_cases[k];
    // Yang's formula has one roller for all.
    if (!load_case.threads || load_case.full || !result.load_measures[k]) continue;
    const std::vector<double>& rate = result.load_measures[k]->yang_load_rate;
    if (rate.empty() || figure.panels.size() == kMostYangPanels) continue;
    threads = std::max(threads, rate.size());
    Panel& panel = figure.panels.emplace_back(Panel{shown_name(load_case.load_case.name)});
    panel.series = {{0, {over_threads(load_case.threads->screw.load_rate, "%"_per_si)}},
                    {1, {over_threads(load_case.threads->nut.load_rate, "%"_per_si)}},
                    {2, {over_threads(rate, "%"_per_si)}}};
  }
  if (figure.panels.empty()) return {};
  figure.add("model, roller-screw", marked_line(0));
  figure.add("model, roller-nut", marked_line(1));
  figure.add("Yang", marked_line(2));
  figure.x = thread_axis(threads);
  figure.columns = figure.panels.size() == 1 ? 1 : 2;
  add_mean(figure, "%"_per_si / static_cast<double>(threads));
  fit_y_range(figure, true);
  return {std::move(figure)};
}

/// Compliances: contacts that share each load equally, teeth, body sections of one pitch, the screw's shaft. Their sum
/// is not the compliance of the screw.
Figures stiffness_terms(const MeasuresResult& result) {
  Figure figure{"stiffness_terms", "Stiffness terms: contacts with equal thread loads, bodies over one pitch"};
  std::vector<std::size_t> cases = cases_with_contacts(result);
  keep_first(cases, kMostBarCases, figure.title);
  const std::vector<Compliance> bodies = body_compliances(result);
  const std::size_t contacts = cases.empty() ? 0 : std::size(kInterfaces);
  const std::size_t count = contacts + bodies.size();
  if (count == 0) return {};
  Panel panel;
  std::vector<std::string> names;
  double widest = 0.0;
  const auto bar = [&](Series& series, double at, double half, double compliance) {
    const double shown = compliance * kPerMicrometrePerKilonewton;
    series.parts.push_back(rectangle(0.0, shown, at - half, at + half));
    if (cases.size() <= kMostLabelledCases) panel.labels.push_back({fmt::format(" {:.3g}", shown), shown, at});
    widest = std::max(widest, shown);
  };
  const double thick = 0.8 / static_cast<double>(std::max<std::size_t>(cases.size(), 1));
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const LoadCase& load_case = result.analysis.load_cases[cases[c]].load_case;
    Series bars{
        figure.add(fmt::format("{}, {:.4g} kN", shown_name(load_case.name), load_case.axial_force * "kN"_per_si),
                   area_of(case_colour(c)))};
    for (std::size_t i = 0; i < contacts; ++i)
      bar(bars, rank_position(i, count) + 0.4 - (static_cast<double>(c) + 0.5) * thick, 0.46 * thick,
          1.0 / *result.load_measures[cases[c]]->hertz_stiffness[kInterfaces[i]]);
    panel.series.push_back(std::move(bars));
  }
  for (std::size_t i = 0; i < contacts; ++i)
    names.push_back(fmt::format("contacts, {}", i == 0 ? "roller-screw" : "roller-nut"));
  Series bars{figure.add(cases.empty() ? "" : "every load case", area_of(Colour::grey))};
  if (cases.empty()) figure.legend.clear();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    names.push_back(bodies[k].first);
    bar(bars, rank_position(contacts + k, count), 0.3, bodies[k].second);
  }
  panel.series.push_back(std::move(bars));
  figure.x = {"Compliance", "µm/kN", 0.0, 1.12 * widest};
  figure.y = ranked_axis(names);
  figure.aspect = 0.08 + 0.055 * static_cast<double>(count + cases.size());
  figure.panels.push_back(std::move(panel));
  return {std::move(figure)};
}

template <class Owner>
void put_explanations(Json& list, std::string_view of) {
  for (const Quantity<Owner>& q : record_of<Owner>().quantities)
    list.push_back({{"key", q.key},
                    {"of", q.value.kind == Kind::series ? "thread" : of},
                    {"title", q.title},
                    {"formula", q.meaning},
                    {"validity", q.validity},
                    {"source", q.source}});
}

MeasuresResult measured(const input::Source&, const input::CaseInput& in) {
  MeasuresResult result = analyze_measures(in.values);
  result.slips = input::unmet(in, Command::slip).empty();
  result.lives = input::unmet(in, Command::life).empty();
  add_preload_note(in.values, result.analysis.warnings);
  if (!result.analysis.load_cases.empty()) add_heat_note(in.values, result.analysis.warnings);
  return result;
}

std::optional<Json> measured_case_json(const MeasuresResult& result, std::size_t k) {
  std::optional<Json> json = load_case_json(result.analysis, k);
  if (json && k < result.load_measures.size() && result.load_measures[k])
    (*json)["measures"] = object_of(*result.load_measures[k]);
  return json;
}

std::vector<OutputFile> measures_files(const MeasuresResult& r, const CsvStyle& style) {
  return {{"measures.csv", measures_csv(r, style)}, {"yang.csv", yang_csv(r, style)}};
}

Pictures measures_pictures(const MeasuresResult& r) {
  return with({{"yang", "load cases that converged, and what Yang's formula needs", of_result(r, yang)},
               {"stiffness_terms", "loads, structure or `shaft`", of_result(r, stiffness_terms)}},
              solve_pictures(r.analysis));
}

std::vector<Headline> capacity(const MeasuresResult& r) {
  if (!r.measures.dynamic_capacity) return {};
  return {{"Dynamic capacity", "dynamic_capacity_N", *r.measures.dynamic_capacity}};
}

PageSection section(const MeasuresResult& r) {
  return {
      .in_cases = {{"measures",
                    {"solved_static_safety", "solved_static_safety_limit", "thread_static_safety", "static_safety",
                     "static_safety_limit", "buckling_safety", "speed_safety", "drive_torque_Nm", "system_stiffness"}}},
      .in_document = {{"measures",
                       {"dynamic_capacity_N", "static_capacity_N", "flank_edge_load_N", "weight_kg",
                        "screw_weight_kg_per_m", "equivalent_inertia_kg_mm2", "shaft_stiffness_N_per_um",
                        "buckling_load_N", "critical_speed_rpm"}}},
      .folded = {"yang", "stiffness_terms"},
      .estimates = estimates_in(r),
      .note = "Thread loads are those at rest."};
}

constexpr std::string_view kResponses[] = {"measures.dynamic_capacity_N",
                                           "measures.static_capacity_N",
                                           "measures.weight_kg",
                                           "measures.force_density_kN_per_kg",
                                           "measures.envelope_volume_cm3",
                                           "measures.thread_stiffness_N_per_um",
                                           "measures.system_stiffness.total_N_per_um"};

}  // namespace

Json measure_explanations_json() {
  Json list = Json::array();
  put_explanations<Measures>(list, "mechanism");
  put_explanations<LoadMeasures>(list, "load case");
  return list;
}

const Analysis<MeasuresResult>& measures_analysis() {
  static const std::vector<Place> places =
      with_loads({{"load_cases[].measures", describe<LoadMeasures>, false, "of `prs measures`"},
                  {"measures", describe<Measures>}});
  static const Analysis<MeasuresResult> analysis{
      .command = Command::measures,
      .help = "Capacity, life, weight, stiffness, inertia and the other design measures",
      .file = "measures.json",
      .run = measured,
      .places = places,
      .put =
          [](Json& document, const MeasuresResult& r) {
            put_loads(document, r.analysis);
            document["measures"] = object_of(r.measures);
          },
      .load_case = measured_case_json,
      .table = measures_table,
      .full_table = full_measures_table,
      .notes = [](const MeasuresResult& r) { return summary_of_warnings(r.analysis); },
      .files = measures_files,
      .pictures = [](const MeasuresResult& r, const Case&) { return measures_pictures(r); },
      .converged = [](const MeasuresResult& r) { return all_converged(r.analysis); },
      .headlines = capacity,
      .criteria = measures_criteria,
      .warnings = [](auto& r) -> decltype(auto) { return (r.analysis.warnings); },
      .all_warnings = [](const MeasuresResult& r) { return all_warnings(r.analysis); },
      .place = {"Design measures", 4},
      .section = section,
      .responses = kResponses,
      .takes_load_cases_apart = true};
  return analysis;
}

}  // namespace prs
