#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prs/cli/commands.h"
#include "prs/cli/companion.h"
#include "prs/cli/program.h"
#include "prs/output/document_schema.h"
#include "prs/version.h"

namespace {

using prs::cli::add_csv_options;
using prs::cli::add_output_options;
using prs::cli::Options;

constexpr const char* kValidate = "validate";

void add_case_options(CLI::App& command, Options& options) {
  command.add_option("file", options.file, "The case, a YAML file")->required()->type_name("FILE");
  command
      .add_option("--set", options.overrides,
                  "Replace a value of the case, e.g. mechanism.rollers=9; repeatable")
      ->type_name("PATH=VALUE")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  add_output_options(command, options);
  add_csv_options(command, options.csv);
  command.add_flag("--figures", options.figures, "Put the pictures into the document, as data")
      ->disable_flag_override();
}

void add_threads_option(CLI::App& command, Options& options) {
  command
      .add_option("--threads", options.threads, "Threads to compute on; default: one per processor")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, prs::cli::kMostThreads));
}

void add_study_options(CLI::App& study, Options& options) {
  study.get_option("file")->required(false);  // `merge` has none.
  add_threads_option(study, options);
  study
      .add_option_function<std::string>(
          "--shard",
          [&options](const std::string& text) {
            options.shard = prs::parse_shard(text);
            if (!options.shard)
              throw CLI::ValidationError(
                  "--shard", "got " + text + "; expected i/n, from 1/n to n/n, for example 1/8");
          },
          "Compute the i-th of n parts only, into a journal in DIR for `prs study merge`")
      ->type_name("i/n");
  study.add_flag("--restart", options.restart,
                 "Discard what an unfinished study left in DIR, and start again");
}

CLI::App* add_merge(CLI::App& study, Options& options) {
  CLI::App* merge =
      study.add_subcommand("merge", "Write the files of a study that was computed in shards");
  merge->add_option("folders", options.folders, "The folders of the shards")
      ->required()
      ->type_name("DIR..");
  add_threads_option(*merge, options);
  add_output_options(*merge, options);
  add_csv_options(*merge, options.csv);
  return merge;
}

void add_configurations_options(CLI::App& command, prs::cli::ConfigurationOptions& options) {
  const CLI::Range starts(1, 100);
  command.add_option("--screw-diameter", options.screw_diameter, "Pitch diameter, with its unit")
      ->type_name("LENGTH")
      ->required();
  command.add_option("--lead", options.lead, "Of screw and nut; > 0 right-handed")
      ->type_name("LENGTH")
      ->required();
  command.add_option("--type", options.type, "standard or inverted; default: both")
      ->check(CLI::IsMember({"standard", "inverted"}));
  command.add_option("--starts", options.starts, "Of screw and nut; default: 3 to 10")
      ->check(starts)
      ->type_name("N");
  command.add_option("--roller-starts", options.roller_starts, "Default: 1 to 3")
      ->check(starts)
      ->type_name("N");
  command.add_option("--rollers", options.rollers, "That must fit; default: as many as do")
      ->check(CLI::Range(3, 1000))
      ->type_name("N");
  command.add_option("--gap", options.gap, "Least between neighbouring crests; default: 0 mm")
      ->type_name("LENGTH");
  command.add_option("--flank-angle", options.flank_angle, "Default: 45 deg")->type_name("ANGLE");
  command
      .add_option("--roller-profile-radius", options.roller_profile_radius,
                  "Of the convex rollers; default: arcs about the roller's axis")
      ->type_name("LENGTH");
  command
      .add_option("--write", options.write, "Write line N as a commented case into the new FILE")
      ->type_name("N FILE")
      ->expected(2);
}

using RunCommand = std::function<int(const Options&)>;

