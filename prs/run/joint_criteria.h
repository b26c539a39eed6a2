#pragma once

#include "prs/life/analyze_life.h"
#include "prs/measures/measures.h"
#include "prs/model/criterion.h"

/// Criteria that no analysis finds alone: of the case itself, and those that need the results of several.
namespace prs {

/// Criteria of the case itself: what it states of speeds, compression, nut and stroke, the play of its threads.
std::vector<FoundCriterion> case_criteria(const Case& c, const Contacts& contacts);

/// Measures without the load cases that have no force, which `measures` refuses: `slip` alone takes them, under
/// preload. Nothing where there are none, or the inputs are incomplete.
std::optional<MeasuresResult> measures_under_load(const Case& c);

/// Measures of load cases at the temperatures that `slip` finds for their losses. Nothing where these are not known.
std::optional<MeasuresResult> warm_measures(const Case& c, const MeasuresResult& measures, const Result* slip);

/// Load cases at rest under preload, which `solve` and `measures` lack, at the temperatures that `slip` finds; the
/// static limits of each.
struct PreloadedLoads {
  Result loads;
  std::vector<StaticForces> forces = {};
};
/// Throws CaseError where the preload cannot be had.
std::optional<PreloadedLoads> loads_under_preload(const Case& c, const Contacts& contacts, const Result* slip);
/// Criteria under preload; `measures` has what is in series with the mechanism, if it is known.
std::vector<FoundCriterion> preloaded_criteria(const PreloadedLoads& preloaded, const JudgedCase& of,
                                               const MeasuresResult* measures);

/// Static safeties and safety against edge loading under the largest force of a sense, where no load case has it: a
/// force of the drive, or of a spectrum without life. `of` is warm with `temperature`. Those of threads only if
/// `solves` and loads can act in that sense.
std::vector<FoundCriterion> criteria_under(const JudgedCase& of, const Contacts& contacts,
                                           const std::optional<PerPart<double>>& temperature, bool solves,
                                           Direction direction, const FoundCriterion& force);

/// The buckling load that `measures` finds over the largest compression of load cases, `life` and `response`;
/// `is_unknown`: one of the last was not computed.
FoundCriterion buckling_safety(const Case& c, const MeasuresResult& measures, const FoundCriterion& compression,
                               bool is_unknown);

/// The largest speed of load cases, operation, `life` and `response` over the critical one that `measures` finds.
FoundCriterion critical_speed_share(const Case& c, const MeasuresResult& measures, const FoundCriterion& speed);
FoundCriterion speed_times_diameter(const Case& c, const FoundCriterion& speed);

}  // namespace prs
