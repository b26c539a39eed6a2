#pragma once

#include "prs/run/lists.h"

namespace prs {

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
