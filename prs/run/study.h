#pragma once

#include "prs/study/derivatives.h"
#include "prs/study/design_engine.h"
#include "prs/study/schedule.h"
#include "prs/study/study_result.h"

namespace prs {

/// The engine of a study; a response that the base case does not have is an InputError where it
/// stands in the file. The input must outlive the engine.
DesignEngine study_engine(const input::StudyInput& in);

/// The base case with its derivatives, for the plan `derivatives`; errors as for `study_engine`.
CaseDerivatives run_derivatives(const input::StudyInput& in);

/// The engine as a function that schedules call: what it has after a second, and once it is
/// interrupted only what it has. The engine must outlive it.
Evaluate evaluate_with(const DesignEngine& engine, const std::function<bool()>& interrupted = {});

/// Warnings on factors that change neither loads nor stiffness because the file overrides what they
/// would change: one sentence per factor, with the responses that do not follow it.
std::vector<Warning> void_factor_warnings(const input::StudyInput& in,
                                          const std::vector<std::string>& responses);

/// These warnings, and those on factors that moved no response. `engine` is called only where
/// designs that differ in one factor alone are missing; it must be that of the result's study.
/// Empty: a warning says that these factors were not looked at.
std::vector<Warning> study_warnings(const input::StudyInput& in, const StudyResult& result,
                                    const std::function<const DesignEngine&()>& engine);

/// What the rows of a study depend on, as one hash: program, file, overrides and the force history
/// that they refer to.
std::string key_of(const input::StudyInput& in, Command command);

}  // namespace prs
