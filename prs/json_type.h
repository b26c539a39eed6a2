#pragma once

#include <nlohmann/json_fwd.hpp>

namespace prs {

/// Documents keep the order of their keys.

}  // namespace prs
