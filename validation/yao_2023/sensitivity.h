#pragma once

#include "prs/validation/validate.h"

namespace prs::yao_2023 {

/// Section 3: 2000 Latin-hypercube samples within +-3 % of the inputs of `initial.yaml`, linear response surfaces,
/// contributions. Statements of the text on figures 8 and 9, judged with the normal load of axial equilibrium at the
/// contact point and with that of (27), and the contributions next to the printed ones.
Supplement sensitivity(const Case& initial, const Reference& paper);

}  // namespace prs::yao_2023
