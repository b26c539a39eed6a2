#include "modules/response/response_analysis.h"

#include "modules/response/response_figures.h"
#include "modules/response/response_table.h"
#include "prs/loads/load_criteria.h"
#include "prs/record/csv_rows.h"

namespace prs {
namespace {

/// Parts of the result with records of their own.
struct PartOf {
  const ResponseResult* whole = nullptr;
};
struct EnergyOf : PartOf {};
struct LostOf : PartOf {};
struct LargestOf : PartOf {};

const DriveResult& run_of(const ResponseResult& r) { return r.run; }
const DriveResult& run_of(const PartOf& part) { return part.whole->run; }
template <auto member>
constexpr auto member_of_run = [](const auto& owner) -> const auto& {
  return run_of(owner).*member;
};
template <auto member, auto guard = nullptr>
constexpr auto of_run = of<member_of_run<member>, guard>;

}  // namespace

Record<EnergyOf> record_of(Type<EnergyOf>);
Record<LostOf> record_of(Type<LostOf>);
Record<LargestOf> record_of(Type<LargestOf>);
Record<MostLoaded> record_of(Type<MostLoaded>);
Record<LargestForce> record_of(Type<LargestForce>);
Record<FollowingError> record_of(Type<FollowingError>);
Record<DriveImpact> record_of(Type<DriveImpact>);
Record<SettlingResult> record_of(Type<SettlingResult>);
Record<Resonance> record_of(Type<Resonance>);
Record<FrequencyResponse> record_of(Type<FrequencyResponse>);

namespace {

bool has_following(const FollowingError& f) { return f.of_position; }
bool of_speed(const FollowingError& f) { return !f.of_position; }
bool has_threads(const LargestForce& l) { return l.threads.has_value(); }
bool has_lead(const LeverMotion& m) { return m.lead != 0.0; }

constexpr Quantity<MostLoaded> kMostLoaded[] = {
    {"normal_load_N", of<&MostLoaded::normal_load>, "of one roller's thread"},
    {"thread", of<&MostLoaded::thread>, "1 is the first"},
    {"peak_pressure_MPa", of<&MostLoaded::peak_pressure>, "of this thread"},
};

constexpr Quantity<LargestForce> kLargestForce[] = {
    {"force_N", of<&LargestForce::force>, "magnitude"},
    {"time_s", of<&LargestForce::time>, "when"},
    {"screw", of<[](auto& l) { return l.threads->screw; }, has_threads>,
     "the most loaded thread of the screw by `prs solve` at this force"},
    {"nut", of<[](auto& l) { return l.threads->nut; }, has_threads>, "the same of the nut"},
    {"max_normal_load_N", of<&LargestForce::normal_load>, "of a thread under this external load, by `prs preload`"},
    {"peak_pressure_MPa", of<[](auto& l) { return l.normal_load ? l.peak_pressure : std::nullopt; }>,
     "larger one of both sides, by `prs preload`"},
};

constexpr Quantity<LargestOf> kLargest[] = {
    {"tension", of<[](auto& l) { return l.whole->largest.tension; }>, "largest force in tension"},
    {"compression", of<[](auto& l) { return l.whole->largest.compression; }>, "largest force in compression"},
    {"motor_torque_Nm", of<[](auto& l) { return l.whole->run.torque.value; }>, "magnitude"},
    {"end_stop_force_N",
     of<[](auto& l) { return l.whole->run.stop.value; }, [](auto& l) { return l.whole->has_stops(); }>, "magnitude"},
};

constexpr Quantity<LostOf> kLost[] = {
    {"screw_friction", of_run<&DriveResult::screw_friction>, "threads and drag"},
    {"motor_friction", of_run<&DriveResult::motor_friction>, "dry friction of the motor, brake"},
    {"load_friction", of_run<&DriveResult::load_friction>, "dry friction of the guides"},
    {"coupling", of_run<&DriveResult::coupling>, "damping of the coupling"},
    {"contact", of_run<&DriveResult::contact>, "material damping of the screw"},
    {"end_stop", of_run<&DriveResult::end_stop>, "damping of the end stops"},
    {"viscous", of_run<&DriveResult::viscous>, "viscous damping of motor and load"},
};

constexpr Quantity<EnergyOf> kEnergy[] = {
    {"motor", of_run<&DriveResult::motor>, "what the motor put in"},
    {"load", of_run<&DriveResult::load>, "what the external force put in"},
    {"stored_start", of_run<&DriveResult::stored_start>, "kinetic and elastic energy at the start"},
    {"stored_end", of_run<&DriveResult::stored_end>, "the same at the end"},
    {"lost", of<[](auto& e) { return LostOf{e}; }>, "what friction and damping took"},
    {"residual", of<[](auto& e) { return e.whole->residual(); }>, "motor + load - change of stored energy - all lost"},
    {"turnover", of_run<&DriveResult::turnover>,
     "integral of the magnitudes of both powers, plus the stored energy at the start"},
    {"residual_relative",
     of<[](auto& e) { return std::abs(e.whole->residual()) / std::max(e.whole->run.turnover, 1e-300); }>,
     "residual over turnover"},
};

constexpr Quantity<FollowingError> kFollowing[] = {
    {"largest_um", of<&FollowingError::largest, has_following>, "of the position of the load against its reference"},
    {"largest_rpm", of<&FollowingError::largest, of_speed>, "of the speed of the motor against its reference"},
    {"time_s", of<&FollowingError::time>, "of the largest"},
    {"rms_um", of<&FollowingError::rms, has_following>, "root of the mean square"},
    {"rms_rpm", of<&FollowingError::rms, of_speed>, "root of the mean square"},
};

constexpr Quantity<DriveImpact> kImpact[] = {
    {"time_s", of<&DriveImpact::time>, "when the flank closes"},
    {"flank", of<[](auto& i) { return i.flank < 0 ? "compression" : "tension"; }>, "tension | compression"},
    {"speed_mm_per_s", of<&DriveImpact::speed>, "of closing"},
    {"energy_J", of<&DriveImpact::energy>, "of the reduced mass at that speed"},
    {"largest_force_N", of<[](auto& i) { return i.force.value; }>, "of this flank up to the next impact or the end"},
};

constexpr Quantity<SettlingResult> kSettling[] = {
    {"final_position_mm", of<&SettlingResult::final_position>, "of the last sample"},
    {"reference_mm", of<&SettlingResult::reference>, "of a position loop at the end"},
    {"settled", of<&SettlingResult::settled>, "whether the last sample lies within the band of it"},
    {"time_s", of<&SettlingResult::time>, "from `after` to the first sample from which on all lie within the band"},
};

constexpr Quantity<Resonance> kResonance[] = {
    {"frequency_Hz", of<&Resonance::frequency>, "|lambda|/(2 pi)"},
    {"damping_percent", of<&Resonance::damping>, "-Re lambda/|lambda|"},
};

constexpr Quantity<FrequencyResponse> kFrequencyResponse[] = {
    {"frequency_Hz", of<&FrequencyResponse::frequency>, "of the force or the torque"},
    {"compliance_um_per_N", filled<&FrequencyResponse::compliance>, "position of the load over a force on it"},
    {"phase_deg", filled<&FrequencyResponse::phase>, "of that, < 0 behind the force"},
    {"stiffness_N_per_um", filled<&FrequencyResponse::stiffness>, "1/compliance"},
    {"motor_speed_rad_per_s_per_Nm", filled<&FrequencyResponse::motor_speed>, "motor speed over motor torque"},
    {"motor_speed_phase_deg", filled<&FrequencyResponse::motor_speed_phase>, "of that"},
    {"position_um_per_Nm", filled<&FrequencyResponse::position>, "position of the load over motor torque"},
    {"position_phase_deg", filled<&FrequencyResponse::position_phase>, "of that"},
    {"tangent_stiffness_N_per_um", of<&FrequencyResponse::tangent_stiffness>, "with the shaft, at the working point"},
    {"resonances", of<&FrequencyResponse::resonances>, "natural vibrations, by frequency"},
};

constexpr Quantity<ResponseResult> kResponse[] = {
    {"converged", always<&ResponseResult::converged>, "whether the run came to its end"},
    {"status", always<[](auto& r) { return name(r.run.status); }>, "converged | step_limit | integration_failed"},
    {"stopped_at_s", of_run<&DriveResult::stopped_at, [](auto& r) { return !r.converged(); }>,
     "where a run that did not converge ended"},
    {"duration_s", of<[](auto& r) { return r.input.duration; }>, "of the run"},
    {"time_s", of_run<&DriveResult::time>, "of the samples"},
    {"position_mm", of_run<&DriveResult::x>, "of the load"},
    {"speed_mm_per_s", of_run<&DriveResult::v>, "of the load"},
    {"screw_angle_deg", of_run<&DriveResult::phi>, "not reduced by turns"},
    {"screw_speed_rpm", of_run<&DriveResult::omega>, "of the screw"},
    {"motor_angle_deg", of_run<&DriveResult::phi_m>, "not reduced by turns"},
    {"motor_speed_rpm", of_run<&DriveResult::omega_m>, "of the motor"},
    {"deflection_um", of_run<&DriveResult::delta>, "of screw and shaft, > 0 in tension"},
    {"force_N", of_run<&DriveResult::force>, "of the screw, > 0 in tension"},
    {"motor_torque_Nm", of_run<&DriveResult::motor_torque>, "behind the current loop"},
    {"coupling_torque_Nm", of_run<&DriveResult::coupling_torque>, "between motor and screw"},
    {"external_force_N", of_run<&DriveResult::external>, "on the load"},
    {"end_stop_force_N", of_run<&DriveResult::stop_force, &ResponseResult::has_stops>, "magnitude"},
    {"lever_angle_deg", filled<member_of_run<&DriveResult::lever_angle>>, "between base and arm"},
    {"lever_speed_rpm", filled<member_of_run<&DriveResult::lever_speed>>, "of the lever"},
    {"lever_torque_Nm", filled<member_of_run<&DriveResult::lever_torque>>, "external, against growing angles"},
    {"energy_J", of<[](auto& r) { return EnergyOf{{&r}}; }>, "over the whole run"},
    {"largest", of<[](auto& r) { return LargestOf{{&r}}; }>, "over the whole run"},
    {"rms_motor_torque_Nm", of<&ResponseResult::rms_torque>, "root of the mean square"},
    {"lost_motion_um", of_run<&DriveResult::lost_motion>,
     "largest less least travel of the motor beyond that of the load"},
    {"following_error", of<&ResponseResult::following_error>, "of the controller, up to its cut"},
    {"impacts", of_run<&DriveResult::impacts, &ResponseResult::can_open>, "each instant at which a flank closes"},
    {"settling", of<&ResponseResult::settling>, "with the block `settling`"},
    {"frequency_response", of<&ResponseResult::frequency_response>, "with the block `frequency_response`"},
};

}  // namespace

PRS_RECORD(EnergyOf, "ResponseEnergy", "Energies of a run, in joules.", kEnergy);
PRS_RECORD(LostOf, "ResponseLosses", "What friction and damping took over a run, in joules.", kLost);
PRS_RECORD(LargestOf, "ResponseLargest", "Extremes of a run.", kLargest);
PRS_RECORD(MostLoaded, "ResponseThread", "The most loaded thread of an interface.", kMostLoaded);
PRS_RECORD(LargestForce, "ResponseForce", "A largest force of a run, and the threads under it.", kLargestForce);
PRS_RECORD(FollowingError, "FollowingError", "How far a controlled drive is off its reference.", kFollowing);
PRS_RECORD(DriveImpact, "ResponseImpact", "A flank that closes.", kImpact);
PRS_RECORD(SettlingResult, "Settling", "When the load comes to rest.", kSettling);
PRS_RECORD(Resonance, "Resonance", "A natural vibration of the drive.", kResonance);
PRS_RECORD(FrequencyResponse, "FrequencyResponse", "Small vibration about a working point.", kFrequencyResponse);
Record<ResponseResult> record_of(Type<ResponseResult>);
PRS_RECORD(ResponseResult, "Response", "The screw in its drive over time and over frequency, docs/response.md.",
           kResponse);

constexpr Quantity<LeverMotion> kLever[] = {
    {"smallest_angle_deg", of<[](const LeverMotion& m) { return m.angles[0]; }>, "between base and arm"},
    {"largest_angle_deg", of<[](const LeverMotion& m) { return m.angles[1]; }>, "between base and arm"},
    {"middle_angle_deg", of<[](const LeverMotion& m) { return m.middle().angle; }>, "between these two"},
    {"middle_length_mm", of<[](const LeverMotion& m) { return m.middle().length; }>, "between the screw's ends, there"},
    {"middle_ratio_mm_per_rad", of<[](const LeverMotion& m) { return m.middle().ratio; }>, "travel over angle, there"},
    {"middle_reflected_mass_kg", of<[](const LeverMotion& m) { return m.reflected_mass(m.middle()); }>,
     "at the nut, there"},
    {"middle_gear_ratio", of<[](const LeverMotion& m) { return m.gear_ratio(m.middle()); }, has_lead>,
     "turns of the screw per turn of the lever, there"},
    {"middle_reflected_inertia_kg_mm2",
     of<[](const LeverMotion& m) { return m.inertia / std::pow(m.gear_ratio(m.middle()), 2); }, has_lead>,
     "at the screw, there"},
};
PRS_RECORD(LeverMotion, "LeverMotion", "A lever over its motion, as its screw sees it.", kLever);

std::optional<LeverMotion> lever_motion(const ResponseInput& in, double lead) {
  if (!in.load.linkage) return std::nullopt;
  constexpr double kDegree = std::numbers::pi / 180.0;
  const double start = prs_lever(&*in.load.linkage, *in.start.angle).length - in.start.position;
  const auto at = [&](const std::optional<ResponseInput::EndStop>& stop, double otherwise) {
    return stop ? prs_lever_of_length(&*in.load.linkage, start + stop->at).angle : otherwise;
  };
  return LeverMotion{*in.load.linkage,
                     in.load.inertia,
                     {at(in.end_stops.lower, kDegree), at(in.end_stops.upper, 179.0 * kDegree)},
                     lead};
}

std::string linkage_csv(const LeverMotion& motion, const CsvStyle& style) {
  constexpr int kSteps = 180;
  CsvRows csv(style);
  for (int k = 0; k <= kSteps; ++k) {
    const PrsLever lever = motion.at(static_cast<double>(k) / kSteps);
    csv("angle_deg", lever.angle);
    csv("length_mm", lever.length);
    csv("ratio_mm_per_rad", lever.ratio);
    csv("reflected_mass_kg", motion.reflected_mass(lever));
    if (has_lead(motion)) {
      csv("gear_ratio", motion.gear_ratio(lever));
      csv("reflected_inertia_kg_mm2", motion.inertia / std::pow(motion.gear_ratio(lever), 2));
    }
    csv.end_row();
  }
  return csv.take();
}

std::string response_csv(const ResponseResult& result, const CsvStyle& style) {
  CsvWriter csv(style);
  std::vector<const Quantity<ResponseResult>*> columns;
  for (const Quantity<ResponseResult>& q : kResponse)
    if (q.value.series && !q.value.series(result).empty()) columns.push_back(&q);
  for (const auto* q : columns) csv.text(q->key);
  csv.end_row();
  for (std::size_t k = 0; k < result.run.time.size(); ++k) {
    for (const auto* q : columns) csv.number(q->value.series(result)[k], q->unit.factor);
    csv.end_row();
  }
  return csv.take();
}

namespace {

constexpr std::string_view kResponses[] = {"response.largest.tension.force_N", "response.largest.compression.force_N",
                                           "response.largest.motor_torque_Nm", "response.lost_motion_um"};

/// The largest force, and its pressure relative to the static limit of ISO 76's kind.
std::vector<Headline> headlines(const ResponseResult& r) {
  const std::optional<LargestForce>* larger = &r.largest.tension;
  if (r.largest.compression && (!*larger || (*larger)->force < r.largest.compression->force))
    larger = &r.largest.compression;
  if (!*larger) return {};
  std::vector<Headline> all{
      {"Largest force", "force_N", (*larger)->force, larger == &r.largest.tension ? "tension" : "compression"}};
  if (const std::optional<ContactPressure> pressure = (*larger)->pressure)
    all.push_back({"Peak pressure at the largest force", "peak_pressure_MPa", pressure->value,
                   pressure->limit
                       ? fmt::format("{}, limit {:g} GPa{}", label(pressure->at), *pressure->limit * "GPa"_per_si,
                                     pressure->share() > 1.0 ? ", not met" : "")
                       : fmt::format("{}, no limit is known", label(pressure->at))});
  return all;
}

std::vector<FoundCriterion> criteria(const ResponseResult& r, const JudgedCase& of) {
  FoundCriterion found("peak_pressure"), speed("largest_speed"), compression("largest_compression"),
      tension("largest_tension");
  for (const Direction d : kDirections)
    if (const auto& largest = r.largest[d]; largest && largest->pressure) {
      const ContactPressure& nearest = *largest->pressure;
      const double pressure = of.limits.peak_pressure ? *largest->peak_pressure : nearest.value;
      take_pressure(found, pressure, nearest.limit, of, "response", fmt::format("largest force in {}", name(d)));
    }
  found.best.reset();  // The best value is one of load cases, and a motion has none.
  speed.take(r.run.largest_speed, "response");
  for (const Direction d : kDirections)
    if (const auto& largest = r.largest[d]; largest && largest->force != 0.0)
      (d == Direction::compression ? compression : tension)
          .take(std::abs(largest->force), "response", fmt::format("largest force in {}", name(d)));
  return {found, speed, compression, tension};
}

PageSection section(const ResponseResult&) {
  return {.in_document = {{"response.largest", {"tension", "compression", "motor_torque_Nm", "end_stop_force_N"}}},
          .folded = {"response_energy"},
          .note = "The motion is that of the run that wrote this page."};
}

}  // namespace

const Analysis<ResponseResult>& response_analysis() {
  static const std::vector<Place> places = {{"response", describe<ResponseResult>}};
  static const Analysis<ResponseResult> analysis{
      .command = Command::response,
      .help = "The screw in its drive: motion, forces, impacts, energies over time; frequency response",
      .file = "response.json",
      .run = [](const input::Source& source,
                const input::CaseInput& in) { return analyze_response(in.values, source); },
      .places = places,
      .put = [](Json& document, const ResponseResult& r) { document["response"] = object_of(r); },
      .table = response_table,
      .files =
          [](const ResponseResult& r, const CsvStyle& style) {
            return std::vector<OutputFile>{{"response.csv", response_csv(r, style)}};
          },
      .pictures = [](const ResponseResult& r, const Case&) { return response_pictures(r); },
      .converged = [](const ResponseResult& r) { return r.converged(); },
      .headlines = headlines,
      .criteria = criteria,
      .place = {"Response", 5},
      .section = section,
      .responses = kResponses};
  return analysis;
}

}  // namespace prs
