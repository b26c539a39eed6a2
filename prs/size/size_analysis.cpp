#include "prs/size/size_analysis.h"

#include <fmt/ranges.h>

#include "modules/response/response.h"
#include "prs/configurations/configurations_files.h"
#include "prs/loads/case_table.h"
#include "prs/loads/load_record.h"
#include "prs/losses/slip_figures.h"
#include "prs/record/csv_rows.h"
#include "prs/record/table_layout.h"
#include "prs/text.h"

namespace prs {

constexpr Quantity<MotionSegment> kMotionSegment[] = {
    {"name", always<&MotionSegment::name>, "as given, else segment-K, sample-K or class-K"},
    {"duration_s", always<&MotionSegment::duration>, "of it, or of all in its class"},
    {"start_speed_mm_per_s", of<&MotionSegment::start_speed>, "signed"},
    {"end_speed_mm_per_s", of<&MotionSegment::end_speed>, "signed"},
    {"acceleration_m_per_s2", of<&MotionSegment::acceleration>, "signed"},
    {"travel_mm", of<&MotionSegment::travel>, "signed"},
    {"axial_force_N", always<&MotionSegment::force>, "on the screw, > 0 where it pushes the mass in the positive sense",
     "THK general catalogue, axial loads"},
};

PRS_RECORD(MotionSegment, "MotionSegment", "Constant acceleration under one force.", kMotionSegment);

/// The lever of a requirement.
static std::optional<LeverMotion> lever_of(const SizeInput& in) {
  if (!in.cycle.angles) return std::nullopt;
  return LeverMotion{*in.values.linkage, in.values.load.inertia, *in.cycle.angles};
}

constexpr Quantity<RequirementOf> kRequirement[] = {
    {"cycle_s", of<its<&MotionCycle::duration>>, "rests included"},
    {"moving_s", of<its<&MotionCycle::moving>>, "time in motion, per cycle"},
    {"travel_mm", of<its<&MotionCycle::travel>>, "per cycle, of both senses"},
    {"stroke_mm", of<[](const RequirementOf& r) { return r.whole->input.values.stroke; }>,
     "as given, else the way between the extreme positions"},
    {"mean_load_N", of<its<&MotionCycle::mean_load>>, "cubic mean over travel"},
    {"largest_force_N", of<its<&MotionCycle::largest_force>>, "at rest too"},
    {"largest_speed_mm_per_s", of<its<&MotionCycle::largest_speed>>, "of either sense"},
    {"rms_speed_mm_per_s", of<its<&MotionCycle::rms_speed>>, "over the cycle with its rests"},
    {"mean_speed_mm_per_s", of<its<&MotionCycle::mean_speed>>, "travel over the time in motion"},
    {"segments", always<its<&MotionCycle::shown>>, "of constant acceleration, or classes of many samples"},
    {"lever", of<[](const RequirementOf& r) { return lever_of(r.whole->input); }>, "whose angle and torque are given"},
};

PRS_RECORD(RequirementOf, "SizeRequirement", "One cycle of the axis.", kRequirement);

struct SizeCounts {
  std::size_t passing, failing, invalid;
};

constexpr Quantity<SizeCounts> kCounts[] = {
    {"candidates", always<[](const SizeCounts& c) { return c.passing + c.failing + c.invalid; }>,
     "all rows and combinations"},
    {"passing", always<&SizeCounts::passing>, "all criteria"},
    {"failing", always<&SizeCounts::failing>, "some criterion"},
    {"invalid", always<&SizeCounts::invalid>, "refused by the rules of `prs new`"},
};

PRS_RECORD(SizeCounts, "SizeCounts", "How many candidates there are.", kCounts);

/// Source of a candidate.
static std::string_view source_name(const CandidateData& c) { return c.is_row ? "catalogue" : "design"; }
template <bool of_row>
static std::optional<std::size_t> number_of(const CandidateData& c) {
  return c.is_row == of_row ? std::optional(c.number) : std::nullopt;
}

constexpr Quantity<InvalidCandidate> kInvalid[] = {
    {"name", always<&InvalidCandidate::name>, "as of a candidate"},
    {"source", always<source_name>, "catalogue | design"},
    {"source_name", always<&InvalidCandidate::list>, "as of a candidate"},
    {"row", of<number_of<true>>, "of the catalogue, from 1"},
    {"design", of<number_of<false>>, "from 1"},
    {"reason", always<&InvalidCandidate::reason>, "what is wrong"},
};

PRS_RECORD(InvalidCandidate, "InvalidCandidate", "What cannot be made.", kInvalid);

constexpr Quantity<Heat::Conductance> kConductance[] = {
    {"screw_ambient", of<&Heat::Conductance::screw_ambient>, "screw to surroundings"},
    {"nut_ambient", of<&Heat::Conductance::nut_ambient>, "nut to surroundings"},
    {"rollers_ambient", of<&Heat::Conductance::rollers_ambient>, "all rollers to surroundings"},
    {"screw_rollers", of<&Heat::Conductance::screw_rollers>, "screw to all rollers"},
    {"rollers_nut", of<&Heat::Conductance::rollers_nut>, "all rollers to nut"},
};

PRS_RECORD(Heat::Conductance, "ThermalConductances", "Of the network of the parts.", kConductance);

template <auto member>
constexpr auto of_electric = of<[](const SizedCandidate& c) {
  return c.electric ? std::optional<double>((*c.electric).*member) : std::nullopt;
}>;

template <auto get>
constexpr auto life_of = of<[](const auto& c) { return std::invoke(get, c.life); }>;

constexpr Quantity<SizedCandidate::ByThreads> kByThreads[] = {
    {"life_revolutions", life_of<&SizedLife::revolutions>, "rated, of all travel", source::kLife},
    {"life_hours", life_of<&SizedLife::hours>, "clock time, rests included"},
    {"life_km", life_of<&SizedLife::travel>, "of all travel"},
    {"static_safety", of<&SizedCandidate::ByThreads::static_safety>,
     "as `prs life`: pressure, deformation or edge loading"},
    {"dynamic_capacity_N", of<&SizedCandidate::ByThreads::capacity>, "Lemor's C_a"},
};

PRS_RECORD(SizedCandidate::ByThreads, "SizedByThreads", "Life and safety by the loads of the threads.", kByThreads);

constexpr Quantity<SizedSegment> kSegment[] = {
    {"name", always<[](const SizedSegment& s) { return std::string(s.name); }>, "of the motion"},
    {"efficiency", of<&SizedSegment::efficiency>, "of what drives"},
    {"driven_by", of<&SizedSegment::driven_by>, "screw | load"},
    {"power_loss_W", of<&SizedSegment::power_loss>, "at the mean speed of the segment"},
    {"torque_Nm", of<&SizedSegment::torque>, "at the part that turns, in the sense of the motion"},
    {"motor_torque_Nm", of<&SizedSegment::motor_torque>, "with drag, inertia and gear"},
};

PRS_RECORD(SizedSegment, "SizedSegment", "A segment of the motion on a candidate.", kSegment);

constexpr Quantity<SizeCriterion> kCriterion[] = {
    {"name", always<&SizeCriterion::name>, "what is held against a limit"},
    {"unit", always<&SizeCriterion::unit>, "of value and limit"},
    {"value", of<&SizeCriterion::value>, "of the candidate"},
    {"limit", of<&SizeCriterion::limit>, "of the requirement"},
    {"margin", of<&SizeCriterion::margin>, "value over limit or limit over value: 1 just passes"},
    {"status", always<&SizeCriterion::status>, "pass | fail | not_computed | not_applicable"},
    {"reason", filled<&SizeCriterion::reason>, "what the value rests on, or why there is none"},
};

PRS_RECORD(SizeCriterion, "SizeCriterion", "A value against its limit.", kCriterion);

constexpr Quantity<SizedCandidate> kCandidate[] = {
    {"rank", always<&SizedCandidate::rank>, "from 1, over all"},
    {"name", always<&SizedCandidate::name>, "of the row, else diameter x lead in mm; no two have one"},
    {"source", always<source_name>, "catalogue | design"},
    {"source_name", always<&SizedCandidate::list>, "maker or series, and file, of the row; the rules of a design"},
    {"row", of<number_of<true>>, "of the catalogue, from 1"},
    {"design", of<number_of<false>>, "from 1"},
    {"type", always<[](const SizedCandidate& c) { return contact::facts_of(c.screw.type).name; }>,
     "standard | inverted | recirculating"},
    {"screw_diameter_mm", of<[](const SizedCandidate& c) { return c.screw.screw_diameter; }>, "nominal"},
    {"lead_mm", of<[](const SizedCandidate& c) { return c.screw.lead; }>, "< 0 left-handed"},
    {"starts", always<&SizedCandidate::starts>, "of screw and nut"},
    {"nut_diameter_mm", of<&SizedCandidate::nut_diameter>, "outer"},
    {"nut_length_mm", of<&SizedCandidate::nut_length>, "of the whole nut"},
    {"passes", always<&SizedCandidate::passes>, "all criteria"},
    {"pareto", always<&SizedCandidate::pareto>,
     "no other that passes is as good in weight, nut diameter, life, torque and power lost, and "
     "better in one"},
    {"limited_by", filled<&SizedCandidate::limited_by>, "the criterion of the least margin"},
    {"weight_kg", of<&SizedCandidate::weight>, "nut, rollers, screw over the shaft's length"},
    {"shaft_length_mm", of<&SizedCandidate::shaft_length>, "between the supports"},
    {"life_basis", always<&SizedCandidate::life_basis>, "maker | threads"},
    {"basis", always<&SizedCandidate::basis>,
     "maker | computed | threads: life by the catalogues' formula with a printed or a computed C_a, or by the loads of "
     "the threads"},
    {"rated_dynamic_capacity_N", of<&SizedCandidate::rated_dynamic_capacity>, "C_a in the catalogues' formula"},
    {"rated_static_capacity_N", of<&SizedCandidate::rated_static_capacity>, "C_0 in the catalogues' formula"},
    {"assumed", always<&SizedCandidate::assumed>, "dimensions by the rules of `prs new`: the source states none"},
    {"life_revolutions", life_of<&SizedLife::revolutions>, "rated, of all travel", source::kLife},
    {"life_hours", life_of<&SizedLife::hours>, "clock time, rests included"},
    {"life_km", life_of<&SizedLife::travel>, "of all travel"},
    {"static_safety", of<&SizedCandidate::static_safety>, "by C_0, or by threads"},
    {"computed", of<&SizedCandidate::by_threads>, "the same by the loads of the threads"},
    {"dynamic_capacity_N", of<&SizedCandidate::dynamic_capacity>, "of the row"},
    {"static_capacity_N", of<&SizedCandidate::static_capacity>, "of the row"},
    {"drag_torque_Nm", of<&SizedCandidate::row_drag_torque>, "of the row"},
    {"axial_play_mm", of<&SizedCandidate::axial_play>, "of the row"},
    {"grease_volume_cm3", of<&SizedCandidate::grease_volume>, "of the row"},
    {"preload_N", of<&SizedCandidate::preload_force>, "of each flank without load"},
    {"no_load_torque_Nm", of<&SizedCandidate::no_load_torque>,
     "of the preload at the part that turns, at the mean speed"},
    {"bearing_equivalent_load_N", of<&SizedCandidate::bearing_load>, "of the bearing, with its preload"},
    {"bearing_life_hours", of<[](const SizedCandidate& c) { return c.bearing_life.hours; }>,
     "of the bearing at the required reliability, rests included"},
    {"bearing_life_km", of<[](const SizedCandidate& c) { return c.bearing_life.travel; }>, "the same, of all travel"},
    {"life_with_bearings_hours", of<[](const SizedCandidate& c) { return c.life_with_bearings.hours; }>,
     "L10 of screw and bearing together, rests included"},
    {"bearing_static_safety", of<&SizedCandidate::bearing_static_safety>, "static capacity over the largest force"},
    {"buckling_load_N", of<&SizedCandidate::buckling_load>, "of the shaft, as `prs measures`"},
    {"buckling_safety", of<&SizedCandidate::buckling_safety>, "against the largest compression"},
    {"critical_speed_rpm", of<&SizedCandidate::critical_speed>, "of a screw that turns"},
    {"largest_speed_rpm", of<&SizedCandidate::largest_speed>, "of screw against nut"},
    {"speed_times_diameter_mm_per_min", of<&SizedCandidate::speed_times_diameter>, "d the nominal diameter"},
    {"stiffness_N_per_um", of<&SizedCandidate::stiffness>,
     "of the load case with the largest force, in series with shaft and bearing"},
    {"efficiency", of<&SizedCandidate::efficiency>, "of the cycle, where the screw drives"},
    {"back_driving_efficiency", of<&SizedCandidate::back_driving_efficiency>, "absent where the screw locks itself"},
    {"self_locking", of<&SizedCandidate::self_locking>, "by slip"},
    {"temperature_degC", of<[](const SizedCandidate& c) {
       return c.temperature ? std::optional(celsius_of(*c.temperature)) : std::nullopt;
     }>,
     "mean of the cycle or the mission; absent without `heat`"},
    {"hottest_part_degC", of<[](const SizedCandidate& c) {
       const auto hottest = c.hottest_part();
       return hottest ? std::optional(*hottest - kZeroCelsius) : std::nullopt;
     }>,
     "largest of these; in a mission its peak"},
    {"heat_cycle", of<&SizedCandidate::mission>, "the mission; its course for the candidate with a curve"},
    {"conductance_W_per_K", of<&SizedCandidate::conductance>, "between parts and surroundings"},
    {"power_lost_W", of<&SizedCandidate::power_lost>, "mean of the cycle"},
    {"inertia_kg_mm2", of<&SizedCandidate::inertia>, "at the part that turns"},
    {"motor_rms_torque_Nm", of<&SizedCandidate::motor_rms_torque>, "over the cycle"},
    {"motor_peak_torque_Nm", of<&SizedCandidate::motor_peak_torque>, "largest of the cycle"},
    {"motor_largest_speed_rpm", of<&SizedCandidate::motor_largest_speed>, "with the gear"},
    {"motor_peak_power_W", of<&SizedCandidate::motor_peak_power>, "largest of the cycle"},
    {"inertia_ratio", of<&SizedCandidate::inertia_ratio>, "screw and mass over the motor's, at its shaft"},
    {"regenerated_mean_W", of<&SizedCandidate::regenerated_mean>, "over the cycle"},
    {"regenerated_peak_W", of<&SizedCandidate::regenerated_peak>, "largest of the cycle"},
    {"motor_rms_current_A", of_electric<&ElectricDemand::rms_current>, "over the cycle, of the direct-current motor"},
    {"motor_peak_current_A", of_electric<&ElectricDemand::peak_current>, "largest of the cycle"},
    {"motor_peak_voltage_V", of_electric<&ElectricDemand::peak_voltage>, "largest of the cycle"},
    {"motor_voltage_speed_rpm", of_electric<&ElectricDemand::voltage_speed>,
     "of the motor, up to which the supply's voltage drives the largest torque of the motion"},
    {"copper_loss_W", of_electric<&ElectricDemand::copper_loss>, "mean of R I^2"},
    {"electrical_energy_J", of_electric<&ElectricDemand::energy>, "per cycle, net"},
    {"regenerated_electrical_J", of_electric<&ElectricDemand::regenerated>, "per cycle, back to the supply"},
    {"reflected_mass_kg", of<&SizedCandidate::reflected_mass>, "of motor, gear and screw, at the nut"},
    {"back_driving_force_N", of<&SizedCandidate::back_driving_force>,
     "axial, with which a load begins to turn a motor without current; absent where the screw locks itself"},
    {"holding_torque_Nm", of<&SizedCandidate::holding_torque>, "at the motor, without friction"},
    {"brake_needed", always<&SizedCandidate::brake_needed>, "a force at rest turns the screw"},
    {"relubrication_h", of<&SizedCandidate::relubrication>, "interval by the makers' rule",
     "Rockwell MPAI-IN001F pp. 45 to 47; Tolomatic IMA-S guide pp. 34 to 35"},
    {"segments", always<&SizedCandidate::segments>, "of the motion"},
    {"criteria", always<&SizedCandidate::criteria>, "values against limits"},
    {"warnings", always<[](auto& c) { return sentences(c.warnings); }>, "on this candidate"},
};

PRS_RECORD(SizedCandidate, "SizedCandidate", "A screw against the requirement.", kCandidate);

struct NearestMiss {
  int rank = 1;
  std::vector<std::string> criteria;
};

constexpr Quantity<NearestMiss> kNearest[] = {
    {"rank", always<&NearestMiss::rank>, "1"},
    {"criteria", always<&NearestMiss::criteria>, "that it misses"},
};

PRS_RECORD(NearestMiss, "NearestMiss", "The first candidate where nothing passes.", kNearest);

constexpr Quantity<Relaxation> kRelaxation[] = {
    {"criterion", always<&Relaxation::criterion>, "that is missed"},
    {"rank", always<&Relaxation::rank>, "of the candidate"},
    {"limit", of<&Relaxation::limit>, "as it is, in the unit of the criterion; of the brake its torque, N m"},
    {"needed", of<&Relaxation::needed>, "with which this candidate passes"},
    {"margin", of<&Relaxation::margin>, "as it is"},
};

PRS_RECORD(Relaxation, "Relaxation", "What a limit would have to be.", kRelaxation);

constexpr Quantity<SizeCurve::Required> kRequired[] = {
    {"name", always<&SizeCurve::Required::segment>, "of the motion"},
    {"speed_mm_per_s", of<&SizeCurve::Required::speed>, "largest of the segment"},
    {"force_N", always<&SizeCurve::Required::force>, "axial, without sense"},
    {"driven_by", of<&SizeCurve::Required::driven_by>, "screw | load; absent at rest"},
};

PRS_RECORD(SizeCurve::Required, "RequiredForce", "A force that the motion requires at its speed.", kRequired);

constexpr Quantity<SizeCurve> kCurve[] = {
    {"rank", always<&SizeCurve::rank>, "of the candidate"},
    {"speed_mm_per_s", of<&SizeCurve::speed>, "constant, in one sense"},
    {"efficiency", of<&SizeCurve::efficiency>, "under the mean load"},
    {"force_N", of<&SizeCurve::force>,
     "that the candidate carries on and on; envelope: the least of all but motor_peak. NAME_in_cycle: mean load with "
     "the rests and changes of the cycle, that meets the limit at the mean speed if the candidate does"},
    {"required", always<&SizeCurve::required>, "segments of the motion under force"},
};

PRS_RECORD(SizeCurve, "SizeCurve", "Force over speed.", kCurve);

constexpr Quantity<SizeResult> kResult[] = {
    {"requirement", always<[](const SizeResult& r) {
       return RequirementOf{&r, &r.input.cycle};
     }>,
     "what no candidate changes"},
    {"counts", always<[](const SizeResult& r) {
       return SizeCounts{r.passing(), r.candidates.size() - r.passing(), r.invalid.size()};
     }>,
     "of the candidates"},
    {"objective", always<[](const SizeResult& r) { return name(r.input.values.objective); }>,
     "weight | nut_diameter | life | motor_torque | power_lost"},
    {"nearest",
     of<[](const SizeResult& r) {
       return NearestMiss{1, r.candidates[0].missed()};
     },
        [](const SizeResult& r) { return r.passing() == 0; }>,
     "where nothing passes"},
    {"relax", of<&SizeResult::relax>, "of the candidates that miss one criterion alone, the one that misses it least"},
    {"curve", of<&SizeResult::curve>, "of one candidate"},
    {"invalid", always<&SizeResult::invalid>, "refused by the rules of `prs new`"},
    {"candidates", always<&SizeResult::candidates>, "by rank"},
};

PRS_RECORD(SizeResult, "Size", "Candidates against a requirement.", kResult);

namespace {

/// The document without its candidates.
Json outline_of(const SizeResult& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  for (const Quantity<SizeResult>& q : record_of<SizeResult>().quantities)
    if (q.key == "candidates")
      document[q.key] = Json::array();
    else
      put_quantities<SizeResult>(document, std::span(&q, 1), result);
  return document;
}

/// Summary of a requirement and the number of candidate screws.
Delivery checked(const input::Source& source) {
  const auto in = std::make_shared<const SizeInput>(read_requirement(source));
  auto warnings = in->warnings;
  const std::size_t count = candidates_of(*in, warnings).size();
  Delivery d{"check.json"};
  d.document = [in, warnings, count](const DocumentInfo& info) {
    Json document = document_head(info, warnings);
    document["commands"] = {{"size", {{"ready", true}, {"missing", Json::array()}}}};
    document["candidates"] = count;
    for (const input::EchoEntry& f : in->fields)
      document["input"].push_back({{"path", f.path}, {"value", f.value}, {"default", f.is_default}});
    return document;
  };
  const auto table = [in, warnings, count](bool all) {
    std::string text = fmt::format("A requirement, ready for `prs size`: {} candidates\n\nInput\n", count);
    for (const input::EchoEntry& f : in->fields)
      if (all || !f.is_default)
        text += fmt::format("  {:<42} {}   ({})\n", f.path, f.value, f.is_default ? "default" : "given");
    if (!all) text += "  defaults: with --all\n";
    return text;
  };
  d.table = [table] { return table(false); };
  d.full_table = [table] { return table(true); };
  d.warnings = [warnings] { return warnings; };
  d.notes = as_notes(warnings);
  return d;
}

}  // namespace

Delivery size_delivery(SizeResult computed, std::size_t rows) {
  const auto result = std::make_shared<const SizeResult>(std::move(computed));
  Delivery d{"size.json"};
  d.held = result;
  d.result_type = &typeid(SizeResult);
  d.outline = [result](const DocumentInfo& info) { return outline_of(*result, info); };
  d.document = [result](const DocumentInfo& info) {
    Json document = outline_of(*result, info);
    for (const SizedCandidate& c : result->candidates) document["candidates"].push_back(object_of(c));
    return document;
  };
  d.write = [result](const Json& outline, const TextSink& sink) {
    const auto item = [&](std::size_t k) {
      return k < result->candidates.size() ? std::optional(object_of(result->candidates[k])) : std::nullopt;
    };
    write_with_list(outline, "candidates", item, sink);
  };
  d.table = [result, rows] { return size_table(*result, rows); };
  d.full_table = [result] { return size_table(*result, result->candidates.size()); };
  d.warnings = [result] { return result->warnings; };
  d.notes = as_notes(result->warnings);
  d.files = [result](const CsvStyle& style) { return size_files(*result, style); };
  d.pictures = [result] { return size_pictures(*result); };
  return d;
}

const OtherFile& size_file() {
  static const OtherFile file{
      .command = Command::size,
      .help = "Which screw, and which motor: candidates against a requirement",
      .name = "requirement",
      .key = "motion",
      .run = [](const input::Source& source) { return size_delivery(size_screws(read_requirement(source))); },
      .check = checked,
      .schema = requirement_schema,
      .resolved_input = resolved_requirement,
      .files = requirement_files,
      .record = describe<SizeResult>,
      .result_class = "SizeResult"};
  return file;
}

namespace {

constexpr std::size_t kCompared = 5;  ///< Number of candidates whose margins are shown side by side.

/// Passing candidates over diameter and lead in the colour of their limiting criterion, failing ones grey.
Figures map(const SizeResult& r) {
  Figure figure{"size_map", "Candidates"};
  figure.x = {"Screw diameter", "mm"};
  figure.y = {"Lead", "mm"};
  figure.aspect = 0.7;
  Panel panel;
  const auto add = [&](std::string title, const Style& style, auto belongs) {
    Series points{figure.styles.size()};
    for (const SizedCandidate& c : r.candidates)
      if (belongs(c)) points.add(1e3 * c.screw.screw_diameter, 1e3 * std::abs(c.screw.lead));
    if (points.parts.empty()) return;
    figure.add(std::move(title), style);
    panel.series.push_back(std::move(points));
  };
  add("fails", points_of(Colour::muted, Mark::cross), [](const SizedCandidate& c) { return !c.passes; });
  std::vector<std::string_view> limits;
  for (const SizedCandidate& c : r.candidates)
    if (c.passes && std::ranges::find(limits, c.limited_by) == limits.end()) limits.push_back(c.limited_by);
  for (std::size_t k = 0; k < limits.size(); ++k)
    add("passes, limited by " + (limits[k].empty() ? "nothing" : words_of(limits[k])),
        points_of(palette(k), Mark::circle),
        [&](const SizedCandidate& c) { return c.passes && c.limited_by == limits[k]; });
  const Range range = range_of_y(panel.series);
  panel.y = fitted(figure.y, range, true);
  figure.panels = {std::move(panel)};
  return {std::move(figure)};
}

/// Forces that a candidate carries over the speed, and forces of the motion: single ones below the lines of strength
/// and peak torque, their mean below that of the cycle.
Figures curve(const SizeResult& r) {
  if (!r.curve) return {};
  const SizeCurve& c = *r.curve;
  const MotionCycle& cycle = r.input.cycle;
  const SizedCandidate& chosen = r.candidates[static_cast<std::size_t>(c.rank) - 1];
  Figure figure{"size_curve", shown_name(chosen.name) + ": force over speed"};
  figure.x = {"Speed", "mm/s"};
  figure.aspect = 0.7;
  Panel panel;
  Range range;
  double single = std::numeric_limits<double>::infinity();  ///< Smallest limit of a single force [kN].
  constexpr std::string_view kInCycle = "_in_cycle";
  for (const auto& [limit, forces] : c.force) {
    const bool in_cycle = limit.ends_with(kInCycle);
    constexpr std::string_view kSingle = " static buckling motor_peak motor_current motor_voltage ";
    if (!in_cycle && kSingle.find(fmt::format(" {} ", limit)) == kSingle.npos) continue;
    const bool all = limit.starts_with("envelope");
    const std::string_view of = std::string_view(limit).substr(0, limit.size() - (in_cycle ? kInCycle.size() : 0));
    Series line{figure.add(all ? "mean load in this cycle" : words_of(of) + (in_cycle ? ", mean load" : ""),
                           all ? line_of(Colour::ink, Dash::solid, Weight::strong)
                               : line_of(palette(figure.styles.size()), in_cycle ? Dash::dotted : Dash::dashed))};
    for (std::size_t k = 0; k < forces.size(); ++k) {
      const double kilonewtons = forces[k] * "kN"_per_si;
      line.add(1e3 * c.speed[k], std::isfinite(kilonewtons) ? std::optional(kilonewtons) : std::nullopt);
      if (all && c.speed[k] >= cycle.driving_speed()) range.include(1.2 * kilonewtons);
      if (!in_cycle) single = std::fmin(single, kilonewtons);
    }
    panel.series.push_back(std::move(line));
  }
  const auto points = [&](std::string title, const Style& style, auto belongs) {
    constexpr double kKilonewton = "kN"_per_si;
    Series marks{figure.styles.size()};
    for (const SizeCurve::Required& point : c.required)
      if (belongs(point)) marks.add(1e3 * point.speed, kKilonewton * point.force);
    if (marks.parts.empty()) return;
    figure.add(std::move(title), style);
    panel.series.push_back(std::move(marks));
  };
  const auto by_load = [](const SizeCurve::Required& point) { return point.driven_by == DrivenBy::load; };
  points("required", points_of(Colour::ink, Mark::circle), std::not_fn(by_load));
  points("required, the load drives", points_of(Colour::muted, Mark::triangle), by_load);
  if (cycle.mean_load) {
    Series mean{figure.add("required, mean load", points_of(Colour::vermillion, Mark::diamond))};
    mean.add(1e3 * cycle.driving_speed(), "kN"_per_si * *cycle.mean_load);
    panel.series.push_back(std::move(mean));
  }
  const double largest = "kN"_per_si * cycle.largest_force;
  // Lines far above would compress the others.
  range.include(std::max(1.2 * largest, std::min(1.1 * single, 3.0 * largest)));
  panel.y = fitted({"Axial force", "kN"}, {0.0, range.to}, true);
  figure.panels = {std::move(panel)};
  return {std::move(figure)};
}

/// Temperatures of the first candidate over the mission.
Figures mission(const SizeResult& r) {
  for (const SizedCandidate& c : r.candidates) {
    if (!c.mission || !c.mission->converged() || c.mission->time.empty()) continue;
    Figures figures = heat_cycle(*c.mission);
    figures.front().name = "size_mission";
    figures.front().title = fmt::format("{}: temperatures over the mission", shown_name(c.name));
    return figures;
  }
  return {};
}

/// Ratio and reflected mass of a lever over its angle.
Figures lever(const SizeResult& r) {
  const std::optional<LeverMotion> motion = lever_of(r.input);
  if (!motion || motion->angles[0] == motion->angles[1]) return {};
  constexpr double kDegrees = "deg"_per_si, kSteps = 90.0;
  Figure figure{"size_lever", "Lever"};
  figure.x = {"Angle between base and arm", "deg", kDegrees * motion->angles[0], kDegrees * motion->angles[1]};
  figure.columns = 2;
  for (const bool is_mass : {false, true}) {
    if (is_mass && motion->inertia == 0.0) continue;
    Series line{figure.add(line_of(is_mass ? Colour::vermillion : Colour::blue))};
    for (double k = 0.0; k <= kSteps; ++k) {
      const PrsLever at = motion->at(k / kSteps);
      line.add(kDegrees * at.angle, is_mass ? motion->reflected_mass(at) : "mm/rad"_per_si * at.ratio);
    }
    Panel& panel = figure.panels.emplace_back();
    panel.series = {std::move(line)};
    panel.y = fitted(is_mass ? Axis{"Reflected mass", "kg"} : Axis{"Ratio", "mm/rad"}, range_of_y(panel.series));
  }
  return {std::move(figure)};
}

/// Margins of the first candidates, criterion by criterion; below 1 a criterion fails.
Figures margins(const SizeResult& r) {
  Figure figure{"size_margins", "Margins"};
  std::vector<std::string> names;
  std::vector<std::string_view> keys;
  const std::size_t count = std::min(kCompared, r.candidates.size());
  for (std::size_t k = 0; k < count; ++k)
    for (const SizeCriterion& c : r.candidates[k].criteria)
      if (c.margin && std::ranges::find(keys, c.name) == keys.end()) {
        keys.push_back(c.name);
        names.push_back(words_of(c.name));
      }
  if (keys.empty()) return {};
  Range range{1.0, 1.0};
  Panel panel;
  for (std::size_t k = 0; k < count; ++k) {
    Series bars{figure.add(shown_name(r.candidates[k].name), area_of(palette(k)))};
    const double height = 0.8 / static_cast<double>(count);
    for (const SizeCriterion& c : r.candidates[k].criteria) {
      if (!c.margin || !(*c.margin > 0.0)) continue;
      const auto row = static_cast<std::size_t>(std::ranges::find(keys, c.name) - keys.begin());
      const double top = rank_position(row, keys.size()) + 0.4 - static_cast<double>(k) * height;
      bars.parts.push_back(rectangle(std::min(1.0, *c.margin), std::max(1.0, *c.margin), top - height, top));
      range.include(*c.margin);
    }
    panel.series.push_back(std::move(bars));
  }
  figure.x = {.label = "Margin", .from = 0.9 * range.from, .to = 1.1 * range.to, .logarithmic = true};
  panel.y = ranked_axis(names);
  panel.references.push_back({figure.add(kZeroStyle), 1.0, true});
  figure.panels = {std::move(panel)};
  figure.aspect = 0.9;
  return {std::move(figure)};
}

}  // namespace

Pictures size_pictures(const SizeResult& r) {
  return {{"size_map", "candidates", of_result(r, map)},
          {"size_curve", "a mean load and a limit of speed", of_result(r, curve)},
          {"size_margins", "criteria with margins", of_result(r, margins)},
          {"size_mission", "a mission", of_result(r, mission)},
          {"size_lever", "a lever that moves", of_result(r, lever)}};
}

namespace {

constexpr std::size_t kNameWidth = 22;

using Cells = std::vector<std::string>;

/// Rows of columns as wide as their texts, left-aligned where `sides` has an `l`.
std::string aligned(const std::vector<Cells>& rows, std::string_view sides) {
  std::vector<std::size_t> widths(sides.size(), 0);
  for (const Cells& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], width(row[k]));
  std::string text;
  for (const Cells& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) line += "  " + padded(row[k], widths[k], sides[k] == 'l');
    text += ended(std::move(line));
  }
  return text;
}

