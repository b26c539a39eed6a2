#include "validation/extensions.h"

#include <fmt/ranges.h>

#include "validation/jung_2017/tables.h"

namespace prs {

std::vector<SourceExtension> extensions() {
  return {abevi_2015::extension(), jung_2017::extension(),       reference_fe::extension(),
          sandu_2018::extension(), standard_screws::extension(), yao_2023::extension()};
}

/// A source's formulas for diameters of the user.
int run_recipe(const cli::ValidateOptions& options) {
  using namespace prs::jung_2017;
  using namespace prs::cli;
  const Recipe* recipe = find_recipe(*options.recipe);
  if (recipe == nullptr) {
    std::vector<std::string_view> names;
    for (const Recipe& known : recipes()) names.push_back(known.name);
    say(fmt::format("prs: error: --recipe: got {}; expected one of {}\n", input::shown(*options.recipe),
                    fmt::join(names, ", ")));
    return kWrongInput;
  }
  const std::vector<Diameters> rows = read_diameters(options.file, options.diameters);
  return deliver({.file = "recipe.json",
                  .document = [&](const DocumentInfo& i) { return recipe_json(*recipe, rows, i); },
                  .table = [&] { return recipe_text(*recipe, rows); },
                  .files =
                      [&](const CsvStyle& style) {
                        return std::vector<OutputFile>{{"recipe.csv", recipe_csv(*recipe, rows, style)}};
                      }},
                 validation_info(), options);
}

}  // namespace prs
