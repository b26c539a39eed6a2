#pragma once

#include "modules/response/response.h"
#include "prs/record/analysis.h"

namespace prs {

/// `response.csv`: one row per sample, one column per series.
std::string response_csv(const ResponseResult& result, const CsvStyle& style = {});

/// Summary of the results as a table.
std::string response_table(const ResponseResult& result);

Pictures response_pictures(const ResponseResult& result);

const Analysis<ResponseResult>& response_analysis();

}  // namespace prs
