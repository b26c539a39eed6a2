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

/// Responses that a study may record, with unit and title.
std::string responses_table(const std::vector<std::string>& paths);
Json responses_json(const std::vector<std::string>& paths);

/// Every path that a study may record, from the table of quantities; of a series thread by thread
/// `.max` only.
std::vector<std::string> known_responses();

/// Responses of the first load case and the document of a case: for the command of its study, or, without one, for
/// every command of studies for which it has all inputs. Throws InputError.
std::vector<std::string> responses_of(const input::Source& source);

}  // namespace prs
