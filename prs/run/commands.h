#pragma once

#include "prs/loads/analysis_options.h"
#include "prs/record/analysis.h"

namespace prs {

/// All analyses and searches of a case, in the order in which they are shown.
std::span<const AnyAnalysis> analyses();

const AnyAnalysis& analysis_of(Command command);

/// Files other than a case.
std::span<const OtherFile> other_files();

/// The kind of a source that is no case, by its keys; null of a case.
const OtherFile* other_file(const input::Source& source);

/// A command's document of no analysis, or another form of one.
struct DocumentForm {
  std::string_view command;
  const RecordInfo& (*record)();
};
std::span<const DocumentForm> document_forms();

/// What a case asks for and this program leaves out (PRS_FULL): `model.bodies: influence`; empty in a
/// whole program.
std::string_view left_out(const Case& c);

/// `solve` by other means than those of its row, on a case that has all for it.
Delivery run_solve(const input::Source& source, const input::CaseInput& in, const AnalysisOptions& options);

/// Reads a case, or for `check` another file, for a command and runs it. Throws InputError, also
/// where the case lacks something.
Delivery run(const AnyAnalysis& analysis, const input::Source& source);

/// Origin of a command's documents of a source, which must have been read for it without an error.
DocumentInfo document_info(const input::Source& source, Command command);

/// How a run ended: exit statuses of the programs, statuses of answers.
enum Exit { kDone = 0, kFailed = 1, kWrongInput = 2, kNotConverged = 3, kBeyondTolerance = 4 };
constexpr Exit status_of(const Delivery& delivery) {
  return !delivery.converged ? kNotConverged : delivery.within_tolerance ? kDone : kBeyondTolerance;
}

}  // namespace prs
