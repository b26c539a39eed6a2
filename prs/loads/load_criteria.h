#pragma once

#include <functional>

#include "prs/loads/result.h"
#include "prs/model/criterion.h"

namespace prs {

/// Largest normal load of all positions of a turn or a travel over that of the position where the carrier stands.
double rise_elsewhere(const LoadCaseResult& r);

/// Takes a peak pressure [Pa]. Where the case states no limit, it is held against the one that is known of the contact.
void take_pressure(FoundCriterion& found, double pressure, std::optional<double> limit, const JudgedCase& of,
                   std::string_view load_case, std::string note);

/// Pressures of load cases, on both flanks and in all positions. `at_rest`: of loads at rest, without the load cases
/// that are judged under preload.
FoundCriterion pressure_criterion(const Result& result, const JudgedCase& of, bool at_rest);

/// The static safety, which lacks the pressure that a part may have.
FoundCriterion static_safety_criterion(const Case& c);

/// `slip of 1 of 3 load cases`, of those that `good` does not hold for; empty without any.
std::string failed_cases(const Result& result, std::string_view what, bool (*good)(const LoadCaseResult&));

/// Takes the temperatures of the parts [K].
void take_temperatures(FoundCriterion& found, const PerPart<double>& kelvin, std::string_view where);

/// Compliance of what is in series with the mechanism [m/N], and the title of the sum.
struct InSeries {
  std::string_view title;
  double compliance = 0.0;
};
using InSeriesOf = std::function<std::optional<InSeries>(const LoadCase& load)>;

/// Stiffness under the largest force of the case, with what is in series if it has a limit; without preload not of load
/// cases whose stiffness under preload is judged.
FoundCriterion stiffness_criterion(const Result& result, const JudgedCase& of, const InSeriesOf& in_series,
                                   bool under_preload = false);

/// Pressure, stiffness and convergence. A limit of the stiffness is that of the drive: what is in series with the
/// screw counts too.
std::vector<FoundCriterion> load_criteria(const Result& result, const JudgedCase& of, const InSeriesOf& in_series);
inline std::vector<FoundCriterion> load_criteria(const Result& result, const JudgedCase& of) {
  return load_criteria(result, of, {});
}

}  // namespace prs
