#pragma once

#include <vector>

#include "prs/model/case.h"
#include "prs/model/problems.h"

namespace prs {

/// Values that contradict each other or that no mechanism can have. Each value is taken to lie in
/// its own bounds, as the reader of the input makes sure. At most one problem for each path.
std::vector<Problem> check_case(const Case& c);

}  // namespace prs
