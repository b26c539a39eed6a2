#include "prs/cli/run_prs.h"

#include "prs/cli/command_table.h"
#include "prs/cli/help.h"
#include "prs/cli/package.h"
#include "prs/cli/program.h"

namespace prs::cli {
namespace {

int run_command(int argc, char** argv) {
  Program program;
  add_commands(program);
  if (argc < 2) {
    // A script with an empty variable must not look successful.
    say(overview(describe(program.app)));
    return kWrongInput;
  }
  if (const std::optional<int> status = parse(program.app, argc, argv)) return *status;
  const Options& options = program.options;
  try {
    return run_recorded([&] { return program.run(options); }, options,
                        program.app.get_subcommands().front()->get_name(),
                        options.file == kStandardInput ? "" : options.file, options.overrides);
  } catch (const UsageError& error) {
    return report_usage(program.app, error.what());
  }
}

}  // namespace

int run_prs(int argc, char** argv) { return run_program(run_command, argc, argv); }

}  // namespace prs::cli
