#pragma once

#include <string>

#include "prs/figures/figure.h"

namespace prs {

/// A figure as an SVG element for an HTML page with `svg_style()`. `id` is unique on the page. A
/// map shows each node as a rectangle; a surface is seen from above.
std::string svg(const Figure& figure, const std::string& id);

/// The rules that its classes follow, by the variables of the page's theme: `--ink`, `--quiet`,
/// `--line` and `--paper`.
std::string svg_style();

/// A text as HTML shows it: `printable`, with markup escaped.
std::string html(std::string_view text);

}  // namespace prs
