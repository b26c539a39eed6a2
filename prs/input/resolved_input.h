#pragma once

#include <nlohmann/json_fwd.hpp>

#include "prs/input/source.h"

namespace prs::input {

/// The file of a source with its overrides and defaults in place: a case with the same results.
/// What is absent and has no default stays absent. Throws InputError.
nlohmann::ordered_json resolved_input(const Source& source);

}  // namespace prs::input
