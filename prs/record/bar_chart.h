#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "prs/model/part.h"

namespace prs {

/// Bars of both interfaces side by side, one line per thread, under the names of the
/// interfaces. Each bar is followed by its value with `decimals` decimals and the unit; the largest
/// value has the full length.
std::string bar_chart(const PerInterface<std::vector<double>>& values, int decimals,
                      std::string_view unit);

}  // namespace prs
