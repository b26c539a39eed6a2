#pragma once

#include "prs/input/source.h"
#include "prs/json_type.h"

/// What there is to choose from, as `prs list` shows it.
namespace prs {

std::string lubricants_table();
Json lubricants_json();

/// Units of the input by dimension, with their spellings.
std::string units_table();
Json units_json();

}  // namespace prs
