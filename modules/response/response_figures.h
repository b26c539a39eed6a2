#pragma once

#include "modules/response/response_analysis.h"

namespace prs {

Pictures response_pictures(const ResponseResult& result);

}  // namespace prs
