#pragma once

#include "prs/validation/validate.h"

namespace prs::sandu_2018 {

/// Quantities of tables 1.6, 1.7 and B.1 that the JSON document does not hold, and the error of the
/// ellipticity approximations of table 1.5.
Contribution contribution();

}  // namespace prs::sandu_2018
