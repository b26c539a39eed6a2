#pragma once

#include "prs/model/check_case.h"

namespace prs {

/// Requires a viscosity, or a temperature from which it follows: the one in the file, or any with `heat`.
void check_lubricant(const Lubricant& l, const std::optional<Heat>& heat, Problems& problems);

void check_carrier(const Carrier& carrier, Problems& problems);

void check_heat(const Case& c, Problems& problems);

/// Requirements of `slip` for the law of friction and the bearings of the roller heads.
void require_friction(const Conditions& c, Problems& problems);

/// Requirements of `slip`. `may_rest`: whether a speed of 0 is allowed; slip then computes the torques that hold the
/// screw.
void require_slip(const Conditions& c, Problems& problems, bool may_rest = false);

/// Requirements of `slip` if the case states `heat`.
void require_heat(const Case& c, Problems& problems);

void require_expansion(const Case& c, Problems& problems);

}  // namespace prs
