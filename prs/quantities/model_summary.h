#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "prs/loads/result.h"

namespace prs {

/// Which model of the bodies the loads were solved with, and what it is known to be off by.
nlohmann::ordered_json model_json(const Result& result);

/// The same as a line for the terminal; empty where nothing was solved.
std::string model_line(const Result& result);

}  // namespace prs