std::string asked(const SizeResult& r) {
  const MotionCycle& c = r.input.cycle;
  std::vector<std::string> parts;
  if (c.mean_load) parts.push_back("mean load " + fixed_with_unit(c.mean_load, "kN", 3));
  parts.push_back("largest force " + fixed_with_unit(c.largest_force, "kN", 3));
  parts.push_back("largest speed " + significant_with_unit(c.largest_speed, "mm/s"));
  parts.push_back(fmt::format("{} per cycle of {:.4g} s", fixed_with_unit(c.travel, "mm", 0), c.duration));
  if (r.input.values.stroke) parts.push_back("stroke " + fixed_with_unit(r.input.values.stroke, "mm", 0));
  return hanging("Asked for: ", 11, fmt::format("{}", fmt::join(parts, ", ")));
}

/// Unit of tables for one of documents: `degC` where tables have no other.
std::string unit_in_tables(std::string_view unit) {
  const ShownUnit tables = table_unit(unit);
  return std::string(tables.text.empty() ? unit : tables.text);
}

/// A limit as a file states it or, rounded to its safe side with so many digits, as it would have to be.
std::string limit_text(const Relaxation& relax, double value, std::optional<int> digits = {}) {
  const bool is_share = relax.criterion == "efficiency" || relax.criterion == "critical_speed";
  const std::string unit = is_share ? "%" : unit_in_tables(relax.unit);
  double shown = value * (is_share ? "%"_per_si : table_factor(relax.unit));
  if (digits && shown != 0.0) {
    const double digit = std::pow(10.0, std::floor(std::log10(std::abs(shown))) + 1.0 - *digits);
    const double steps = shown / digit, whole = std::round(steps);
    const bool is_whole = std::abs(steps - whole) < 1e-6;
    shown = digit * (is_whole ? whole : relax.needed < relax.limit ? std::floor(steps) : std::ceil(steps));
  }
  return fmt::format("{:.6g}{}{}", shown, unit.empty() ? "" : " ", unit);
}

