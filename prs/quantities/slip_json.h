#pragma once

#include <nlohmann/json_fwd.hpp>

#include "prs/loads/slip_result.h"

namespace prs {

/// `load_cases[].slip`. One that did not converge has no more than how its search ended.
nlohmann::ordered_json slip_json(const SlipResult& slip);

}  // namespace prs
