#include "prs/run/commands.h"

#include "prs/compare/compare_analysis.h"
#include "prs/input/resolved_input.h"
#include "prs/loads/load_analysis.h"
#include "prs/losses/life_analysis.h"
#include "prs/losses/preload_analysis.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/solve_analysis.h"
#include "prs/measures/measures_analysis.h"
#include "prs/run/check.h"
#include "prs/version.h"

namespace prs {

std::span<const AnyAnalysis> analyses() {
  static const AnyAnalysis all[] = {
      any(check_analysis()),
      any(contact_analysis()),
      any(solve_analysis()),
      any(compare_analysis()),
      any(slip_analysis()),
      any(preload_analysis()),
      any(life_analysis()),
      any(measures_analysis()),
      {Command::study, "Run the study of the file: many designs, a row each"},
      {.command = Command::optimize,
       .help = "Search the designs that the file aims at",
       .result_class = "OptimizationResult"},
  };
  return all;
}

const AnyAnalysis& analysis_of(Command command) {
  const auto found = std::ranges::find(analyses(), command, &AnyAnalysis::command);
  if (found == analyses().end())
    throw std::logic_error(std::string(name(command)) + " is in no list of analyses");
  return *found;
}

Delivery run_solve(const input::Source& source, const input::CaseInput& in,
                   const AnalysisOptions& options) {
  return delivered(
      source, in, solve_analysis(),
      [&](const input::Source&, const input::CaseInput& of) { return solved(of.values, options); });
}

Delivery run(const AnyAnalysis& analysis, const input::Source& source) {
  return analysis.run(source, input::read_case_input(source, analysis.command));
}

DocumentInfo document_info(const input::Source& source, Command command) {
  return {kVersion,
          kSchemaVersion,
          input::input_sha256(source),
          source.overrides,
          std::string(name(command)),
          source.name,
          [source] { return input::resolved_input(source); }};
}

}  // namespace prs
