#pragma once

#include "prs/loads/load_json.h"

namespace prs {

/// The command `slip`: slip and friction of load cases, at the temperatures that they come to.
const Analysis<Result>& slip_analysis();

}  // namespace prs
