#pragma once

#include "prs/measures/measures_analysis.h"

namespace prs {

/// Keys of measures that estimate computed quantities. They are shown on request only, so that each quantity has one
/// headline.
std::vector<std::string> estimates_beside(const Computed& computed);

}  // namespace prs
