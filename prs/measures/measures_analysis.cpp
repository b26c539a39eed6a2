#include "prs/measures/measures_analysis.h"

#include "prs/loads/case_groups.h"
#include "prs/loads/load_analysis.h"
#include "prs/loads/load_pictures.h"
#include "prs/loads/warnings.h"
#include "prs/measures/measures_record.h"
#include "prs/model/void_inputs.h"

namespace prs {
namespace {

constexpr std::size_t kMostYangPanels = 6;
constexpr std::size_t kMostBarCases = 6;
constexpr std::size_t kMostLabelledCases = 3;  ///< Bars of more are thinner than a number.

constexpr double kPerMicrometrePerKilonewton = 1e9;  // From m/N.

/// Name and compliance [m/N].
using Compliance = std::pair<std::string, double>;

/// Of the bodies, and of the teeth of all contacts together, the roller's at both interfaces.
std::vector<Compliance> body_compliances(const MeasuresResult& result) {
  const Measures& m = result.measures;
  const Mechanism& mechanism = result.analysis.contacts.mechanism;
  const double contacts = mechanism.rollers * mechanism.contacts_per_roller;
  std::vector<Compliance> all;
  for (const Part part : kParts)
    if (m.tooth_stiffness[part] && contacts > 0.0)
      all.push_back({fmt::format("teeth, {}", title(part)),
                     (part == Part::roller ? 2.0 : 1.0) / (*m.tooth_stiffness[part] * contacts)});
  for (const Part part : kParts)
    if (m.section_stiffness[part])
      all.push_back(
          {fmt::format("body over one pitch, {}", part == Part::roller ? "rollers" : title(part)),
           1.0 / *m.section_stiffness[part]});
  if (m.shaft_stiffness) all.push_back({"shaft of the screw", 1.0 / *m.shaft_stiffness});
  return all;
}

/// The last load case of each range with stiffness of its contacts.
std::vector<std::size_t> cases_with_contacts(const MeasuresResult& result) {
  std::vector<std::size_t> cases;
  for (const CaseGroup& group : group_cases(result.analysis.load_cases)) {
    const auto k = static_cast<std::size_t>(group.cases.back() - result.analysis.load_cases.data());
    const auto& measures = result.load_measures[k];
    if (measures && measures->hertz_stiffness.screw && measures->hertz_stiffness.nut)
      cases.push_back(k);
  }
  return cases;
}

/// Load rates by Yang's formula and by the model, one panel per load case, at most six.
Figures yang(const MeasuresResult& result) {
  Figure figure{"yang", "Load distribution: Yang's formula and the model"};
  figure.y = {"Share of the load", "%"};
  std::size_t threads = 0;
  for (std::size_t k = 0; k < result.load_measures.size(); ++k) {
    const LoadCaseResult& load_case = result.analysis.load_cases[k];
    // Yang's roller stands for all of them.
    if (!load_case.threads || load_case.full || !result.load_measures[k]) continue;
    const std::vector<double>& rate = result.load_measures[k]->yang_load_rate;
    if (rate.empty() || figure.panels.size() == kMostYangPanels) continue;
    threads = std::max(threads, rate.size());
    Panel& panel = figure.panels.emplace_back();
    panel.title = shown_name(load_case.load_case.name);
    panel.series = {{0, {over_threads(load_case.threads->screw.load_rate, per_si::percent)}},
                    {1, {over_threads(load_case.threads->nut.load_rate, per_si::percent)}},
                    {2, {over_threads(rate, per_si::percent)}}};
  }
  if (figure.panels.empty()) return {};
  figure.add("model, roller-screw", marked_line(0));
  figure.add("model, roller-nut", marked_line(1));
  figure.add("Yang", marked_line(2));
  figure.x = thread_axis(threads);
  figure.columns = figure.panels.size() == 1 ? 1 : 2;
  add_mean(figure, per_si::percent / static_cast<double>(threads));
  fit_y_range(figure, true);
  return {std::move(figure)};
}

/// Compliances: contacts that share each load equally, teeth, body sections of one pitch, the
/// screw's shaft. They do not add up to that of the screw.
Figures stiffness_terms(const MeasuresResult& result) {
  Figure figure{"stiffness_terms",
                "Stiffness terms: contacts with equal shares, bodies over one pitch"};
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
    if (cases.size() <= kMostLabelledCases)
      panel.labels.push_back({fmt::format(" {:.3g}", shown), shown, at});
    widest = std::max(widest, shown);
  };
  const double thick = 0.8 / static_cast<double>(std::max<std::size_t>(cases.size(), 1));
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const LoadCase& load_case = result.analysis.load_cases[cases[c]].load_case;
    Series bars{figure.add(fmt::format("{}, {:.4g} kN", shown_name(load_case.name),
                                       load_case.axial_force * per_si::kilonewton),
                           area_of(case_colour(c)))};
    for (std::size_t i = 0; i < contacts; ++i)
      bar(bars, rank_position(i, count) + 0.4 - (static_cast<double>(c) + 0.5) * thick,
          0.46 * thick, 1.0 / *result.load_measures[cases[c]]->hertz_stiffness[kInterfaces[i]]);
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
  return with(
      {{"yang", "load cases that converged, and what Yang's formula needs", of_result(r, yang)},
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
                    {"solved_static_safety", "solved_static_safety_limit", "thread_static_safety",
                     "static_safety", "static_safety_limit", "buckling_safety", "speed_safety",
                     "drive_torque_Nm", "system_stiffness"}}},
      .in_document = {{"measures",
                       {"dynamic_capacity_N", "static_capacity_N", "flank_edge_load_N", "weight_kg",
                        "screw_weight_kg_per_m", "equivalent_inertia_kg_mm2",
                        "shaft_stiffness_N_per_um", "buckling_load_N", "critical_speed_rpm"}}},
      .folded = {"yang", "stiffness_terms"},
      .estimates = estimates_in(r)};
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
      .warnings = [](auto& r) -> decltype(auto) { return (r.analysis.warnings); },
      .all_warnings = [](const MeasuresResult& r) { return all_warnings(r.analysis); },
      .place = {"Design measures", 4},
      .section = section,
      .responses = kResponses,
      .takes_load_cases_apart = true};
  return analysis;
}

}  // namespace prs
