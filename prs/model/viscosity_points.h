#pragma once

#include <array>

#include "prs/model/operation.h"

namespace prs {

/// The viscosities that a named lubricant is sold with, at 40 and 100 degC.
std::array<ViscosityPoint, 2> viscosities_of(LubricantName name);

}  // namespace prs
