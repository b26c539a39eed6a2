#pragma once

#include <functional>
#include <string>
#include <vector>

#include "prs/input/study_reader.h"
#include "prs/study/derivatives.h"
#include "prs/study/design_engine.h"
#include "prs/study/schedule.h"
#include "prs/study/study_result.h"

namespace prs {

/// The engine of a study; a response that the base case does not have is an InputError where it
/// stands in the file. The input must outlive the engine.
DesignEngine study_engine(const input::StudyInput& in);

/// The same for the plan that is one case with its derivatives.
CaseDerivatives run_derivatives(const input::StudyInput& in);

/// The engine, which must outlive the function, as schedules call it.
Evaluate evaluate_with(const DesignEngine& engine);

/// Which factors of a study change neither loads nor stiffness, as overrides of the file stand in
/// for what they would change, a sentence each, with those of the responses that do not follow.
std::vector<std::string> void_factor_warnings(const input::StudyInput& in,
                                              const std::vector<std::string>& responses);

/// The same, and which factors moved no response. `engine` is asked for only where designs that
/// differ in one factor alone are missing; it must have the study of the result.
std::vector<std::string> study_warnings(const input::StudyInput& in, const StudyResult& result,
                                        const std::function<const DesignEngine&()>& engine);

/// What the rows of a study depend on, as one hash: program, file, overrides and the force history
/// that they refer to.
std::string key_of(const input::StudyInput& in, Command command);

}  // namespace prs