/// The change of a limit that would let a candidate pass.
std::string to_relax(const SizeResult& r, bool misses_several) {
  if (r.relax) {
    const std::string limit = limit_text(*r.relax, r.relax->limit), rough = limit_text(*r.relax, r.relax->needed, 4);
    return hanging("  ", 2,
                   fmt::format("To relax: with {} of {} instead of {}, {} passes.", words_of(r.relax->criterion),
                               rough == limit ? limit_text(*r.relax, r.relax->needed, 6) : rough, limit,
                               r.candidates[static_cast<std::size_t>(r.relax->rank) - 1].name));
  }
  for (const SizedCandidate& c : r.candidates)
    if (c.missed() == std::vector<std::string>{"back_driving"})
      return hanging("  ", 2, fmt::format("To relax: with `back_driving: allowed`, {} passes.", c.name));
  if (!misses_several) return {};
  return hanging("  ", 2, "To relax: no limit alone suffices. Relax several, change the motion, or add candidates.");
}

std::string verdict(const SizeResult& r) {
  const std::size_t passing = r.passing(), invalid = r.invalid.size();
  const std::string refused = invalid == 0 ? "" : fmt::format("; {} cannot be made: see size.json", invalid);
  if (passing > 0) return fmt::format("{} of {} candidates pass{}\n", passing, r.candidates.size() + invalid, refused);
  const SizedCandidate& nearest = r.candidates.front();
  std::vector<std::string> missed;
  std::vector<std::pair<std::string, std::vector<std::string>>> unknown;  // By their reason.
  for (const SizeCriterion& c : nearest.criteria) {
    if (c.status == CriterionStatus::fail) missed.push_back(words_of(c.name));
    if (c.status != CriterionStatus::not_computed) continue;
    auto same = std::ranges::find(unknown, c.reason, &decltype(unknown)::value_type::first);
    if (same == unknown.end()) same = unknown.insert(same, {c.reason, {}});
    same->second.push_back(words_of(c.name));
  }
  std::string text = fmt::format("NOTHING PASSES, of {} candidates{}\n", r.candidates.size() + invalid, refused);
  if (!missed.empty())
    text += hanging("  ", 2, fmt::format("The nearest, {}, misses {}.", nearest.name, fmt::join(missed, ", ")));
  for (const auto& [reason, names] : unknown)
    text += hanging("  ", 2, fmt::format("Not known of {}: {}: {}.", nearest.name, fmt::join(names, ", "), reason));
  return text + to_relax(r, missed.size() > 1);
}

