#pragma once

#include "prs/validation/validate.h"

namespace prs::jung_2017 {

/// Table 7.1 by the recipe as printed, table A1 by elliptic integrals, table 8.1 and the design
/// points of tables 8.2 to 8.5; also both cases by the right formulas, what a thread's
/// compliance consists of, and the fits (7.8) to (7.13).
SourceExtension extension();

}  // namespace prs::jung_2017
