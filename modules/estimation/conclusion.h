#pragma once

#include "modules/estimation/search.h"

namespace modules::fit {

/// Sets status, values and tests of a fit where a search ended; returns the equations there.
Normal conclude(const Search& search, Status status, Result& result);

/// Adds deviations and intervals, and the curves with their bands.
void add_uncertainty(Search& search, const Normal& normal, Result& result);

}  // namespace modules::fit
