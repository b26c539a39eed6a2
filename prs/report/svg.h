#pragma once

#include "prs/record/figure.h"
#include "prs/svg/elements.h"

namespace prs {

/// A figure as an SVG element for an HTML page with `svg_style()`. `id` is unique on the page.
std::string svg(const Figure& figure, const std::string& id);

/// The rules that its classes follow, by the variables of the page's theme (`svg_rules`).
std::string svg_style();

}  // namespace prs
