#pragma once

#include "prs/input/source.h"
#include "prs/json_type.h"

/// Choices, as `prs list` shows them.
namespace prs {

std::string lubricants_table();
Json lubricants_json();

/// Units of the input by dimension, with their spellings.
std::string units_table();
Json units_json();
/// Units of results that tables in US units replace: `text`, `us_text`, and `factor` from one to the other.
Json us_units_json();

}  // namespace prs
