#pragma once

#include "prs/input/source.h"
#include "prs/record/delivery.h"

namespace prs {

/// Two cases side by side: the inputs in which they differ and the numbers of every command that
/// both have all for, with the change from the first to the second; curves of the second in grey
/// behind those of the first. Load cases are paired by their names or, where none is alike, by
/// their places. Throws InputError.
Delivery compare_cases(const input::Source& first, const input::Source& second);

}  // namespace prs
