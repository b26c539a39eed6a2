#include "prs/measures/measures_analysis.h"

#include "prs/loads/load_analysis.h"
#include "prs/loads/load_pictures.h"
#include "prs/loads/warnings.h"
#include "prs/measures/measures_record.h"
#include "prs/measures/measures_table.h"
#include "prs/model/void_inputs.h"

namespace prs {

Figures yang(const MeasuresResult& result);
Figures stiffness_terms(const MeasuresResult& result);

namespace {

using Json = nlohmann::ordered_json;

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
  return {.in_cases = {{"measures",
                        {"solved_static_safety", "solved_static_safety_limit",
                         "thread_static_safety", "static_safety", "static_safety_limit",
                         "buckling_safety", "speed_safety", "drive_torque_Nm",
                         "system_stiffness"}}},
          .in_document = {{"measures",
                           {"dynamic_capacity_N", "static_capacity_N", "flank_edge_load_N",
                            "weight_kg", "screw_weight_kg_per_m", "equivalent_inertia_kg_mm2",
                            "shaft_stiffness_N_per_um", "buckling_load_N", "critical_speed_rpm"}}},
          .folded = {"yang", "stiffness_terms"},
          .estimates = estimates_in(r)};
}

constexpr std::string_view kResponses[] = {
    "measures.dynamic_capacity_N",  "measures.static_capacity_N",
    "measures.weight_kg",           "measures.force_density_kN_per_kg",
    "measures.envelope_volume_cm3", "measures.thread_stiffness_N_per_um",
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
      .warnings = [](MeasuresResult& r) -> std::vector<Warning>& { return r.analysis.warnings; },
      .all_warnings = [](const MeasuresResult& r) { return all_warnings(r.analysis); },
      .place = {"Design measures", 4},
      .section = section,
      .responses = kResponses,
      .takes_load_cases_apart = true};
  return analysis;
}

}  // namespace prs
