#include "prs/cli/validate_options.h"

#include <CLI/CLI.hpp>

#include "prs/cli/program.h"

namespace prs::cli {

void add_validate_options(CLI::App& command, ValidateOptions& options) {
  command
      .add_option("dir", options.file,
                  "Folder of the sources, default: those that come with the program; with --recipe "
                  "a file of diameters, YAML or CSV")
      ->type_name("DIR|FILE");
  CLI::Option* recipe = command
                            .add_option("--recipe", options.recipe,
                                        "Compute a source's table for other diameters: "
                                        "jung-as-printed (with its slips) or jung-corrected")
                            ->type_name("NAME");
  command
      .add_option("--diameters", options.diameters,
                  "Nut (outer), screw and roller, e.g. \"54 mm, 27 mm, 9 mm\"; repeatable")
      ->type_name("ROW")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false)
      ->needs(recipe);
  add_output_options(command, options);
  add_png(command, options);
}

}  // namespace prs::cli
