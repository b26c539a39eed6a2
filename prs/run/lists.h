#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

/// What there is to choose from, as `prs list` shows it.
namespace prs {

std::string lubricants_table();
nlohmann::ordered_json lubricants_json();

/// Units of the input by dimension, with their spellings.
std::string units_table();
nlohmann::ordered_json units_json();

/// Responses that a study may record, with unit and title.
std::string responses_table(const std::vector<std::string>& paths);
nlohmann::ordered_json responses_json(const std::vector<std::string>& paths);

}  // namespace prs
