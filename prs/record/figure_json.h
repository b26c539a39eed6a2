#pragma once

#include "prs/json_type.h"
#include "prs/record/pictures.h"

namespace prs {

/// A description as documents have it under `figures`; what has its default is absent.
Json to_json(const Figure& figure);

/// What documents have under `figures`.
Json to_json(const Figures& figures);

/// Descriptions in a file, of which `figures_of` makes the figures again; none where the text is no
/// such file. Numbers have seven digits.
inline constexpr std::string_view kFiguresEnding = "_figures.json";
std::string figures_text(const Figures& figures);
Figures figures_of(std::string_view text);

/// Options as a JSON object with the names of their members. Throws NoFigure.
FigureOptions figure_options(const std::string& text);

/// JSON Schema of a description.
Json figure_schema();

}  // namespace prs
