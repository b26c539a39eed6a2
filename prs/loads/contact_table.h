#pragma once

#include <string>

#include "prs/loads/result.h"

namespace prs {

/// What the threads say, within 100 columns: the mechanism part by part, the contact of the roller
/// with screw and nut, the loads and stresses of the cases with equal shares, and the warnings.
/// Angles are Sandu's theta [deg], lengths in mm. A row is left out where nothing defines it: Hertz
/// constants without materials, backlash where pitches differ. Beyond 24 cases a range shows its
/// first, middle and last point.
std::string contact_table(const Result& result);

}  // namespace prs
