#pragma once

#include <string>

#include "prs/input/study_reader.h"
#include "prs/study/derivatives.h"
#include "prs/study/design_engine.h"
#include "prs/study/schedule.h"

namespace prs {

/// The engine of a study; a response that the base case does not have is an InputError where it
/// stands in the file. The input must outlive the engine.
DesignEngine study_engine(const input::StudyInput& in);

/// The same for the plan that is one case with its derivatives.
CaseDerivatives run_derivatives(const input::StudyInput& in);

/// The engine, which must outlive the function, as schedules call it.
Evaluate evaluate_with(const DesignEngine& engine);

/// What the rows of a study depend on, as one hash: program, file, overrides and the force history
/// that they refer to.
std::string key_of(const input::StudyInput& in, Command command);

}  // namespace prs
