#pragma once

#include "modules/fit/fit.h"

namespace prs {

/// Reads the fit of a source, opens its curves and checks everything. Throws InputError.
FitInput read_fit_input(const input::Source& source);

}  // namespace prs
