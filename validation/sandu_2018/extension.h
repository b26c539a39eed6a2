#pragma once

#include "prs/validation/validate.h"

namespace prs::sandu_2018 {

/// Quantities that the JSON document does not hold; the error of the ellipticity approximations of
/// table 1.5; the statements of chapters 2 and 3 on the reference example of table 3.2.
SourceExtension extension();

}  // namespace prs::sandu_2018
