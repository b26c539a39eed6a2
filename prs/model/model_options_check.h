#pragma once

#include "prs/model/check_case.h"

namespace prs {

/// Checks of inputs that only some models of the bodies take.
void check_bodies(const Case& c, Problems& problems);

/// Refuses a stated thread thickness for `refined` and `influence`, whose teeth are half a pitch thick.
void check_thickness(const Case& c, Problems& problems);

/// Checks of inputs that only a full mechanism takes, and of those that it does not take yet.
void check_full_mechanism(const Case& c, Problems& problems);

}  // namespace prs
