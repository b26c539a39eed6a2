#pragma once

#include "prs/model/mechanism.h"

namespace prs {

/// Axial pitch of each part [m]: the measured one, else lead/starts. Pitches that rounding alone
/// tells apart (`contact::kSamePitch`) come out as one number.
PerPart<double> axial_pitches(const Mechanism& mechanism);

/// The threads of a mechanism as the contact room draws them; what a design has yet to find is 0.
contact::MechanismGeometry threads_of(const Mechanism& mechanism);

/// The mechanism with all pitch diameters and the centre distance: as they stand with `geometry:
/// simulation`, designed for the backlash with `geometry: design` (Sandu 2018, table 1.3). Throws
/// CaseError where no mechanism has that backlash.
Mechanism resolved(const Mechanism& mechanism);

}  // namespace prs
