#include "prs/losses/slip_analysis.h"

#include <fmt/format.h>

#include "prs/heat/analyze_heat.h"
#include "prs/loads/case_table.h"
#include "prs/loads/mechanism_figures.h"
#include "prs/losses/slip_criteria.h"
#include "prs/losses/slip_figures.h"
#include "prs/losses/slip_table.h"
#include "prs/model/check_case.h"

namespace prs {
namespace {

/// Adds notes on load cases whose threads do not take the preload.
void add_preload_notes(const Case& c, Result& result) {
  if (!some_load_has_both_flanks(c)) return add_preload_note(c, result.warnings);
  for (LoadCaseResult& r : result.load_cases)
    if (!has_both_flanks(c, r.load_case.share))
      r.warnings.push_back({"preload", "share_without_preload",
                            "equal thread loads are those of the external load alone",
                            "leave out `share: equal` for loads with the preload"});
}

Result slips_of(const input::Source&, const input::CaseInput& in) {
  AnalysisOptions options;
  if (in.limits) options.temperature_limit = in.limits->temperature;
  Result result = analyze_heat(in.values, options);
  add_preload_notes(in.values, result);
  if (in.values.friction->facts().has_film())
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
  if (std::ranges::any_of(result.load_cases, [](const LoadCaseResult& r) { return r.heat.has_value(); }))
    files.push_back({"heat.csv", heat_csv(result, style)});
  if (result.heat_cycle && result.heat_cycle->converged())
    files.push_back({"heat_cycle.csv", heat_cycle_csv(*result.heat_cycle, style)});
  return files;
}

bool have_slip(const Result& r) {
  const auto answered = [](const LoadCaseResult& load) { return load.slip && load.slip->has_answer(); };
  return all_converged(r) && std::ranges::all_of(r.load_cases, answered) &&
         (!r.heat_cycle || r.heat_cycle->converged());
}

/// A duty cycle has temperatures of its own, and with them losses: the power lost is then the mean over the cycle or
/// the mission.
std::vector<Headline> losses(const Result& r) {
  Headline lost{"Power lost", "power_loss_W"};
  if (r.heat_cycle) {
    if (!r.heat_cycle->converged()) return {};
    lost.value = r.heat_cycle->energy_lost / r.heat_cycle->duration();
    lost.where = r.heat_cycle->is_mission() ? "heat.duty: mean over the mission" : "heat.duty: mean over the cycle";
    return {lost};
  }
  bool known = false;
  const bool is_written = r.load_cases.size() > 1 && r.load_cases.back().load_case.name == kBackDriving;
  for (const LoadCaseResult& load : std::span(r.load_cases).first(r.load_cases.size() - (is_written ? 1 : 0)))
    if (has_slip(load) && (!known || load.slip->power.total() > lost.value)) {
      known = true;
      lost.value = load.slip->power.total();
      lost.where = load.load_case.name;
    }
  return known ? std::vector{lost} : std::vector<Headline>{};
}

PageSection slip_section(const Result& r) {
  constexpr const char* kOfSteadyStates = "Steady: each load case running without pause";
  const bool steady =
      std::ranges::any_of(r.load_cases, [](const LoadCaseResult& load) { return load.heat.has_value(); }) &&
      !(r.heat_cycle && r.heat_cycle->is_mission());
  return {.in_cases = {{"slip",
                        {"status", "speed_rpm", "driven_by", "efficiency", "power_loss_W", "torque_screw_Nm",
                         "torque_nut_Nm", "self_locking", "holding_torque_Nm", "slip_ratio", "viscosity_mPas"},
                        steady ? kOfSteadyStates : ""},
                       {"heat", {"status", "reason", "temperature_degC", "oil_degC"}}},
          .in_document = {{"heat_cycle",
                           {"status", "reason", "period_s", "cycles", "start_degC", "end_degC", "peak_degC",
                            "mean_degC", "time_to_limit_s", "energy_in_J", "energy_lost_J", "efficiency"},
                           "Over the duty cycle"}},
          .folded = {"slip_patches", "slip_residue", "roller_friction"},
          .estimates = {"equal_shares", "efficiency_fit"},
          .note = fmt::format("Losses, films and temperatures are those of thread loads {}.", state_of_loads(r))};
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

constexpr Quantity<InterfaceSlip> kInterfaceSlip[] = {
    {"power_W", of<&InterfaceSlip::power>, "power that friction takes at the thread", "Sandu 2018, (3.51)"},
    {"power_density_W_per_mm2", of<&InterfaceSlip::power_density>, "power over the contact ellipse pi a b"},
    {"friction_coefficient", of<&InterfaceSlip::friction_coefficient>, "mean over the points of the ellipse",
     "Sandu 2018, (2.40)"},
    {"spin_torque_Nmm", of<&InterfaceSlip::spin_torque>, "about the roller's outward normal", "Sandu 2018, (3.10)"},
    {"sliding_speed_mm_per_s", of<&InterfaceSlip::sliding_speed>, "at the centre of the ellipse"},
    {"max_sliding_speed_mm_per_s", of<&InterfaceSlip::max_sliding_speed>, "largest over the points of the ellipse"},
    {"film_thickness_nm", filled<&InterfaceSlip::film_thickness>, "central film; needs a lubricant",
     "Sandu 2018, (2.39)"},
    {"central_film_nm", filled<&InterfaceSlip::central_film>, "central film; needs a lubricant",
     "Nijenbanning, Venner, Moes 1994; with lubricant.film.direction: rolling Chittenden et al. "
     "1985"},
    {"film_factor", filled<&InterfaceSlip::film_factor>,
     "phi, the film over that of a full and cold inlet: starvation times shear heating, 1 without "
     "lubricant.film; needs a lubricant",
     "Gupta, Cheng, Zhu, Forster, Krauter 1992"},
    {"film_ratio", filled<&InterfaceSlip::film_ratio>,
     "Lambda: phi times central film over the composite roughness; needs lubricant and roughness"},
    {"boundary_share", filled<&InterfaceSlip::boundary_share>,
     "share (1 + Lambda)^-exponent of the load on flanks that touch, exponent 2 where the case has "
     "none; that of friction only if mixed",
     "Olver and Spikes 1998"},
    {"dynamic_normal_load_N", of<&InterfaceSlip::dynamic_normal_load>,
     "normal load that keeps the axial load in balance with friction", "Sandu 2018, (3.11), (3.12)"},
    {"wear_mm3_per_km", filled<&InterfaceSlip::wear>,
     "volume that both bodies lose at the thread for each km of travel of screw or nut; needs wear", "Archard 1953"},
    {"flash_temperature_K", filled<&InterfaceSlip::flash_temperature>,
     "largest rise of the surfaces above their parts while they pass the contact; needs "
     "conductivity, density and specific_heat of the materials",
     "Greenwood 1991; Muzychka, Yovanovich 2001; Blok 1937"},
};

template <std::size_t source>
constexpr Quantity<PowerBySource> kPowerShare = {kPowerSources[source].key, of<kPowerSources[source].value>,
                                                 "share of the power that is lost there", "Sandu 2018, (3.51)",
                                                 kPowerSources[source].title};

constexpr Quantity<PowerBySource> kPowerShares[] = {kPowerShare<0>, kPowerShare<1>, kPowerShare<2>, kPowerShare<3>,
                                                    kPowerShare<4>};
static_assert(std::size(kPowerShares) == std::size(kPowerSources));

/// Shares of the sources; absent if nothing is lost.
std::optional<PowerBySource> shares(const SlipResult& slip) {
  const double total = slip.power.total();
  if (!(total > 0.0)) return std::nullopt;
  PowerBySource shares;
  for (const PowerSource& source : kPowerSources) shares.*source.value = slip.power.*source.value / total;
  return shares;
}

constexpr Quantity<RollerMoments> kRollerMoments[] = {
    {"contacts", of<&RollerMoments::contacts>, "friction at the contacts, R_c"},
    {"spin", of<&RollerMoments::spin>, "spin torques, R_s"},
    {"carrier", of<&RollerMoments::carrier>, "friction in the carrier, R_p"},
    {"gears", of<&RollerMoments::gears>, "gears at the ends, R_e"},
};

constexpr Quantity<RollerForces> kRollerForces[] = {
    {"contacts_x", of<&RollerForces::contacts_x>, "of all threads", "Sandu 2018, (3.27)"},
    {"contacts_y", of<&RollerForces::contacts_y>, "of all threads", "Sandu 2018, (3.27)"},
    {"gears_x", of<&RollerForces::gears_x>, "of the gears", "Sandu 2018, (3.28), (3.29)"},
    {"gears_y", of<&RollerForces::gears_y>, "of the gears", "Sandu 2018, (3.28), (3.29)"},
    {"carrier_x", of<&RollerForces::carrier_x>, "by the roller on the carrier", "Sandu 2018, (3.26), (3.32)"},
    {"carrier_y", of<&RollerForces::carrier_y>, "by the roller on the carrier", "Sandu 2018, (3.26), (3.32)"},
    {"centrifugal", of<&RollerForces::centrifugal, [](const RollerForces& f) { return f.centrifugal != 0.0; }>,
     "needs the rollers' density", "Sandu 2018, (3.33)"},
};

/// Heads, near and far: of one roller, or roller after roller.
struct RollerHeads {
  int threads_per_roller = 0;  ///< Heads of a roller, where all rollers stand.
  std::vector<double> guide_force, bearing_force, torque, eccentricity_ratio;
};

std::optional<RollerHeads> heads_of(const SlipResult& slip) {
  if (slip.heads.empty()) return std::nullopt;
  RollerHeads all{slip.threads.screw.threads_per_roller > 0 ? 2 : 0, {}, {}, {}, {}};
  const auto has = [&](auto member) {
    return std::ranges::any_of(slip.heads, [&](const auto& ends) { return (ends[0].*member).has_value(); });
  };
  const bool torques = has(&RollerHead::torque), films = has(&RollerHead::eccentricity_ratio);
  for (const std::array<RollerHead, 2>& ends : slip.heads)
    for (const RollerHead& head : ends) {
      all.guide_force.push_back(head.guide_force);
      all.bearing_force.push_back(head.bearing_force);
      if (torques) all.torque.push_back(head.torque.value_or(0.0));
      if (films) all.eccentricity_ratio.push_back(head.eccentricity_ratio.value_or(0.0));
    }
  return all;
}

constexpr Quantity<RollerHeads> kRollerHeads[] = {
    {"guide_force_N", of<&RollerHeads::guide_force>, "of the guides on the roller, near and far end; > 0 outwards"},
    {"bearing_force_N", of<&RollerHeads::bearing_force>,
     "of the bearing, that of the gears and the carrier's drive included"},
    {"torque_Nmm", filled<&RollerHeads::torque>, "that resists; needs carrier.bearing"},
    {"eccentricity_ratio", filled<&RollerHeads::eccentricity_ratio>, "e/c; needs a carrier.bearing with a film"},
};

constexpr Quantity<SlipEstimates> kSlipEstimates[] = {
    {"simple", of<&SlipEstimates::simple>, "contacts at the pitch points", "Sandu 2018, (2.21)",
     "slip ratio, estimate by contacts at the pitch points"},
    {"jones", of<&SlipEstimates::jones>, "standard mechanisms only", "Jones et al., in Sandu 2018, (2.20)",
     "slip ratio, estimate by the formula of Jones et al."},
};

constexpr Quantity<HottestThread> kHottestThread[] = {
    {"interface", of<&HottestThread::interface>, "screw | nut"},
    {"thread", of<&HottestThread::thread>, "from 1, next to the loaded end of the screw"},
    {"power_W", of<&HottestThread::power>, "power that friction takes there"},
    {"power_density_W_per_mm2", of<&HottestThread::power_density>, "power over its ellipse"},
    {"roller", of<&HottestThread::roller>, "from 1; of a full mechanism"},
    {"of_nut", of<&HottestThread::of_nut>, "1 | 2, of a double nut"},
};

constexpr Quantity<EqualShareSlip> kEqualShares[] = {
    {"slip_ratio", of<&EqualShareSlip::slip_ratio>, "carrier over screw, against the nut"},
    {"power_loss_W", of<&EqualShareSlip::power_loss>, "of the whole mechanism"},
    {"efficiency", of<&EqualShareSlip::efficiency>, "power out over power in"},
    {"max_thread_power_W",
     of<[](const EqualShareSlip& equal) { return std::max(equal.thread_power.screw, equal.thread_power.nut); }>,
     "larger of both interfaces"},
    {"max_power_density_W_per_mm2", of<&EqualShareSlip::max_power_density>, "power of a thread over its ellipse"},
};

constexpr Quantity<Holding::Bound> kHoldingBound[] = {
    {"holding_torque_Nm", of<&Holding::Bound::holding_torque>,
     "by the drive on the screw, > 0 against the load; inverted: the nut, which turns, has its reaction"},
    {"torque_screw_Nm", of<&Holding::Bound::torque_screw>, "by the drive on the screw", "Sandu 2018, (3.30)"},
    {"torque_nut_Nm", of<&Holding::Bound::torque_nut>, "on the nut", "Sandu 2018, (3.31)"},
    {"slip_ratio", of<&Holding::Bound::slip_ratio>, "with which motion begins"},
    {"roller_forces_N", of<&Holding::Bound::forces>, "on one roller across its axis, that on the carrier among them"},
};

constexpr Quantity<Holding> kHolding[] = {
    {"self_locking", of<[](const Holding& h) { return h.with_load.holding_torque <= 0.0; }>,
     "whether the screw holds its load without a torque"},
    {"against_load", of<&Holding::against_load>, "beyond it the drive moves the load"},
    {"with_load", of<&Holding::with_load>, "below it the load moves the screw"},
};

/// Getter of results whose search for the slip ratio converged.
template <auto get>
constexpr auto found = of<get, &SlipResult::converged>;

template <Interface i>
constexpr auto threads = found<[](const SlipResult& slip) -> const InterfaceSlip& { return slip.threads[i]; }>;

/// Quantities of one nut.
template <class Owner>
constexpr Quantity<Owner> kSlipOf[] = {
    {"converged", of<&SlipResult::has_answer>, "whether there is an answer: a slip ratio, or at rest `holding`"},
    {"status", of<&SlipResult::status>, "how the search for the slip ratio ended"},
    {"evaluations", of<&SlipResult::evaluations>, "of the roller's moment balance", "", "", "", "", Reach::document},
    {"relative_residue", of<&SlipResult::relative_residue>, "moment on a roller over radius and normal load",
     "Sandu 2018, (3.38)", "", "", "", Reach::document},
    {"speed_rpm", found<&SlipResult::speed>, "screw against nut"},
    {"gear_ratio", found<&SlipResult::gear_ratio>, "Gamma of the gears: n_R/n_S", "Sandu 2018, (2.1)"},
    {"slip_ratio", found<&SlipResult::slip_ratio>, "epsilon, carrier against nut over screw against nut",
     "Sandu 2018, (2.2)"},
    {"ideal_slip_ratio", found<&SlipResult::ideal_slip_ratio>, "epsilon* of least sliding",
     "Sandu 2018, (2.16), (2.17)"},
    {"optimality_percent", found<&SlipResult::optimality>, "100 % at the ideal slip ratio", "Sandu 2018, (2.19)",
     "nearness to the slip ratio of least sliding"},
    {"travel_per_turn_mm", found<&SlipResult::travel_per_turn>,
     "of the nut on the screw per turn of the screw against the nut; the lead where screw and nut have the same",
     "Sandu 2018, (2.5)"},
    {"migration_per_turn_um", found<&SlipResult::migration_per_turn>,
     "of the rollers along the part that they are geared to, per turn of the screw against the nut, > 0 ahead of its "
     "travel; 0 for equal pitches",
     "Sandu 2018, (2.12)"},
    {"pitch_sliding_per_turn_um", found<&SlipResult::pitch_sliding_per_turn>,
     "circumferential, of the pitch cylinders of rollers and geared part, per turn of the screw against the nut; 0 for "
     "diameters in the ratio of the gears",
     "Sandu 2018, (2.14)"},
    {"driven_by", found<&SlipResult::driven_by>, "screw | load: force x speed x lead > 0 or < 0"},
    {"efficiency", found<&SlipResult::efficiency>,
     "power out over power in: of the load over the shaft, or of the shaft over the load that "
     "drives; absent where self-locking",
     "Sandu 2018, (3.52)"},
    {"self_locking", found<&SlipResult::self_locking>, "whether no power comes out; where the load drives"},
    {"holding_torque_Nm", found<&SlipResult::holding_torque>,
     "by the drive on the screw in the sense of the motion, where the load drives: > 0 turns a "
     "self-locking screw, < 0 holds back the load"},
    {"efficiency_fit", found<&SlipResult::efficiency_fit>, "fit near a reference example; absent with Coulomb friction",
     "Sandu 2018, (3.55)"},
    {"power_loss_W", found<[](const SlipResult& slip) { return slip.power.total(); }>,
     "lost to all sources of friction", "Sandu 2018, (3.51)", "power lost"},
    {"power_loss_input_output_W", found<&SlipResult::power_loss_input_output>, "the same as power in less power out",
     "Sandu 2018, (3.53)", "power lost, as power in less power out"},
    {"torque_screw_Nm", found<&SlipResult::torque_screw>, "by the drive on the screw", "Sandu 2018, (3.30)",
     "torque on the screw"},
    {"torque_nut_Nm", found<&SlipResult::torque_nut>, "on the nut", "Sandu 2018, (3.31)", "torque on the nut"},
    {"viscosity_mPas", found<&SlipResult::viscosity>, "dynamic, in operation; needs a lubricant"},
    {"bearing_eccentricity_ratio", found<&SlipResult::bearing_eccentricity>,
     "e/c of the roller heads in the carrier, the larger one"},
    {"slip_ratio_estimates", found<&SlipResult::estimates>, "by geometry alone"},
    {"share_percent", found<shares>, "of each source in the power that is lost"},
    {"roller_moments_Nmm", found<&SlipResult::moments>,
     "on one roller about its axis, by source; the mean of all in a full mechanism"},
    {"roller_forces_N", found<&SlipResult::forces>,
     "on one roller across its axis, by source; the mean of all in a full mechanism"},
    {"heads", found<heads_of>, "of the rollers in the carrier, near and far end"},
    {"hottest_thread", found<hottest_thread>, "of the largest power density"},
    {"equal_shares", found<&SlipResult::equal_shares>, "what slip would be if all threads carried the same load"},
    {"screw", threads<Interface::screw>, "threads at the screw, of one roller or of all"},
    {"nut", threads<Interface::nut>, "threads at the nut, of one roller or of all"},
};

}  // namespace

const Analysis<Result>& slip_analysis() {
  static const std::vector<Place> places = with_loads(
      {{"load_cases[].heat", describe<HeatResult>, false, "with `heat`: loads and slip are those at its temperatures"},
       {"load_cases[].slip", describe<SlipResult>, false, "of `prs slip`"},
       {"heat_cycle", describe<HeatCycle>, false}});
  static const Analysis<Result> analysis{
      .command = Command::slip,
      .help = "Slip, friction, lost power, efficiency and torques",
      .file = "slip.json",
      .run = slips_of,
      .places = places,
      .put = put_slips,
      .load_case = slip_case_json,
      .table = slip_text<false>,
      .full_table = slip_text<true>,
      .notes = summary_of_warnings,
      .files = slip_files,
      .pictures = [](const Result& r, const Case& c) { return with_drawings(slip_pictures(c, r), c, r); },
      .converged = have_slip,
      .headlines = losses,
      .criteria = slip_criteria,
      .all_warnings = all_warnings,
      .place = {"Slip and losses", 2},
      .section = slip_section,
      .responses = kResponses,
      .takes_load_cases_apart = true};
  return analysis;
}

std::optional<HottestThread> hottest_thread(const SlipResult& slip) {
  const InterfaceSlip& threads = slip.threads[slip.hottest.interface];
  const auto thread = static_cast<std::size_t>(slip.hottest.thread);
  const std::optional<double> density = entry_if_any(threads.power_density, thread);
  if (!density) return std::nullopt;
  const auto row = static_cast<std::size_t>(threads.threads_per_roller);
  HottestThread hottest{slip.hottest.interface,
                        (row ? thread % row : thread) + 1,
                        row ? std::optional(thread / row + 1) : std::nullopt,
                        entry_if_any(threads.power, thread),
                        *density,
                        std::nullopt};
  if (!slip.second_nut) return hottest;
  hottest.of_nut = 1;
  std::optional<HottestThread> second = hottest_thread(*slip.second_nut);
  if (!second || second->power_density <= hottest.power_density) return hottest;
  second->of_nut = 2;
  return second;
}

PRS_RECORD(InterfaceSlip, "InterfaceSlip",
           "Threads of one interface of one roller: slip, friction, film and power; Sandu 2018, "
           "chapter 3.",
           kInterfaceSlip);
PRS_RECORD(PowerBySource, "PowerShares", "Where power is lost.", kPowerShares);
PRS_RECORD(RollerMoments, "RollerMoments",
           "Moments on one roller about its axis; they add up to zero in equilibrium. Sandu 2018, "
           "(3.39) to (3.42).",
           kRollerMoments);
PRS_RECORD(RollerForces, "RollerForces",
           "Forces on one roller across its axis, x away from the screw's axis, y along the orbit.", kRollerForces);
PRS_RECORD(RollerHeads, "RollerHeads", "The heads of a roller in the carrier, or of each roller.", kRollerHeads);
PRS_RECORD(SlipEstimates, "SlipRatioEstimates", "Slip ratios by formulas of geometry alone.", kSlipEstimates);
PRS_RECORD(HottestThread, "HottestThread", "The thread of the largest power density.", kHottestThread);
PRS_RECORD(EqualShareSlip, "EqualShareSlip", "Slip if all threads carried the same load.", kEqualShares);
PRS_RECORD(Holding::Bound, "HoldingBound", "Torques and forces at which a screw at rest begins to move.",
           kHoldingBound);
PRS_RECORD(Holding, "Holding", "A screw at rest under load: between its bounds static friction holds it.", kHolding);
PRS_RECORD(SecondNut, "SecondNut", "Slip of the rollers of a second nut.", kSlipOf<SecondNut>);

Record<SlipResult> record_of(Type<SlipResult>) {
  static const std::vector<Quantity<SlipResult>> all = [] {
    const auto& of_one_nut = kSlipOf<SlipResult>;
    std::vector<Quantity<SlipResult>> quantities(std::begin(of_one_nut), std::end(of_one_nut));
    quantities.push_back({"second_nut", found<[](const SlipResult& slip) { return slip.second_nut.get(); }>,
                          "rollers of the second nut of a double nut; powers, torques and efficiency here are of "
                          "both nuts, all else of the first"});
    quantities.push_back(
        {"holding", of<&SlipResult::holding>, "bounds of static friction of a screw that is held at rest, speed 0"});
    return quantities;
  }();
  return {"Slip", "Stationary slip of a load case: Sandu 2018, chapters 2 and 3.", all};
}

}  // namespace prs
