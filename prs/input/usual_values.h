#pragma once

#include <vector>

#include "prs/input/echo.h"
#include "prs/model/warning.h"

namespace prs::input {

/// Warnings on values that the file states and that are possible but odd, as `210 MPa` of a modulus
/// is: each names the key, the value as written, what is usual, and the unit that would fit.
std::vector<Warning> unusual_values(const std::vector<EchoEntry>& fields);

}  // namespace prs::input