/// Whether temperatures depend on estimated conductances to still air.
bool is_rough(const SizeResult& r) {
  const auto& heat = r.input.values.heat;
  return heat && !(heat->conductance.screw_ambient && heat->conductance.nut_ambient);
}

/// Basis of lives and safeties of the list.
std::string basis_note(const SizeResult& r) {
  const auto from = [&](std::string_view basis) {
    return std::ranges::any_of(r.candidates, [&](const SizedCandidate& c) { return c.basis() == basis; });
  };
  if (from("threads"))
    return "All by the loads of their threads, with profiles as `prs new` assumes them; life.basis: maker takes the "
           "formulas of catalogues";
  std::string text = "All by the formulas of catalogues, with C_a and C_0 ";
  text += !from("computed") ? "of the source" : from("maker") ? "of the source, else computed" : "computed";
  return text + "; makers print different ones for one size, so compare with yours";
}

Cells first_cells(const SizedCandidate& c) {
  return {fmt::format("{}", c.rank), shortened(printable(c.name), kNameWidth)};
}

/// Cells that compare a screw with the requirement.
Cells screw_row(const SizedCandidate& c) {
  Cells cells = first_cells(c);
  for (std::string text : {std::string(c.passes ? "passes" : "fails"), significant(c.life.hours, 4),
                           std::string(c.basis()), fixed(c.static_safety, 1.0, 2), fixed(c.buckling_safety, 1.0, 2),
                           fixed(c.weight, "kg", 2), words_of(c.limited_by)})
    cells.push_back(std::move(text));
  return cells;
}

