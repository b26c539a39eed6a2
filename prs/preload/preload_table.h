#pragma once

#include <string>

#include "prs/preload/analyze_preload.h"

namespace prs {

/// The preload and the curve through zero, within 100 columns. Of many loads, an evenly spaced few
/// are shown.
std::string preload_table(const PreloadResult& result);

}  // namespace prs
