#pragma once

#include <optional>
#include <string>
#include <vector>

#include "prs/cli/printing.h"

namespace CLI {
class App;
}

namespace prs::cli {

/// Arguments of `prs validate`, which the program `prs-validate` reads.
struct ValidateOptions : OutputOptions {
  std::string file;                    ///< Folder of the sources, or the diameters of a recipe.
  std::optional<std::string> recipe;   ///< A source's formulas for given diameters.
  std::vector<std::string> diameters;  ///< Rows of the recipe, such as `54 mm, 27 mm, 9 mm`.
};

void add_validate_options(CLI::App& command, ValidateOptions& options);

}  // namespace prs::cli
