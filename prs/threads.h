#pragma once

#include "contact/mechanism_geometry.h"
#include "prs/mechanism.h"

namespace prs {

/// The threads of a mechanism as the contact room draws them; what a design has yet to find is 0.
contact::MechanismGeometry threads_of(const Mechanism& mechanism);

/// The mechanism with all pitch diameters and the centre distance: as they stand with `geometry:
/// simulation`, designed for the backlash with `geometry: design` (Sandu 2018, table 1.3). Throws
/// CaseError where no mechanism has that backlash.
Mechanism resolved(const Mechanism& mechanism);

}  // namespace prs
