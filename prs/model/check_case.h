#pragma once

#include "prs/model/case.h"
#include "prs/model/command.h"
#include "prs/model/problems.h"

namespace prs {

/// Values that contradict each other or that no mechanism can have. Each value is taken to lie in
/// its own bounds, as the reader of the input makes sure. At most one problem for each path.
std::vector<Problem> check_case(const Case& c);

/// What a command needs and the case lacks: each with the block to add and an example of it. A
/// study or an optimization needs what the command of its designs does.
std::vector<Problem> missing(const Case& c, Command command);

}  // namespace prs
