#include "prs/run/analyses.h"

#include "modules/fit/fit_analysis.h"
#include "modules/response/response_analysis.h"
#include "prs/compare/compare_analysis.h"
#include "prs/configurations/configurations_files.h"
#include "prs/losses/life_analysis.h"
#include "prs/losses/preload_analysis.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/solve_analysis.h"
#include "prs/measures/measures_analysis.h"
#include "prs/optimize/optimize_files.h"
#include "prs/run/check.h"
#include "prs/run/compare_cases.h"
#include "prs/size/size_analysis.h"
#include "prs/study/study_files.h"

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
      any(response_analysis()),
      {Command::study, "Run the study of the file: many designs, a row each"},
      {.command = Command::optimize,
       .help = "Search the designs that the file aims at",
       .result_class = "OptimizationResult"},
      any(fit_analysis()),
  };
  return all;
}

std::span<const OtherFile> other_files() {
  static const OtherFile all[] = {size_file()};
  return all;
}

std::string_view left_out(const Case&) { return {}; }

std::span<const DocumentForm> document_forms() {
  static const DocumentForm all[] = {
      {"compare", case_comparison_record},          {"study", describe<StudyDocument>},
      {"study", describe<CaseDerivatives>},         {"optimize", describe<OptimizationResult>},
      {"configurations", describe<Configurations>},
  };
  return all;
}

}  // namespace prs
