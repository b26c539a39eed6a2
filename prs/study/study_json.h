#pragma once

#include "prs/study/study_files.h"

namespace prs {

/// The document of `prs study --json`: the study; under `summary` the statistics of the designs, under `envelope` the
/// envelope of a study that has one, and under `designs` the results of each of those kept, with `designs_shown` if
/// these are not all.
Json study_json(const StudyResult& result, const DocumentInfo& info);

/// The document with an empty list of designs.
Json study_outline(const StudyResult& result, const DocumentInfo& info);

/// Writes an outline with the designs of the result in its empty list: the text that `json_text` gives for
/// `study_json`, one design after the other.
void write_study(const Json& outline, const StudyResult& result, const TextSink& sink);

}  // namespace prs
