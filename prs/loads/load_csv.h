#pragma once

#include <string>

#include "prs/loads/result.h"
#include "prs/record/csv_style.h"

namespace prs {

/// `load_cases.csv`: one row a load case, failed ones included. Units stand in the header, a field
/// is empty where the case does not define it. Quoted as in RFC 4180.
std::string load_cases_csv(const Result& result, const CsvStyle& style = {});

/// `load_distribution.csv`: one row a thread of every load case that has an answer.
std::string load_distribution_csv(const Result& result, const CsvStyle& style = {});

}  // namespace prs
