#include "prs/run/optimization.h"

#include <fmt/format.h>

#include <vector>

#include "prs/input/fail_at.h"
#include "prs/optimize/optimization_result.h"
#include "prs/optimize/optimize_case.h"
#include "prs/optimize/optimizer.h"
#include "prs/run/study.h"
#include "prs/study/design_engine.h"

namespace prs {
namespace {

DesignEngine engine_of(const input::OptimizeInput& in) {
  try {
    return DesignEngine(in.start);
  } catch (const UnknownResponse& error) {
    const std::string& at = in.asked_at[error.index()];
    if (at != "optimize.thread_constraints") input::fail_at(in.start.source, at, error.what());
    input::fail_at(in.start.source, at,
                   fmt::format("needs {}, which this mechanism does not have; expected threads "
                               "with heights and a contact at both interfaces; give "
                               "`mechanism.thread` of screw, roller and nut",
                               in.optimization.study.responses[error.index()]));
  }
}

std::string remark(const OptimizationResult& result, const std::string& file) {
  const std::size_t chosen = result.compromise.value_or(result.nearest.value_or(0));
  return fmt::format("{} of `prs optimize {}`, {} with seed {}: design {} of {}",
                     result.compromise ? "Compromise" : "Nearest design", file,
                     name(result.search_of(chosen).algorithm), result.optimization.seed, chosen + 1,
                     result.design_count());
}

}  // namespace

void check_initial(const input::OptimizeInput& input, const EvaluatedDesign& initial) {
  for (const Constraint& constraint : input.optimization.constraints) {
    if (constraint.limit.kind != Limit::Kind::initial) continue;
    if (std::isfinite(initial.responses[constraint.response])) continue;
    const std::string reason =
        initial.status.reason.empty()
            ? "it has no " + input.optimization.study.responses[constraint.response]
            : initial.status.reason;
    input::fail_at(
        input.start.source, input.asked_at[constraint.response],
        fmt::format("got a limit relative to the file's own design, which has no answer ({}); "
                    "expected a design that has one; fix the file, or write the limit as a "
                    "number",
                    reason));
  }
}

std::optional<OptimizationResult> run_optimization(
    const input::OptimizeInput& in, std::size_t threads,
    const std::function<Journal(const JournalHeader&)>& open, const OptimizeOptions& options) {
  const DesignEngine engine = engine_of(in);
  const Optimization& optimization = in.optimization;
  const EvaluateDesigns evaluate = evaluate_in_parallel(engine, threads);
  const std::vector<Draw> as_in_file(optimization.study.factors.size());
  const RowBlock base = evaluate({as_in_file});
  check_initial(in, {as_in_file, base.responses,
                     base.failures.empty() ? DesignStatus{} : base.failures[0].status, 0.0});

  Journal journal = open({key_of(in.start, optimization.study.command), in.start.source,
                          optimization.study.responses, design_count(optimization), Shard{}});
  return optimize(optimization, evaluate, journal, options);
}

std::optional<std::string> chosen_case(const OptimizationResult& result,
                                       const input::Source& source) {
  const EvaluatedDesign* chosen = result.chosen();
  if (chosen == nullptr) return std::nullopt;
  return case_with(source, settings_of(result.optimization, *chosen), remark(result, source.name));
}

}  // namespace prs