/// Cells with a screw's type, its demands on motor and cooling, and its source.
Cells drive_row(const SizeResult& r, const SizedCandidate& c) {
  const std::optional<double> heat = c.hottest_part();
  Cells cells = first_cells(c);
  for (std::string text :
       {std::string(contact::facts_of(c.screw.type).name), fmt::format("{}", c.starts),
        fixed(c.motor_rms_torque, "N m", 2), fixed(c.motor_peak_torque, "N m", 2),
        fixed(c.motor_largest_speed, "rpm"_per_si, 0), fixed(c.motor_peak_power, 1e-3, 2),
        heat ? fmt::format("{:.0f}{}", *heat - kZeroCelsius, is_rough(r) ? "*" : "") : std::string(kAbsent),
        std::string(c.brake_needed ? "yes" : "no"), printable(c.list)})
    cells.push_back(std::move(text));
  return cells;
}

std::string candidate_rows(const SizeResult& r, std::size_t count) {
  const std::string torque = with_table_unit("N m");
  const std::string life = fmt::format("L{:.3g}", 100.0 - r.input.values.life.reliability * "%"_per_si);
  std::vector<Cells> screws{{"", "", "", life, "", "static", "buckling", "weight", "limited"},
                            {"rank", "screw", "", "h", "basis", "safety", "safety", with_table_unit("kg"), "by"}};
  std::vector<Cells> drives{{"", "", "", "", "T rms", "T peak", "motor", "peak", "hottest", "", ""},
                            {"rank", "screw", "type", "starts", torque, torque, "rpm", "kW", "°C", "brake", "source"}};
  for (std::size_t k = 0; k < std::min(count, r.candidates.size()); ++k) {
    screws.push_back(screw_row(r.candidates[k]));
    drives.push_back(drive_row(r, r.candidates[k]));
  }
  std::string text = aligned(screws, "rllrlrrrl");
  if (count < r.candidates.size())
    text += fmt::format("  … of {}; more with --top N, {}\n", r.candidates.size(), all_in("size.csv"));
  text += "\n" + aligned(drives, "rllrrrrrrll") + hanging("  ", 2, basis_note(r));
  if (is_rough(r)) text += "  * of bare parts in still air: a bolted housing takes several times as much, see `heat`\n";
  if (!r.input.values.heat) text += "  Temperatures are not known: `heat` would say what seat, bearings and air take\n";
  return text;
}

