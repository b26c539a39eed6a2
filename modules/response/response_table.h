#pragma once

#include "modules/response/response_analysis.h"

namespace prs {

/// Summary of the results as a table.
std::string response_table(const ResponseResult& result);

}  // namespace prs
