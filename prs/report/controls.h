#pragma once

#include "prs/report/findings.h"

namespace prs {

/// Sliders and fields for the important inputs of the case; empty if a page could move none.
std::string controls_html(const Findings& all);

/// Load cases whose threads can be shown, and the most loaded thread; null if there are none.
Json thread_choices(const Findings& all);

}  // namespace prs
