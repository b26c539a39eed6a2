#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

/// What there is to choose from, as `prs list` shows it.
namespace prs {

std::string lubricants_table();
nlohmann::ordered_json lubricants_json();

}  // namespace prs
