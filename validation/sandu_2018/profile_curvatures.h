#pragma once

#include "prs/validation/validate.h"

namespace prs::sandu_2018 {

/// Section 1.5.4 on example 4: ellipses of table 1.8, which fig. 1.16 shows, and the statements on profile curvatures.
Supplement profile_curvatures(const Reference& thesis);

}  // namespace prs::sandu_2018
