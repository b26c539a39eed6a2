#pragma once

#include "modules/response/response.h"
#include "prs/record/analysis.h"

namespace prs {

/// `response.csv`: one row per sample, one column per series.
std::string response_csv(const ResponseResult& result, const CsvStyle& style = {});

const Analysis<ResponseResult>& response_analysis();

}  // namespace prs