/// A bar of the margin: half of its length is 1.
std::string bar(double margin) {
  constexpr double kHalf = 10.0;
  const auto length = static_cast<std::size_t>(std::lround(std::min(margin, 2.0) * kHalf));
  std::string text;
  for (std::size_t k = 0; k < length; ++k) text += "█";
  return margin > 2.0 ? text + "▶" : text;
}

std::string criteria_rows(const SizedCandidate& c) {
  std::string text = fmt::format("{}, {:.6g} x {:.6g} {}, {} starts\n", c.name, shown(c.screw.screw_diameter, "mm"),
                                 shown(c.screw.lead, "mm"), table_unit("mm").text, c.starts);
  text += fmt::format("  {:<30}{:>10}{:>10}{:>9}\n", "", "value", "limit", "margin");
  for (const SizeCriterion& k : c.criteria) {
    const auto in = [&](std::optional<double> of) { return of ? std::optional(*of * table_factor(k.unit)) : of; };
    std::string line =
        "  " + padded(words_of(k.name) + (k.unit.empty() ? "" : ", " + unit_in_tables(k.unit)), 30, true);
    line += padded(significant(in(k.value), 4), 10, false) + padded(significant(in(k.limit), 6), 10, false);
    line += padded(significant(k.margin, 4), 9, false) + "  ";
    if (k.status != CriterionStatus::pass) line += words_of(name(k.status)) + " ";
    line += k.margin ? bar(*k.margin) : k.reason;
    text += ended(std::move(line));
  }
  return text;
}

