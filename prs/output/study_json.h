#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "prs/quantities/json.h"
#include "prs/study/study_result.h"

namespace prs {

/// As the input writes it: `latin_hypercube`.
std::string_view name(Plan plan);

/// The document of `prs study --json`: the study; under `summary` what the designs say together,
/// under `envelope` the envelope of a study that has one, and under `designs` what each of those
/// kept gave, with `designs_shown` where that is not all of them.
nlohmann::ordered_json study_json(const StudyResult& result, const DocumentInfo& info);

}  // namespace prs
