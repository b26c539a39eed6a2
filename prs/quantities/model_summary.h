#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "prs/loads/result.h"

namespace prs {

/// Which model of the bodies the loads were solved with.
nlohmann::ordered_json model_json(const Result& result);

/// The same as a line for the terminal; empty for `bars`, the default, without options.
std::string model_line(const Result& result);

}  // namespace prs
