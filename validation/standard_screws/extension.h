#pragma once

#include "prs/validation/validate.h"

namespace prs::standard_screws {

/// 24 screws of a maker's catalogue, each completed by the rules of `complete_screw`: ratios
/// of the computed to the printed weights, inertias and capacities, and how capacities depend on
/// the lead, with two profile radii of the rollers.
SourceExtension extension();

}  // namespace prs::standard_screws
