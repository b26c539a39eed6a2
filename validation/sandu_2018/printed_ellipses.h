#pragma once

#include "prs/model/case.h"
#include "prs/validation/table.h"

namespace prs::sandu_2018 {

/// Film thicknesses and largest sliding speed of figs. 2.8 and 2.9: printed, as the thesis' own
/// formulas give them, and with the signs of the curvatures kept. `reference` is the case of table
/// 3.2.
ValidationTable printed_ellipses(const Case& reference);

}  // namespace prs::sandu_2018
