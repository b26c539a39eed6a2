#pragma once

#include <nlohmann/json_fwd.hpp>

namespace prs {

/// Documents keep the order of their keys.
using Json = nlohmann::ordered_json;

}  // namespace prs