/// A criterion and the default input that it depends on.
constexpr std::pair<std::string_view, std::string_view> kRestsOn[] = {
    {"life", "life.basis"},
    {"static_safety", "limits.static_safety"},
    {"static_safety", "life.basis"},
    {"bearing_static_safety", "limits.static_safety"},
    {"buckling", "limits.buckling_safety"},
    {"buckling", "measures.shaft.ends"},
    {"critical_speed", "limits.critical_speed_share"},
    {"critical_speed", "measures.shaft.ends"},
    {"speed_times_diameter", "limits.speed_times_diameter"},
    {"efficiency", "friction"},
    {"motor_torque", "friction"},
    {"motor_peak_torque", "friction"},
    {"temperature", "friction"},
    {"temperature", "heat.ambient"},
    {"temperature", "motion.period"},
    {"brake", "brake.safety"},
};

}  // namespace

std::vector<std::string> deciding_defaults(const SizeResult& r) {
  std::set<std::string_view> decided;
  for (const SizedCandidate& c : r.candidates) {
    decided.insert(c.limited_by);
    for (const SizeCriterion& k : c.criteria)
      if (!k.holds()) decided.insert(k.name);
  }
  std::vector<std::string> told;
  for (const auto& [criterion, input] : kRestsOn)
    for (const input::EchoEntry& f : r.input.fields) {
      if (!f.is_default || !f.path.starts_with(input) || !decided.contains(criterion)) continue;
      std::string text = fmt::format("{}: {}", f.path, f.value);
      if (std::ranges::find(told, text) == told.end()) told.push_back(std::move(text));
    }
  return told;
}

