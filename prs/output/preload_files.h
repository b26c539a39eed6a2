#pragma once

#include <string>

#include "prs/preload/analyze_preload.h"

namespace prs {

/// `preload.csv`: one row per load, the curve without preload beside.
std::string preload_csv(const PreloadResult& result);

}  // namespace prs
