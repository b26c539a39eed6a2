#pragma once

#include <cstddef>
#include <optional>

#include "prs/record/figure.h"

namespace prs {

/// Puts the lines of a picture in grey behind those of the same panels of another, and widens its
/// axes to show them. The style of the grey lines, to be named in a legend; absent, and nothing
/// changed, where the two are drawn to scale or have other panels.
std::optional<std::size_t> add_behind(Figure& figure, const Figure& before);

}  // namespace prs