/// Commands of a case: those of the table, with the options that some have beside.
void add_case_commands(CLI::App& app, Options& options, RunCommand& run) {
  for (const prs::CommandRow& row : prs::commands()) {
    CLI::App* command = app.add_subcommand(std::string(name(row.command)), std::string(row.help));
    add_case_options(*command, options);
    command->callback([&] { run = [&row](const Options& o) { return run_case(row, o); }; });
  }
  CLI::App* measures = app.get_subcommand("measures");
  measures->get_option("file")->required(false);  // `--explain` needs none.
  measures->add_flag("--explain", options.explain,
                     "Print formula, validity and source of every measure");
  CLI::App* study = app.get_subcommand("study");
  add_study_options(*study, options);
  study->callback([&] { run = prs::cli::study; });
  CLI::App* optimize = app.get_subcommand("optimize");
  add_threads_option(*optimize, options);
  optimize->add_flag("--restart", options.restart,
                     "Discard what an unfinished optimization left in DIR, and start again");
  optimize->callback([&] { run = prs::cli::optimize; });
}

int run_command(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == kValidate)
    prs::cli::become("prs-validate", argc, argv);

  CLI::App app{"prs: load distribution, stiffness and life of planetary roller screws"};
  app.set_version_flag("--version", prs::kVersion);
  app.require_subcommand(1);
  app.footer(prs::cli::kExitStatuses);
  Options options;
  RunCommand run;
  const auto add_command = [&](const char* name, const char* what,
                               int (*function)(const Options&)) {
    CLI::App* command = app.add_subcommand(name, what);
    command->callback([&run, function] { run = function; });
    return command;
  };

  add_case_commands(app, options, run);
  CLI::App* study = app.get_subcommand("study");
  CLI::App* merge = add_merge(*study, options);
  CLI::App* configurations =
      add_command("configurations", "List the geometries that a screw diameter and a lead allow",
                  prs::cli::configurations);
  add_configurations_options(*configurations, options.configurations);
  add_output_options(*configurations, options);
  add_csv_options(*configurations, options.csv);
  CLI::App* schema = add_command(
      "schema", "Print the JSON Schema of the input, of a command's document or of pictures",
      prs::cli::schema);
  std::vector<std::string> schemas{"input", "results", "figures"};
  for (const std::string_view command : prs::documented_commands()) schemas.emplace_back(command);
  schema
      ->add_option("of", options.schema_of,
                   "input; figures; results: the table of quantities; a command: its document of "
                   "--json; default: input")
      ->check(CLI::IsMember(schemas));
  add_output_options(*schema, options);
  CLI::App* list =
      add_command("list", "List what there is to choose from", prs::cli::list_commands);
  std::string listed;
  list->add_option("what", listed, "commands: those that take a case")
      ->required()
      ->check(CLI::IsMember({"commands"}));
  list->add_option("file", options.file, "A case: only the commands that it has all for")
      ->type_name("FILE");
  CLI::App* new_case = add_command("new", "Write a commented starting case", prs::cli::new_case);
  std::string type = "inverted";
  new_case->add_option("type", type, "standard or inverted")
      ->check(CLI::IsMember({"standard", "inverted"}));
  new_case->add_option("file", options.file, "New file; printed without one")->type_name("FILE");
  new_case->add_flag("--quiet", options.quiet, "Print errors only");
  app.add_subcommand(kValidate, "Compare with the published sources");  // A program of its own.

  if (const std::optional<int> status = prs::cli::parse(app, argc, argv)) return *status;
  if (merge->parsed()) {
    if (!options.file.empty()) {
      prs::cli::say(fmt::format(
          "prs: error: got FILE {} before `merge`; expected `prs study merge DIR..`: the journals "
          "hold the file\n",
          options.file));
      return prs::cli::kWrongInput;
    }
    run = prs::cli::merge_study;
  } else if (options.explain) {
    run = prs::cli::explain_measures;
  } else if (options.file.empty() &&
             (study->parsed() || app.get_subcommand("measures")->parsed())) {
    prs::cli::say("file is required\nRun with --help for more information.\n");
    return prs::cli::kWrongInput;
  }
  options.standard = type == "standard";

  return prs::cli::run_recorded([&] { return run(options); }, options,
                                app.get_subcommands().front()->get_name(), options.file,
                                options.overrides);
}

}  // namespace

int main(int argc, char** argv) { return prs::cli::run_program(run_command, argc, argv); }
