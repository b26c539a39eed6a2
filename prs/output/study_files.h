#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "prs/output/json.h"
#include "prs/study/run.h"

namespace prs {

/// `study.csv`: a row a design, the base case first. Columns `value`, `number` and `unit` are those
/// of the factor that differs from the base case; responses have the paths for names.
std::string study_csv(const StudyResult& result);

/// The document of `prs study --json`: the study, and under `designs` what each of them gave.
nlohmann::ordered_json study_json(const StudyResult& result, const DocumentInfo& info);

}  // namespace prs
