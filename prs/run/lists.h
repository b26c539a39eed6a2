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
/// Units of results that tables in US units replace: `text`, `us_text`, and `factor` from one to the other.
Json us_units_json();

/// Responses that a study may record, with unit and title.
std::string responses_table(const std::vector<std::string>& paths);
Json responses_json(const std::vector<std::string>& paths);

/// Every path that a study may record, from the table of quantities; of a series thread by thread
/// `.max` only.
std::vector<std::string> known_responses();

/// Those that the first load case and the document of a case have: for the command of its study,
/// or, without one, for every command of studies that it has all for. Throws InputError.
std::vector<std::string> responses_of(const input::Source& source);

}  // namespace prs
