#pragma once

#include "prs/validation/validate.h"

namespace prs::yao_2023 {

/// Quantities of tables 1 and 2 that the JSON document does not hold, and how far the printed
/// contact points of the two parts lie from each other.
SourceExtension extension();

}  // namespace prs::yao_2023
