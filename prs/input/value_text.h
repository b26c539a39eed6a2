#pragma once

#include <string>

#include "prs/input/document.h"
#include "prs/input/field.h"

namespace prs::input {

/// A value as a person would write it in the input.
std::string text_of(const Value& value);

/// ` > 0 and <= 5 mm`; empty without bounds.
std::string text_of_bounds(const Bounds& bounds, const Quantity& quantity);
std::string text_of_bounds(const Bounds& bounds, const Number& number);

/// Whether what was written is several values.
bool is_several(const Node& node, const OneOr& value);

}  // namespace prs::input