std::string size_table(const SizeResult& r, std::size_t rows) {
  std::string text =
      verdict(r) + asked(r) + "\n" + candidate_rows(r, rows) + "\n" + criteria_rows(r.candidates.front());
  if (const std::vector<std::string> defaults = deciding_defaults(r); !defaults.empty())
    text += "\nDefaults that decide\n" + hanging("  ", 2, fmt::format("{}", fmt::join(defaults, "; ")));
  std::vector<Warning> warnings = r.warnings;
  std::ranges::copy(r.candidates.front().warnings, std::back_inserter(warnings));
  return text + warning_section(warnings);
}

namespace {

std::string candidates_csv(const SizeResult& r, const CsvStyle& style) {
  CsvRows csv(style);
  for (const SizedCandidate& c : r.candidates) {
    csv.record("", c);
    csv.record("temperature_degC.", c.temperature ? std::optional(celsius_of(*c.temperature)) : std::nullopt);
    csv.record("computed.", c.by_threads);
    csv.end_row();
  }
  return csv.take();
}

/// All items of all candidates, with a column `kind` for their names.
template <class Item>
std::string items_csv(const SizeResult& r, const std::vector<Item> SizedCandidate::*items, std::string_view kind,
                      const CsvStyle& style) {
  CsvRows csv(style);
  const auto add_row = [&](const SizedCandidate& c, const Item& item) {
    csv("rank", c.rank);
    csv("candidate", c.name);
    csv(kind, std::string(item.name));
    csv.record("", item, record_of<Item>().quantities[1].key);
    csv.end_row();
  };
  add_row({}, {});
  csv.drop_rows();
  for (const SizedCandidate& c : r.candidates)
    for (const Item& item : c.*items) add_row(c, item);
  return csv.take();
}

}  // namespace

std::vector<OutputFile> size_files(const SizeResult& r, const CsvStyle& style) {
  std::vector<OutputFile> files{{"size.csv", candidates_csv(r, style)},
                                {"size_criteria.csv", items_csv(r, &SizedCandidate::criteria, "criterion", style)},
                                {"size_segments.csv", items_csv(r, &SizedCandidate::segments, "segment", style)}};
  if (const auto lever = lever_of(r.input)) files.push_back({"linkage.csv", linkage_csv(*lever, style)});
  return files;
}

}  // namespace prs
