#pragma once

#include <string>

#include "prs/preload/analyze_preload.h"

namespace prs {

/// What the preload amounts to and the curve through zero, within 110 columns. Of many loads every
/// so many are shown.
std::string preload_table(const PreloadResult& result);

}  // namespace prs
