#pragma once

#include "prs/loads/load_json.h"
#include "prs/record/record.h"
#include "prs/study/study_result.h"

namespace prs {

/// As the input writes it: `latin_hypercube`.
std::string_view name(Plan plan);

/// What the document of a study says of it.
struct StudyDocument {
  const StudyResult* result = nullptr;
  bool with_rows = true;
};
Record<StudyDocument> record_of(Type<StudyDocument>);
Record<Level> record_of(Type<Level>);

/// The document of `prs study --json`: the study; under `summary` what the designs say together,
/// under `envelope` the envelope of a study that has one, and under `designs` what each of those
/// kept gave, with `designs_shown` where that is not all of them.
Json study_json(const StudyResult& result, const DocumentInfo& info);
/// The same with an empty list of designs.
Json study_outline(const StudyResult& result, const DocumentInfo& info);

/// An outline with the designs of the result in its empty list: what `json_text` gives of
/// `study_json`, one design after the other.
void write_study(const Json& outline, const StudyResult& result, const TextSink& sink);

}  // namespace prs
