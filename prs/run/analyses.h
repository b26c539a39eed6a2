#pragma once

#include <string>
#include <vector>

#include "prs/input/echo.h"
#include "prs/input/reader.h"
#include "prs/input/source.h"
#include "prs/life/analyze_life.h"
#include "prs/loads/result.h"
#include "prs/measures/analyze_measures.h"
#include "prs/model/case.h"
#include "prs/preload/analyze_preload.h"
#include "prs/quantities/json.h"

namespace prs {

/// What `prs check` says of a case.
struct CheckResult {
  std::vector<input::EchoEntry> fields;
  Contacts contacts;
  std::vector<std::string> warnings;
};

// What each command computes from a case that was read from `source` for it, with the warnings that
// belong to the command. What the case turns out to have wrong is an InputError at its place.

/// Reads and checks the study and the optimization of the source too.
CheckResult run_check(const input::Source& source, const input::CaseInput& in);
Result run_contact(const input::Source& source, const Case& c);
Result run_solve(const input::Source& source, const Case& c);
Result run_slip(const input::Source& source, const Case& c);
PreloadResult run_preload(const input::Source& source, const Case& c);
/// Reads the force history that the case refers to.
LifeResult run_life(const input::Source& source, const Case& c);
MeasuresResult run_measures(const input::Source& source, const Case& c);

/// What the documents of a source say of their origin.
DocumentInfo document_info(const input::Source& source);

}  // namespace prs
