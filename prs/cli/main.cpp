#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "prs/cli/commands.h"
#include "prs/cli/interruption.h"
#include "prs/cli/printing.h"
#include "prs/sector/influence/matrix_cache.h"
#include "prs/input/source.h"
#include "prs/output/run_files.h"
#include "prs/study/journal.h"
#include "prs/version.h"

namespace {

using prs::cli::Options;

void add_output_options(CLI::App& command, Options& options) {
  command.add_flag("--json", options.json, "Print one JSON document and nothing else");
  command.add_option("--output", options.output, "Write files into this directory")
      ->type_name("DIR");
  command.add_flag("--quiet", options.quiet, "Print errors only");
}

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
}

void add_threads_option(CLI::App& command, Options& options) {
  command
      .add_option("--threads", options.threads, "Threads to compute on; default: one a processor")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, prs::cli::kMostThreads));
}

void add_study_options(CLI::App& study, Options& options) {
  add_case_options(study, options);
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

void add_validate_options(CLI::App& command, Options& options) {
  command
      .add_option("file", options.file,
                  "Folder of the sources, default: validation; with --recipe a file of diameters, "
                  "YAML or CSV")
      ->type_name("DIR|FILE");
  CLI::Option* recipe =
      command
          .add_option("--recipe", options.recipe,
                      "Compute a source's table for other diameters: jung-as-printed (with its "
                      "slips) or jung-corrected")
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
}

/// Runs a command, tells what it found in its folders, and lists what it wrote.
int run_recorded(int (*run)(const Options&), const Options& options, const std::string& command,
                 const std::string& case_file) {
  prs::shared_matrix_cache().keep_in(prs::cache_directory());
  std::optional<prs::RunFiles> files;
  if (options.output) files.emplace(*options.output, command, case_file, options.overrides);
  const int status = run(options);
  if (files)
    for (const std::string& text : files->finish()) prs::cli::note(options, "prs: " + text);
  if (const std::string text = prs::shared_matrix_cache().refusal(); !text.empty())
    prs::cli::note(options, "prs: " + text);
  return status;
}

int run_command(int argc, char** argv) {
  CLI::App app{"prs: load distribution, stiffness and life of planetary roller screws"};
  app.set_version_flag("--version", prs::kVersion);
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 done, 1 failed, 2 the input or the command line is wrong, 3 a load case "
      "did not converge.");
  Options options;
  int (*run)(const Options&) = nullptr;

  const auto command = [&](const char* name, const char* what, int (*function)(const Options&)) {
    CLI::App* c = app.add_subcommand(name, what);
    c->callback([&run, function] { run = function; });
    return c;
  };
  add_case_options(
      *command("check", "Validate a case; print every value, default and derived", prs::cli::check),
      options);
  add_case_options(*command("contact", "Contact points, backlash, curvatures, ellipses, pictures",
                            prs::cli::contact),
                   options);
  add_case_options(*command("solve", "Load distribution, pressures, displacement and stiffness",
                            prs::cli::solve),
                   options);
  add_case_options(
      *command("slip", "Slip, friction, dissipated power, efficiency and torques", prs::cli::slip),
      options);
  add_case_options(*command("preload", "Preload: curve through zero, lost motion, opening loads",
                            prs::cli::preload),
                   options);
  add_case_options(
      *command("life", "Life under a load history or spectrum, static safety", prs::cli::life),
      options);
  CLI::App* measures = command(
      "measures", "Capacity, life, weight, stiffness, inertia and the other design measures",
      prs::cli::measures);
  add_case_options(*measures, options);
  measures->get_option("file")->required(false);  // `--explain` needs none.
  measures->add_flag("--explain", options.explain,
                     "Print formula, validity and source of every measure");
  CLI::App* study =
      command("study", "Run the study of the file: many designs, a row each", prs::cli::study);
  add_study_options(*study, options);
  CLI::App* merge = add_merge(*study, options);
  CLI::App* optimize =
      command("optimize", "Search the designs that the file aims at", prs::cli::optimize);
  add_case_options(*optimize, options);
  add_threads_option(*optimize, options);
  optimize->add_flag("--restart", options.restart,
                     "Discard what an unfinished optimization left in DIR, and start again");
  CLI::App* configurations =
      command("configurations", "List the geometries that a screw diameter and a lead allow",
              prs::cli::configurations);
  add_configurations_options(*configurations, options.configurations);
  add_output_options(*configurations, options);
  add_output_options(*command("schema", "Print the JSON Schema of the input", prs::cli::schema),
                     options);
  CLI::App* new_case = command("new", "Write a commented starting case", prs::cli::new_case);
  std::string type = "inverted";
  new_case->add_option("type", type, "standard or inverted")
      ->check(CLI::IsMember({"standard", "inverted"}));
  new_case->add_option("file", options.file, "New file; printed without one")->type_name("FILE");
  new_case->add_flag("--quiet", options.quiet, "Print errors only");
  CLI::App* validate =
      command("validate", "Compare with the published sources", prs::cli::validate);
  add_validate_options(*validate, options);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const int status = app.exit(error, out, err);
    prs::cli::print(out.str());
    prs::cli::say(err.str());
    return status == 0 ? prs::cli::kDone : prs::cli::kWrongInput;
  }
  if (validate->parsed()) {
    if (options.recipe)
      run = prs::cli::recipe;
    else if (options.file.empty())
      options.file = "validation";
  }
  if (merge->parsed()) {
    if (!options.file.empty()) {
      prs::cli::say(fmt::format(
          "prs: error: got FILE {} before `merge`; expected `prs study merge DIR..`: the journals "
          "hold the file\n",
          options.file));
      return prs::cli::kWrongInput;
    }
    run = prs::cli::merge_study;
  } else if (options.file.empty() &&
             (study->parsed() || (measures->parsed() && !options.explain))) {
    prs::cli::say("file is required\nRun with --help for more information.\n");
    return prs::cli::kWrongInput;
  }
  options.standard = type == "standard";

  return run_recorded(run, options, app.get_subcommands().front()->get_name(),
                      validate->parsed() ? "" : options.file);
}

/// One line of an error, without asking for memory.
int failed(std::string_view before, std::string_view what, int status) noexcept {
  prs::cli::say(before);
  prs::cli::say(what);
  prs::cli::say("\n");
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace prs::cli;
  if (!reserve_standard_streams()) return kFailed;
  let_writes_fail();
  try {
    const int status = run_command(argc, argv);
    close_output();
    return status;
  } catch (const prs::input::InputError& error) {
    return failed("", error.what(), kWrongInput);
  } catch (const prs::StudyFolderError& error) {
    return failed("", error.what(), kWrongInput);
  } catch (const ReaderGone&) {
    return kFailed;
  } catch (const std::bad_alloc&) {
    return failed("prs: error: ",
                  "out of memory; give the program more, or it less to do at once: a smaller case, "
                  "fewer --threads",
                  kFailed);
  } catch (const std::exception& error) {
    return failed("prs: error: ", error.what(), kFailed);
  } catch (...) {
    return failed("prs: error: ", "of an unknown kind", kFailed);
  }
}
