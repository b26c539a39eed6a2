#pragma once

#include <nlohmann/json_fwd.hpp>

namespace prs {

/// Type of documents, which keeps the order of their keys.
using Json = nlohmann::ordered_json;

}  // namespace prs
