#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "prs/loads/load_analysis.h"
#include "prs/record/pictures.h"
#include "prs/study/study_result.h"

namespace prs::fuzz {

/// Throws where a number is not finite, or anything null; `at` says where the value stands.
void expect_finite(const nlohmann::ordered_json& value, const std::string& at);

/// Makes all figures; what a map or a line leaves out is NaN in them, nothing is infinite.
void expect_drawable(const Pictures& pictures);

/// Makes every form of a study's rows.
void expect_stored_study(const StudyResult& result, const DocumentInfo& info);

/// Values of a fit lie within their bounds, and in their intervals.
void expect_fitted(const nlohmann::ordered_json& fit);

/// A force history in kN over s, with a position in mm: `flight.csv` of the cases.
extern const char* const kFlight;

}  // namespace prs::fuzz
