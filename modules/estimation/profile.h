#pragma once

#include "modules/estimation/search.h"

namespace modules::fit {

/// Sets the interval of the profile likelihood of an unknown, about the place where a search ended.
void set_profile(Search& search, const Normal& least, const Covariance& covariance, Index j, UnknownResult& result);

}  // namespace modules::fit
