#include "prs/cli/validate_options.h"

#include <CLI/CLI.hpp>

#include "prs/cli/program.h"

namespace prs::cli {

void add_validate_options(CLI::App& command, ValidateOptions& options) {
  add_value(command, "dir", options.file, "DIR|FILE",
            "Folder of the sources, default: those that come with the program; with --recipe "
            "a file of diameters, YAML or CSV");
  CLI::Option* recipe = add_value(command, "--recipe", options.recipe, "NAME",
                                  "Compute a source's table for other diameters: "
                                  "jung-as-printed (with its slips) or jung-corrected");
  take_each(add_value(command, "--diameters", options.diameters, "ROW",
                      "Nut (outer), screw and roller, e.g. \"54 mm, 27 mm, 9 mm\"; repeatable"))
      ->needs(recipe);
  add_output_options(command, options);
  add_png(command, options);
}

}  // namespace prs::cli
