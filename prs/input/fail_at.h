#pragma once

#include <string_view>

#include "prs/input/source.h"

namespace prs::input {

/// Throws the InputError that names the place of `path` in the source, for what turns out to be
/// wrong only after the case was read.
[[noreturn]] void fail_at(const Source& source, std::string_view path, std::string_view message);

}  // namespace prs::input
