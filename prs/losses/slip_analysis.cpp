#include "prs/losses/slip_analysis.h"

#include "prs/heat/analyze_heat.h"
#include "prs/loads/heat_record.h"
#include "prs/loads/load_analysis.h"
#include "prs/loads/warnings.h"
#include "prs/losses/slip_pictures.h"
#include "prs/losses/slip_record.h"
#include "prs/model/void_inputs.h"

namespace prs {
namespace {

Result slips_of(const input::Source&, const input::CaseInput& in) {
  Result result = analyze_heat(in.values);
  if (!has_both_flanks(in.values, LoadCase::Share::solved))
    add_preload_note(in.values, result.warnings);
  if (in.values.friction->of_film())
    if (std::optional<Warning> estimated = estimated_lubricant(*in.values.lubricant))
      result.warnings.push_back(std::move(*estimated));
  return result;
}

void put_slips(Json& document, const Result& result) {
  put_loads(document, result);
  if (result.heat_cycle) document["heat_cycle"] = object_of(*result.heat_cycle);
}

std::optional<Json> slip_case_json(const Result& result, std::size_t k) {
  std::optional<Json> json = load_case_json(result, k);
  if (!json) return json;
  const LoadCaseResult& r = result.load_cases[k];
  if (r.heat) (*json)["heat"] = object_of(*r.heat);
  if (r.slip) (*json)["slip"] = object_of(*r.slip);
  return json;
}

template <bool all>
std::string slip_text(const Result& result) {
  std::string text = slip_table(result, all);
  if (result.load_cases.size() <= kMostCharts)
    for (const LoadCaseResult& r : result.load_cases)
      if (r.load_case.share == LoadCase::Share::solved) text.append("\n").append(slip_chart(r));
  return text;
}

std::vector<OutputFile> slip_files(const Result& result, const CsvStyle& style) {
  std::vector<OutputFile> files = load_files(result, style);
  files.push_back({"slip.csv", slip_csv(result, style)});
  files.push_back({"slip_threads.csv", slip_threads_csv(result, style)});
  if (std::ranges::any_of(result.load_cases,
                          [](const LoadCaseResult& r) { return r.heat.has_value(); }))
    files.push_back({"heat.csv", heat_csv(result, style)});
  if (result.heat_cycle && result.heat_cycle->converged())
    files.push_back({"heat_cycle.csv", heat_cycle_csv(*result.heat_cycle, style)});
  return files;
}

bool have_slip(const Result& r) {
  return all_converged(r) && std::ranges::all_of(r.load_cases, has_slip) &&
         (!r.heat_cycle || r.heat_cycle->converged());
}

/// A duty cycle has temperatures of its own, and with them losses: the power lost is then the mean
/// over the cycle.
std::vector<Headline> losses(const Result& r) {
  Headline lost{"Power lost", "power_loss_W"};
  if (r.heat_cycle) {
    if (!r.heat_cycle->converged()) return {};
    lost.value = r.heat_cycle->energy_lost / r.heat_cycle->period;
    lost.where = "heat.duty: mean over the cycle";
    return {lost};
  }
  bool known = false;
  for (const LoadCaseResult& load : r.load_cases)
    if (has_slip(load) && (!known || load.slip->power.total() > lost.value)) {
      known = true;
      lost.value = load.slip->power.total();
      lost.where = load.load_case.name;
    }
  return known ? std::vector{lost} : std::vector<Headline>{};
}

PageSection slip_section(const Result& r) {
  constexpr const char* kOfSteadyStates = "Steady: each load case running without pause";
  const bool steady = std::ranges::any_of(
      r.load_cases, [](const LoadCaseResult& load) { return load.heat.has_value(); });
  return {.in_cases = {{"slip",
                        {"status", "speed_rpm", "driven_by", "efficiency", "power_loss_W",
                         "torque_screw_Nm", "torque_nut_Nm", "self_locking", "holding_torque_Nm",
                         "slip_ratio", "viscosity_mPas"},
                        steady ? kOfSteadyStates : ""},
                       {"heat", {"status", "reason", "temperature_degC", "oil_degC"}}},
          .in_document = {{"heat_cycle",
                           {"status", "reason", "period_s", "peak_degC", "mean_degC", "energy_in_J",
                            "energy_lost_J", "efficiency"},
                           "Over the duty cycle"}},
          .folded = {"slip_patches", "slip_residue", "roller_friction"},
          .estimates = {"equal_shares", "efficiency_fit"}};
}

constexpr std::string_view kResponses[] = {"slip.efficiency",
                                           "slip.efficiency_fit",
                                           "slip.power_loss_W",
                                           "slip.torque_screw_Nm",
                                           "slip.slip_ratio",
                                           "slip.optimality_percent",
                                           "slip.share_percent.screw",
                                           "slip.share_percent.nut",
                                           "slip.share_percent.carrier_roller",
                                           "slip.share_percent.carrier_screw",
                                           "slip.share_percent.carrier_nut"};

}  // namespace

const Analysis<Result>& slip_analysis() {
  static const std::vector<Place> places =
      with_loads({{"load_cases[].heat", describe<HeatResult>, false,
                   "with `heat`: loads and slip are those at its temperatures"},
                  {"load_cases[].slip", describe<SlipResult>, false, "of `prs slip`"},
                  {"heat_cycle", describe<HeatCycle>, false}});
  static const Analysis<Result> analysis{
      .command = Command::slip,
      .help = "Slip, friction, dissipated power, efficiency and torques",
      .file = "slip.json",
      .run = slips_of,
      .places = places,
      .put = put_slips,
      .load_case = slip_case_json,
      .table = slip_text<false>,
      .full_table = slip_text<true>,
      .notes = summary_of_warnings,
      .files = slip_files,
      .pictures = [](const Result& r, const Case& c) { return slip_pictures(c, r); },
      .converged = have_slip,
      .headlines = losses,
      .all_warnings = all_warnings,
      .place = {"Slip and losses", 2},
      .section = slip_section,
      .responses = kResponses,
      .takes_load_cases_apart = true};
  return analysis;
}

}  // namespace prs
