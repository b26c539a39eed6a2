#pragma once

#include "prs/optimize/optimizer.h"
#include "prs/study/derivatives.h"
#include "prs/study/study_result.h"

namespace prs {

/// The engine of a study; a response that the base case lacks is an InputError at its place in the file. The input must
/// outlive the engine.
DesignEngine study_engine(const input::StudyInput& in);

/// The base case with its derivatives, for the plan `derivatives`; errors as in `study_engine`.
CaseDerivatives run_derivatives(const input::StudyInput& in);

/// The engine as a function for schedules: returns the results available after a second, and immediately after an
/// interruption. The engine must outlive it.
Evaluate evaluate_with(const DesignEngine& engine, const std::function<bool()>& interrupted = {});

/// Warnings on factors that change neither loads nor stiffness because the file overrides their effect: one sentence
/// per factor, with the responses that do not follow it.
std::vector<Warning> void_factor_warnings(const input::StudyInput& in, const std::vector<std::string>& responses);

/// Warnings as above, and those on factors that moved no response. `engine` is called only if designs that differ in
/// one factor alone are missing; it must be that of the result's study. Empty: a warning says that these factors were
/// not checked.
std::vector<Warning> study_warnings(const input::StudyInput& in, const StudyResult& result,
                                    const std::function<const DesignEngine&()>& engine);

/// Hash of all inputs of a study's rows: program, file, overrides and the force history that they refer to.
std::string key_of(const input::StudyInput& in, Command command);

/// Checks limits relative to the file's own design once its responses are known. Throws InputError.
void check_initial(const input::OptimizeInput& input, const EvaluatedDesign& initial);

/// Runs the optimization of a source on `threads` threads: the file's own design first, on which limits may depend,
/// then the search on the journal that `open` gives for it. Absent if it was interrupted. Throws InputError, also for a
/// response that the design does not have.
std::optional<OptimizationResult> run_optimization(const input::OptimizeInput& in, std::size_t threads,
                                                   const std::function<Journal(const JournalHeader&)>& open,
                                                   const OptimizeOptions& options);

/// The source with the chosen design written into it; none if no design was chosen.
std::optional<std::string> chosen_case(const OptimizationResult& result, const input::Source& source);

}  // namespace prs
