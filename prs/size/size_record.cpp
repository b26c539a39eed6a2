#include <algorithm>
#include <cmath>

#include "prs/configurations/configurations_files.h"
#include "prs/losses/heat_record.h"
#include "prs/record/record_table.h"
#include "prs/size/size_analysis.h"

namespace prs {
namespace {

/// The requirement as far as no candidate changes it.
struct RequirementOf {
  const SizeResult* result = nullptr;
};
struct CountsOf {
  const SizeResult* result = nullptr;
};
struct NearestOf {
  int rank = 0;
  std::vector<std::string> criteria;
};

constexpr std::string_view kThk = "THK general catalogue, axial loads";

/// Whether the cycle has a mean load and a mean speed.
bool moves(const RequirementOf& r) { return r.result->input.cycle.mean_speed.has_value(); }
template <auto member>
constexpr auto of_cycle =
    of<[](const RequirementOf& r) { return std::invoke(member, r.result->input.cycle); }>;

}  // namespace

template <>
Record<RequirementOf> record_of();
template <>
Record<MotionSegment> record_of();
template <>
Record<CountsOf> record_of();
template <>
Record<NearestOf> record_of();
template <>
Record<Relaxation> record_of();
template <>
Record<InvalidCandidate> record_of();
template <>
Record<SizeCurve> record_of();
template <>
Record<SizeCriterion> record_of();
template <>
Record<SizedSegment> record_of();

namespace {

constexpr Quantity<MotionSegment> kMotionSegment[] = {
    {"name", always<&MotionSegment::name>},
    {"duration_s", always<&MotionSegment::duration>, "of it, or of all in its class"},
    {"start_speed_mm_per_s", of<&MotionSegment::start_speed>, "signed"},
    {"end_speed_mm_per_s", of<&MotionSegment::end_speed>, "signed"},
    {"acceleration_m_per_s2", of<&MotionSegment::acceleration>, "signed"},
    {"travel_mm", of<&MotionSegment::travel>, "signed"},
    {"axial_force_N", always<&MotionSegment::force>,
     "on the screw, > 0 where it pushes the mass in the positive sense", kThk},
};

constexpr Quantity<RequirementOf> kRequirement[] = {
    {"cycle_s", of_cycle<&MotionCycle::duration>, "rests included"},
    {"moving_s", of_cycle<&MotionCycle::moving>, "time in motion, per cycle"},
    {"travel_mm", of_cycle<&MotionCycle::travel>, "per cycle, of both senses"},
    {"stroke_mm", of<[](const RequirementOf& r) { return r.result->input.values.stroke; }>,
     "as given, else the way between the extreme positions"},
    {"mean_load_N", of_cycle<&MotionCycle::mean_load>, "cubic mean over travel"},
    {"largest_force_N", of_cycle<&MotionCycle::largest_force>, "at rest too"},
    {"largest_speed_mm_per_s", of_cycle<&MotionCycle::largest_speed>},
    {"rms_speed_mm_per_s", of_cycle<&MotionCycle::rms_speed>, "over the cycle with its rests"},
    {"mean_speed_mm_per_s",
     of<[](const RequirementOf& r) { return *r.result->input.cycle.mean_speed; }, moves>,
     "travel over the time in motion"},
    {"segments", always<[](const RequirementOf& r) { return r.result->input.cycle.shown; }>,
     "of constant acceleration, or classes of many samples"},
};

constexpr Quantity<CountsOf> kCounts[] = {
    {"candidates", always<[](const CountsOf& c) {
       return c.result->candidates.size() + c.result->invalid.size();
     }>,
     "all rows and combinations"},
    {"passing", always<[](const CountsOf& c) { return c.result->passing(); }>},
    {"failing",
     always<[](const CountsOf& c) { return c.result->candidates.size() - c.result->passing(); }>},
    {"invalid", always<[](const CountsOf& c) { return c.result->invalid.size(); }>,
     "refused by the rules of `prs new`"},
};

/// Where a candidate comes from.
template <class T>
std::string_view source_name(const T& c) {
  return c.is_row ? "catalogue" : "design";
}
template <class T, bool of_row>
std::optional<std::size_t> number_of(const T& c) {
  return c.is_row == of_row ? std::optional(c.number) : std::nullopt;
}

constexpr Quantity<InvalidCandidate> kInvalid[] = {
    {"name", always<&InvalidCandidate::name>},
    {"source", always<source_name<InvalidCandidate>>, "catalogue | design"},
    {"row", of<number_of<InvalidCandidate, true>>, "of the catalogue, from 1"},
    {"design", of<number_of<InvalidCandidate, false>>, "from 1"},
    {"reason", always<&InvalidCandidate::reason>},
};

constexpr Quantity<Heat::Conductance> kConductance[] = {
    {"screw_ambient", of<&Heat::Conductance::screw_ambient>},
    {"nut_ambient", of<&Heat::Conductance::nut_ambient>},
    {"rollers_ambient", of<&Heat::Conductance::rollers_ambient>},
    {"screw_rollers", of<&Heat::Conductance::screw_rollers>},
    {"rollers_nut", of<&Heat::Conductance::rollers_nut>},
};

constexpr Quantity<SizedCandidate> kComputed[] = {
    {"life_revolutions", of<[](const SizedCandidate& c) { return c.thread_life.revolutions; }>,
     "rated, of all travel", source::kLife},
    {"life_hours", of<[](const SizedCandidate& c) { return c.thread_life.hours; }>},
    {"life_km", of<[](const SizedCandidate& c) { return c.thread_life.travel; }>},
    {"static_safety", of<&SizedCandidate::thread_static_safety>,
     "as `prs life`: pressure, deformation or a flank's edge"},
    {"dynamic_capacity_N", of<&SizedCandidate::thread_capacity>, "Lemor's C_a"},
};

constexpr Quantity<SizedSegment> kSegment[] = {
    {"name", always<[](const SizedSegment& s) { return std::string(s.name); }>},
    {"efficiency", of<&SizedSegment::efficiency>, "of what drives"},
    {"driven_by", of<&SizedSegment::driven_by>, "screw | load"},
    {"power_loss_W", of<&SizedSegment::power_loss>},
    {"torque_Nm", of<&SizedSegment::torque>, "at the part that turns, in the sense of the motion"},
    {"motor_torque_Nm", of<&SizedSegment::motor_torque>, "with drag, inertia and gear"},
};

constexpr Quantity<SizeCriterion> kCriterion[] = {
    {"name", always<&SizeCriterion::name>},
    {"unit", always<&SizeCriterion::unit>, "of value and limit"},
    {"value", of<&SizeCriterion::value>},
    {"limit", of<&SizeCriterion::limit>},
    {"margin", of<&SizeCriterion::margin>, "value over limit or limit over value: 1 just passes"},
    {"status", always<&SizeCriterion::status>, "pass | fail | not_computed | not_applicable"},
    {"reason", of<[](const SizeCriterion& c) {
       return c.reason.empty() ? std::nullopt : std::optional(c.reason);
     }>,
     "what the value rests on, or why there is none"},
};

template <auto get>
constexpr auto life_of = of<[](const SizedCandidate& c) { return std::invoke(get, c.life); }>;

constexpr Quantity<SizedCandidate> kCandidate[] = {
    {"rank", always<&SizedCandidate::rank>, "from 1, over all"},
    {"name", always<&SizedCandidate::name>, "of the row, else diameter x lead in mm"},
    {"source", always<source_name<SizedCandidate>>, "catalogue | design"},
    {"row", of<number_of<SizedCandidate, true>>, "of the catalogue, from 1"},
    {"design", of<number_of<SizedCandidate, false>>, "from 1"},
    {"type", always<[](const SizedCandidate& c) { return type_name(c.type); }>,
     "standard | inverted"},
    {"screw_diameter_mm", of<&SizedCandidate::screw_diameter>, "nominal"},
    {"lead_mm", of<&SizedCandidate::lead>, "< 0 left-handed"},
    {"starts", always<&SizedCandidate::starts>},
    {"nut_diameter_mm", of<&SizedCandidate::nut_diameter>},
    {"nut_length_mm", of<&SizedCandidate::nut_length>},
    {"passes", always<&SizedCandidate::passes>, "all criteria"},
    {"pareto", always<&SizedCandidate::pareto>,
     "no other that passes is as good in weight, nut diameter, life, torque and power lost, and "
     "better in one"},
    {"limited_by", of<[](const SizedCandidate& c) {
       return c.limited_by.empty() ? std::nullopt : std::optional(c.limited_by);
     }>,
     "the criterion of the least margin"},
    {"weight_kg", of<&SizedCandidate::weight>, "nut, rollers, screw over the shaft's length"},
    {"shaft_length_mm", of<&SizedCandidate::shaft_length>, "between the supports"},
    {"life_basis", always<&SizedCandidate::life_basis>, "maker | threads"},
    {"life_revolutions", life_of<&SizedLife::revolutions>, "rated, of all travel", source::kLife},
    {"life_hours", life_of<&SizedLife::hours>, "clock time, rests included"},
    {"life_km", life_of<&SizedLife::travel>},
    {"static_safety", of<&SizedCandidate::static_safety>, "maker's C_0, or by threads"},
    {"computed", of_table<kComputed>, "the same by the loads of the threads"},
    {"dynamic_capacity_N", of<&SizedCandidate::dynamic_capacity>, "of the row"},
    {"static_capacity_N", of<&SizedCandidate::static_capacity>, "of the row"},
    {"buckling_load_N", of<&SizedCandidate::buckling_load>},
    {"buckling_safety", of<&SizedCandidate::buckling_safety>},
    {"critical_speed_rpm", of<&SizedCandidate::critical_speed>, "of a screw that turns"},
    {"largest_speed_rpm", of<&SizedCandidate::largest_speed>},
    {"speed_times_diameter_mm_per_min", of<&SizedCandidate::speed_times_diameter>,
     "d the nominal diameter"},
    {"stiffness_N_per_um", of<&SizedCandidate::stiffness>,
     "of the load case with the largest force, in series with the shaft"},
    {"efficiency", of<&SizedCandidate::efficiency>, "of the cycle, where the screw drives"},
    {"back_driving_efficiency", of<&SizedCandidate::back_driving_efficiency>,
     "absent where the screw locks itself"},
    {"self_locking", of<&SizedCandidate::self_locking>, "by slip"},
    {"temperature_degC", of<[](const SizedCandidate& c) {
       return c.temperature ? std::optional(celsius_of(*c.temperature)) : std::nullopt;
     }>,
     "mean of the cycle"},
    {"conductance_W_per_K", of<&SizedCandidate::conductance>, "between parts and surroundings"},
    {"power_lost_W", of<&SizedCandidate::power_lost>, "mean of the cycle"},
    {"inertia_kg_mm2", of<&SizedCandidate::inertia>, "at the part that turns"},
    {"motor_rms_torque_Nm", of<&SizedCandidate::motor_rms_torque>, "over the cycle"},
    {"motor_peak_torque_Nm", of<&SizedCandidate::motor_peak_torque>},
    {"motor_largest_speed_rpm", of<&SizedCandidate::motor_largest_speed>},
    {"motor_peak_power_W", of<&SizedCandidate::motor_peak_power>},
    {"inertia_ratio", of<&SizedCandidate::inertia_ratio>,
     "screw and mass over the motor's, at its shaft"},
    {"regenerated_mean_W", of<&SizedCandidate::regenerated_mean>, "over the cycle"},
    {"regenerated_peak_W", of<&SizedCandidate::regenerated_peak>},
    {"holding_torque_Nm", of<&SizedCandidate::holding_torque>, "at the motor, without friction"},
    {"brake_needed", always<&SizedCandidate::brake_needed>},
    {"relubrication_h", of<&SizedCandidate::relubrication>, "interval by the makers' rule",
     "Rockwell MPAI-IN001F pp. 45 to 47; Tolomatic IMA-S guide pp. 34 to 35"},
    {"segments", always<&SizedCandidate::segments>, "of the motion"},
    {"criteria", always<&SizedCandidate::criteria>},
    {"warnings", always<&SizedCandidate::warnings>},
};

constexpr Quantity<NearestOf> kNearest[] = {
    {"rank", always<&NearestOf::rank>},
    {"criteria", always<&NearestOf::criteria>, "that it misses"},
};

constexpr Quantity<Relaxation> kRelaxation[] = {
    {"criterion", always<&Relaxation::criterion>},
    {"rank", always<&Relaxation::rank>},
    {"limit", of<&Relaxation::limit>, "as it is, in the unit of the criterion"},
    {"needed", of<&Relaxation::needed>, "with which this candidate passes"},
    {"margin", of<&Relaxation::margin>},
};

constexpr Quantity<SizeCurve> kForces[] = {
    {"static", of<&SizeCurve::by_static>},
    {"buckling", of<&SizeCurve::by_buckling>},
    {"life", of<&SizeCurve::by_life>},
    {"temperature", of<&SizeCurve::by_temperature>},
    {"motor_rated", of<&SizeCurve::by_motor_rated>},
    {"motor_peak", of<&SizeCurve::by_motor_peak>},
    {"envelope", of<&SizeCurve::envelope>, "the least of all but motor_peak"},
};

constexpr Quantity<SizeCurve> kCurve[] = {
    {"rank", always<&SizeCurve::rank>},
    {"speed_mm_per_s", of<&SizeCurve::speed>, "constant, in one sense"},
    {"efficiency", of<&SizeCurve::efficiency>, "under the mean load"},
    {"force_N", of_table<kForces>, "that the candidate carries on and on"},
};

constexpr Quantity<SizeResult> kResult[] = {
    {"requirement", always<[](const SizeResult& r) { return RequirementOf{&r}; }>,
     "what no candidate changes"},
    {"counts", always<[](const SizeResult& r) { return CountsOf{&r}; }>},
    {"objective", always<[](const SizeResult& r) { return r.input.values.objective; }>,
     "weight | nut_diameter | life | motor_torque | power_lost"},
    {"nearest", of<[](const SizeResult& r) -> std::optional<NearestOf> {
       if (r.passing() > 0) return std::nullopt;
       NearestOf nearest{1, {}};
       for (const SizeCriterion& c : r.candidates.front().criteria)
         if (!c.holds()) nearest.criteria.emplace_back(c.name);
       return nearest;
     }>,
     "where nothing passes"},
    {"relax", of<&SizeResult::relax>,
     "of the candidates that miss one criterion alone, the one that misses it least"},
    {"curve", of<&SizeResult::curve>, "of one candidate"},
    {"invalid", always<&SizeResult::invalid>, "refused by the rules of `prs new`"},
    {"candidates", always<&SizeResult::candidates>, "by rank"},
};

}  // namespace

template <>
Record<RequirementOf> record_of() {
  return {"SizeRequirement", "One cycle of the axis.", kRequirement};
}
template <>
Record<MotionSegment> record_of() {
  return {"MotionSegment", "Constant acceleration under one force.", kMotionSegment};
}
template <>
Record<CountsOf> record_of() {
  return {"SizeCounts", "How many candidates there are.", kCounts};
}
template <>
Record<InvalidCandidate> record_of() {
  return {"InvalidCandidate", "What cannot be made.", kInvalid};
}
template <>
Record<Heat::Conductance> record_of() {
  return {"ThermalConductances", "Of the network of the parts.", kConductance};
}
template <>
Record<SizedSegment> record_of() {
  return {"SizedSegment", "A segment of the motion on a candidate.", kSegment};
}
template <>
Record<SizeCriterion> record_of() {
  return {"SizeCriterion", "A value against its limit.", kCriterion};
}
template <>
Record<SizedCandidate> record_of() {
  return {"SizedCandidate", "A screw against the requirement.", kCandidate};
}
template <>
Record<NearestOf> record_of() {
  return {"NearestMiss", "The first candidate where nothing passes.", kNearest};
}
template <>
Record<Relaxation> record_of() {
  return {"Relaxation", "What a limit would have to be.", kRelaxation};
}
template <>
Record<SizeCurve> record_of() {
  return {"SizeCurve", "Force over speed.", kCurve};
}
template <>
Record<SizeResult> record_of() {
  return {"Size", "Candidates against a requirement.", kResult};
}

}  // namespace prs
