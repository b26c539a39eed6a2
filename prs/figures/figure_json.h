#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

#include "prs/figures/pictures.h"

namespace prs {

/// A description as documents have it under `figures`; what has its default is absent.
nlohmann::ordered_json to_json(const Figure& figure);

/// What documents have under `figures`.
nlohmann::ordered_json to_json(const Figures& figures);

/// Options as a JSON object with the names of their members. Throws NoFigure.
FigureOptions figure_options(const std::string& text);

/// JSON Schema of a description.
nlohmann::ordered_json figure_schema();

}  // namespace prs
