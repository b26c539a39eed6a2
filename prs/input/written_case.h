#pragma once

#include "prs/input/source.h"

namespace prs::input {

/// The text of a source with its overrides written into it, all else as it stands, comments too: a
/// case with the same values and without overrides. Absent where a value cannot be replaced in
/// place, as that of an anchor which others refer to. Throws InputError where the source is wrong.
std::optional<std::string> written_case(const Source& source);

}  // namespace prs::input
