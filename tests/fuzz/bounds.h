#pragma once

#include "prs/input/source.h"

namespace prs::fuzz {

/// Whether a case takes so long under sanitizers that it is left out. Invalid files take no time.
bool asks_for_much(const input::Source& source);

}  // namespace prs::fuzz
