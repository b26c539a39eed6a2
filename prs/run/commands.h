#pragma once

#include "prs/loads/analysis_options.h"
#include "prs/record/analysis.h"

namespace prs {

const AnyAnalysis& analysis_of(Command command);

/// Kind of a source that is not a case, by its keys; null for a case.
const OtherFile* other_file(const input::Source& source);

/// A document of a command that belongs to no analysis, or another form of one.
struct DocumentForm {
  std::string_view command;
  const RecordInfo& (*record)();
};

/// `solve` with other options than those of its row, on a case that has all inputs.
Delivery run_solve(const input::Source& source, const input::CaseInput& in, const AnalysisOptions& options);

/// Reads a case, or for `check` another file, for a command and runs it. Throws InputError, also if the case lacks
/// something.
Delivery run(const AnyAnalysis& analysis, const input::Source& source);

/// Origin of a command's documents for a source, which must have been read for it without an error.
DocumentInfo document_info(const input::Source& source, Command command);

/// Outcome of a run: exit statuses of the programs, statuses of answers.
enum Exit { kDone = 0, kFailed = 1, kWrongInput = 2, kNotConverged = 3, kBeyondTolerance = 4 };
constexpr Exit status_of(const Delivery& delivery) {
  return !delivery.converged ? kNotConverged : delivery.within_tolerance ? kDone : kBeyondTolerance;
}

}  // namespace prs
