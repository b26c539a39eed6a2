#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "prs/loads/load_analysis.h"
#include "prs/record/pictures.h"
#include "prs/study/study_result.h"

namespace prs::fuzz {

/// Throws if a number is not finite, or anything is null; `at`: place of the value.
void expect_finite(const nlohmann::ordered_json& value, const std::string& at);

/// Makes all figures; gaps of a map or a line are NaN in them, nothing is infinite.
void expect_drawable(const Pictures& pictures);

/// Makes every form of a study's rows.
void expect_stored_study(const StudyResult& result, const DocumentInfo& info);

/// Checks that values of a fit are within their bounds, and in their intervals.
void expect_fitted(const nlohmann::ordered_json& fit);

/// A force history in kN over s, with a position in mm: `flight.csv` of the cases.
extern const char* const kFlight;

}  // namespace prs::fuzz
