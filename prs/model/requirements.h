#pragma once

#include <vector>

#include "prs/model/case.h"
#include "prs/model/command.h"
#include "prs/model/problems.h"

namespace prs {

/// What a command needs and the case lacks: each with the block to add and an example of it. A
/// study or an optimization needs what the command of its designs does.
std::vector<Problem> missing(const Case& c, Command command);

}  // namespace prs
