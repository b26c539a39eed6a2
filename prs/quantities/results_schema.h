#pragma once

#include <nlohmann/json_fwd.hpp>

namespace prs {

/// The table of results as a document: `documents`, where each record stands, and `records`, what
/// each quantity is.
nlohmann::ordered_json results_schema();

}  // namespace prs
