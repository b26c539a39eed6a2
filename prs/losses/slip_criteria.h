#pragma once

#include "prs/loads/result.h"
#include "prs/model/criterion.h"
#include "prs/model/motor_duty.h"

namespace prs {

std::vector<FoundCriterion> slip_criteria(const Result& result, const JudgedCase& of);

/// Temperatures that the losses of a load case lead to, in a duty cycle its mean [K]; absent where they are not known.
std::optional<PerPart<double>> temperature_of(const Result& slip, const Case& c, std::size_t load_case);

/// Motor, brake and the load that may drive against the limits of the block `motor`. Torques and back driving follow
/// from slip and the inertia that `measures` finds; `why`: what slip lacks, null where it was not asked.
std::vector<FoundCriterion> motor_criteria(const Case& c, const MotorDuty& duty, const Result* slip,
                                           std::optional<double> inertia, const std::string* why);

}  // namespace prs
