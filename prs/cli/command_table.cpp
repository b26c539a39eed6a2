#include "prs/cli/command_table.h"

#include <cstdio>
#include <iostream>

#include "prs/cli/completion.h"
#include "prs/cli/export.h"
#include "prs/cli/help.h"
#include "prs/cli/list.h"
#include "prs/cli/new_case.h"
#include "prs/cli/program.h"
#include "prs/cli/report.h"
#include "prs/cli/size.h"
#include "prs/cli/study.h"
#include "prs/input/schema.h"
#include "prs/loads/load_analysis.h"
#include "prs/run/analyses.h"
#include "prs/run/compare_cases.h"
#include "prs/run/document_schema.h"
#include "prs/version.h"

namespace prs::cli {
namespace {

using CLI::App;

using Add = void (*)(App&, Options&);
using Run = int (*)(const Options&);

// Groups of commands, by purpose.
constexpr const char* kStart = "Start";
constexpr const char* kAnalyse = "Analyse a case";
constexpr const char* kSearch = "Compute many designs";
constexpr const char* kLook = "Look up";

CLI::Option* add_file(App& command, Options& options) {
  return add_value(command, "file", options.file, "FILE", "The case, a YAML file; `-` reads standard input");
}

void add_set(App& command, Options& options) {
  take_each(add_value(command, "--set", options.overrides, "PATH=VALUE",
                      "Replace a value of the case, e.g. mechanism.rollers=9; repeatable"))
      ->check([](const std::string& text) {
        if (text.find('=') != std::string::npos && !text.starts_with('=')) return std::string();
        return fmt::format(
            "got {}; expected PATH=VALUE, for example `--set mechanism.rollers=9` or `--set "
            "\"load_cases[0].axial_force=20 kN\"`",
            text.empty() ? "nothing" : input::shown(text));
      });
}

/// Adds the options of every command of a case.
void add_case_options(App& command, Options& options) {
  add_file(command, options)->required();
  add_set(command, options);
  add_output_options(command, options);
  add_units_option(command, options);
  add_csv_options(command, options.csv);
  add_png(command, options);
  add_flag(command, "--figures", options.figures, "Put the pictures into the document, as data");
}

void add_threads(App& command, Options& options) {
  take_whole_number(
      command.add_option("--threads", options.threads, "Threads to compute on; default: one per processor"), 1,
      kMostThreads);
}

void add_restart(App& command, Options& options, const char* help) {
  add_flag(command, "--restart", options.restart, help);
}

void add_compare_options(App& compare, Options& options) {
  add_value(compare, "other", options.other, "FILE", "A second case: its inputs and results beside those of the first");
  take_each(
      add_value(compare, "--reference", options.references, "FILE",
                "A CSV of another program or a test, in place of `references` of the case: `thread` or `force_kN`, "
                "`load_case`, and responses by their names; repeatable"));
  compare
      .add_flag_callback(
          "--influence", [&] { options.overrides.push_back("model.bodies=influence"); },
          "Include the influence model even if its matrices must be computed first; as --set "
          "model.bodies=influence")
      ->disable_flag_override();
}

/// Adds `--explain`, which needs no case. Without a name it explains every measure.
void add_explain(App& command, Options& options) {
  CLI::Option* file = command.get_option("file");
  command
      .add_option_function<std::string>(
          "--explain",
          [&options, file](const std::string& name) {
            options.explain = name;
            file->required(false);
          },
          "Print formula, validity and source of a measure or of a result by its path, in place of "
          "the numbers; of every measure without a NAME")
      ->type_name("NAME")
      ->expected(0, 1);
}

void add_study_options(App& study, Options& options) {
  study.get_option("file")->required(false);  // `merge` takes none.
  add_threads(study, options);
  study
      .add_option_function<std::string>(
          "--shard",
          [&options](const std::string& text) {
            options.shard = prs::parse_shard(text);
            if (!options.shard)
              throw CLI::ValidationError("--shard", "got " + text + "; expected i/n, from 1/n to n/n, for example 1/8");
          },
          "Compute the i-th of n parts only, into a journal in DIR for `prs study merge`")
      ->type_name("i/n");
  add_restart(study, options, "Discard what an unfinished study left in DIR, and start again");
}

void add_optimize_options(App& optimize, Options& options) {
  add_threads(optimize, options);
  add_restart(optimize, options, "Discard what an unfinished optimization left in DIR, and start again");
}

void add_configurations_options(App& command, Options& options) {
  ConfigurationOptions& o = options.configurations;
  add_value(command, "--screw-diameter", o.screw_diameter, "LENGTH", "Pitch diameter, with its unit");
  add_value(command, "--nut-diameter", o.nut_diameter, "LENGTH",
            "Instead of --screw-diameter: outer diameter of the nut; compares all starts that fit");
  add_value(command, "--lead", o.lead, "LENGTH", "Of screw and nut; > 0 right-handed")->required();
  take_one_of(command.add_option("--type", o.type, "Default: all"), {"standard", "inverted", "recirculating"});
  take_whole_number(command.add_option("--starts", o.starts,
                                       "Of screw and nut; default: 3 to 10, inverted 1 to 10, recirculating 1 to 2"),
                    1, 100);
  take_whole_number(command.add_option("--roller-starts", o.roller_starts, "Default: 1 to 3"), 1, 100);
  take_whole_number(command.add_option("--rollers", o.rollers, "That must fit; default: as many as do"), 3, 1000);
  add_value(command, "--gap", o.gap, "LENGTH", "Least between neighbouring crests; default: 0 mm");
  add_value(command, "--flank-angle", o.flank_angle, "ANGLE", "Default: 45 deg");
  add_value(command, "--roller-profile-radius", o.roller_profile_radius, "LENGTH",
            "Of the convex rollers; default: arcs about the roller's axis");
  add_value(command, "--write", o.write, "N FILE", "Write line N as a commented case into the new FILE")->expected(2);
  add_output_options(command, options);
  add_units_option(command, options);
  add_csv_options(command, options.csv);
}

void add_new(App& command, Options& options) {
  add_new_options(command, options.new_case);
  add_quiet(command, options);
}

void add_page_options(App& command, Options& options, const char* output) {
  add_file(command, options)->required();
  add_set(command, options);
  add_value(command, "-o,--output", options.report, "FILE", output);
  add_units_option(command, options);
  take_each(add_value(command, "--results", options.results, "DIR",
                      "Show the study and the optimization of the case that this folder holds; "
                      "repeatable; default: the folder of the page"));
}

void add_report_options(App& command, Options& options) {
  add_page_options(command, options, "Write the page into this file");
  add_flag(command, "--static", options.without_engine,
           "Leave the engine and the scripts out: a page for reading and printing alone");
  add_flag(command, "--summary", options.summary, "One sheet to sign: requirement, verdict, drawing, main numbers");
  add_json(command, options);
  add_quiet(command, options);
}

void add_explore_options(App& command, Options& options) {
  add_page_options(command, options, "Write the page into this file; default: one in a folder for temporary files");
  add_quiet(command, options);
}

void add_workbench_options(App& command, Options& options) {
  add_value(command, "file", options.file, "FILE", "A case or a requirement to start with");
  add_set(command, options);
  add_value(command, "-o,--output", options.report, "FILE", "Write the page into this file")->required();
  add_quiet(command, options);
}

void add_export_options(App& command, Options& options) {
  ExportOptions& o = options.export_model;
  add_file(command, options)->required();
  add_set(command, options);
  add_flag(command, "--fmu", o.fmu, "Write a co-simulation unit of FMI 2.0, CASE.fmu");
  add_flag(command, "--static", o.is_static, "Write the unit without the drive, also where the case has `response`");
  add_flag(command, "--modelica", o.modelica, "Write a Modelica package, CASE.mo");
  add_flag(command, "--mjcf", o.mjcf,
           "Write the drive for MuJoCo, CASE.mjcf.xml; a lever becomes its mass at the nut at mid-angle");
  add_flag(command, "--urdf", o.urdf, "Write the drive for ROS and other robot simulators, CASE.urdf");
  add_value(command, "--friction-load", o.friction_load, "FORCE",
            "Load whose friction robot simulators take; default: the root mean square force of the run of `response`");
  take_one_of(command.add_option("--play", o.play, "With --mjcf: play and elasticity as a joint of their own"),
              {"joint"});
  add_flag(command, "--step", o.step, "Print how the Python package writes grooved bodies for CAD");
  add_value(command, "--force", o.force, "FORCE", "Largest force of the curves; default: that of the case");
  add_value(command, "--speed", o.speed, "SPEED", "Largest speed of the torque; default: that of the case");
  add_value(command, "--load-case", o.load_case, "NAME",
            "Load case that gives position, misalignment and temperatures, with `preload` for the "
            "torque alone; default: the first");
  add_value(command, "-o,--output", o.output, "PATH",
            "The file to write, or a folder for it; default: the current folder");
  add_json(command, options);
  add_quiet(command, options);
}

void add_size_options(App& command, Options& options) {
  add_case_options(command, options);
  command.get_option("file")->description(
      "The requirement, a YAML file; `-` reads standard input. One to start from: "
      "`prs new --lesson 32 press.yaml`, every key: `prs list requirement`");
  command.get_option("--set")->description("Replace a value of the requirement, e.g. motor.gear_ratio=2; repeatable");
  add_threads(command, options);
  add_flag(command, "--all", options.all, "List every candidate");
  take_whole_number(command.add_option("--top", options.top, "Rows of the table; default: 10"), 1, 100'000);
  take_whole_number(command.add_option("--curve", options.curve,
                                       "Rank of the candidate whose force over speed is shown; "
                                       "default: 1"),
                    1, 100'000);
  add_value(command, "--write", options.write, "RANK FILE",
            "Write this candidate as a commented case into the new FILE; repeatable")
      ->expected(2, 200);
}

void add_list_options(App& command, Options& options) {
  take_one_of(command.add_option("what", options.what, list_help())->required(), list_words());
  add_value(command, "file", options.file, "FILE", "A case: lists only what it is complete for");
  add_json(command, options);
}

void add_schema_options(App& command, Options& options) {
  std::vector<std::string> schemas{"input", "results", "figures"};
  for (const OtherFile& file : other_files()) schemas.emplace_back(file.name);
  for (const std::string_view document : documented_commands()) schemas.emplace_back(document);
  take_one_of(command.add_option("what", options.what,
                                 "Of what: the input; the table of results; figures; a command's "
                                 "document of --json. Default: input"),
              schemas);
  add_output_options(command, options);
}

void add_validate(App& command, Options&) {
  static ValidateOptions unused;  // `run_validate` parses its own options.
  add_validate_options(command, unused);
}

/// A command of a case, in addition to its row in `prs::analyses()`.
struct CaseRow {
  Command command;
  const char* group = kAnalyse;
  const char* all = nullptr;  ///< Help of `--all`, if the command has more to show.
  Add add = nullptr;
  Run run = nullptr;
  const char* examples = nullptr;
};

constexpr const char* kEstimates = "Show estimates beside what is computed, too";

constexpr CaseRow kCaseRows[] = {
    {Command::check, kAnalyse, "List every value, with its default, too"},
    {Command::solve, kAnalyse, "Say which library factorized, too"},
    {Command::compare, kAnalyse, nullptr, add_compare_options, compare,
     "prs compare case.yaml\nprs compare case.yaml --reference fe.csv --output results\n"
     "prs compare before.yaml after.yaml\nprs compare case.yaml --influence --output results"},
    {Command::slip, kAnalyse, kEstimates},
    {Command::life, kAnalyse, kEstimates},
    {Command::measures, kAnalyse, kEstimates, nullptr, nullptr,
     "prs measures case.yaml\n"
     "prs measures case.yaml --all\n"
     "prs measures --explain\n"
     "prs measures --explain critical_speed_rpm"},
    {Command::study, kSearch, nullptr, add_study_options, study,
     "prs study case.yaml --output results\n"
     "prs study case.yaml --shard 1/8 --output part1"},
    {Command::fit, kSearch, nullptr, add_threads, fit,
     "prs fit case.yaml\nprs fit case.yaml --output results\nprs solve results/fitted.yaml"},
    {Command::optimize, kSearch, nullptr, add_optimize_options, optimize, "prs optimize case.yaml --output results"},
};

/// A command that needs no case.
struct OwnRow {
  const char* name;
  const char* group;
  const char* help;
  Add add;
  Run run;
  const char* examples;
};

constexpr OwnRow kOwnRows[] = {
    {"new", kStart, "Write a complete, commented case of a screw, or copy a lesson", add_new, new_case,
     "prs new standard case.yaml --screw-diameter 25mm --lead 5mm\n"
     "prs new --lesson 14 case.yaml"},
    {"configurations", kStart, "List the geometries that a screw diameter and a lead allow", add_configurations_options,
     configurations,
     "prs configurations --screw-diameter '24 mm' --lead '6 mm'\n"
     "prs configurations --screw-diameter '24 mm' --lead '6 mm' --write 1 case.yaml\n"
     "prs configurations --nut-diameter '50 mm' --lead '5 mm' --type inverted"},
    {"size", kStart, "Choose a screw and a motor for a motion, a life and a stroke", add_size_options, size,
     "prs size press.yaml\n"
     "prs size press.yaml --output out --write 1 screw.yaml"},
    {"report", kAnalyse, "Write one page for a browser or a printer: everything that the case requests",
     add_report_options, report,
     "prs report case.yaml --output report.html\n"
     "prs report case.yaml --summary --output summary.html\n"
     "prs report case.yaml --static --results results --output report.html"},
    {"explore", kAnalyse, "Write that page and open it in the browser, to try other values", add_explore_options,
     explore, "prs explore case.yaml\nprs explore case.yaml --output page.html"},
    {"workbench", kAnalyse, "Write the program itself as one page: any browser opens it, without an install",
     add_workbench_options, workbench,
     "prs workbench --output workbench.html\nprs workbench case.yaml --output workbench.html"},
    {"export", kAnalyse, "Write the screw as a model for other programs: FMI, Modelica, MuJoCo, URDF",
     add_export_options, export_model,
     "prs export case.yaml --fmu\n"
     "prs export case.yaml --fmu --modelica --output models --force '60 kN'\n"
     "prs export drive.yaml --mjcf --play joint --friction-load '6 kN'"},
    {"list", kLook, "List what there is to choose from", add_list_options, list,
     "prs list commands\nprs list commands case.yaml"},
    {"schema", kLook, "Print the JSON Schema of the input, of a command's document or of pictures", add_schema_options,
     schema, "prs schema > prs.schema.json\nprs schema results"},
    {"validate", kLook, "Compare with the published sources", add_validate, nullptr,
     "prs validate\nprs validate validation/sandu_2018 --json"},
};

App& add_command(Program& program, const std::string& name, const std::string& help, const char* group,
                 const std::string& examples, std::function<int(const Options&)> run) {
  App* command = program.app.add_subcommand(name, help);
  command->group(group);
  command->footer(examples);
  command->callback([&program, command, run = std::move(run)] {
    if (command->get_subcommands().empty()) program.run = run;  // `study merge` has its own function.
  });
  return *command;
}

void add_own(Program& program, std::string_view group) {
  for (const OwnRow& row : kOwnRows)
    if (row.group == group)
      row.add(add_command(program, row.name, row.help, row.group, row.examples, row.run), program.options);
}

void add_case_commands(Program& program) {
  for (const AnyAnalysis& row : analyses()) {
    const auto* found = std::ranges::find(kCaseRows, row.command, &CaseRow::command);
    const CaseRow more = found != std::end(kCaseRows) ? *found : CaseRow{row.command};
    const std::string word(name(row.command));
    const char* examples = more.examples != nullptr ? more.examples
                           : more.all != nullptr    ? "prs {0} case.yaml\nprs {0} case.yaml --all"
                                                    : "prs {0} case.yaml\n"
                                                      "prs {0} case.yaml --set mechanism.rollers=9 --output results\n"
                                                      "prs {0} case.yaml --json > {0}.json";
    std::function<int(const Options&)> run = [&row](const Options& o) { return run_case(row, o); };
    if (more.run != nullptr) run = more.run;
    App& command =
        add_command(program, word, std::string(row.help), more.group, fmt::format(fmt::runtime(examples), word), run);
    add_case_options(command, program.options);
    if (more.group == kAnalyse) add_explain(command, program.options);
    if (more.all != nullptr) add_flag(command, "--all", program.options.all, more.all);
    if (more.add != nullptr) more.add(command, program.options);
  }
}

void add_merge(Program& program) {
  App* merge = program.app.get_subcommand("study")->add_subcommand(
      "merge", "Write the files of a study that was computed in shards");
  merge->group("Commands");
  merge->footer("prs study merge part1 part2 --output results");
  merge->callback([&program] { program.run = merge_study; });
  add_value(*merge, "dir", program.options.folders, "DIR", "The folders of the shards")->required();
  add_threads(*merge, program.options);
  add_output_options(*merge, program.options);
  add_png(*merge, program.options);
  add_csv_options(*merge, program.options.csv);
}

void add_completion(Program& program) {
  const auto complete = [&program](const Options&) {
    print(bash_completion(describe(program.app)));
    return kDone;
  };
  App& command = add_command(program, "completion", "Print the completion script of a shell", kLook,
                             "source <(prs completion bash)", complete);
  take_one_of(command.add_option("shell", program.options.what, "Of which shell")->required(), {"bash"});
}

void add_pages(const CommandText& command, std::vector<OutputFile>& pages) {
  pages.push_back({manual_file(command), manual_page(command, kVersion)});
  for (const CommandText& c : command.commands) add_pages(c, pages);
}

void add_manual(Program& program) {
  const auto manual = [&program](const Options& options) {
    const CommandText text = describe(program.app);
    const CommandText& command = find_command(text, options.words);
    if (options.pages.empty()) {
      print(manual_page(command, kVersion));
      return kDone;
    }
    std::vector<OutputFile> pages;
    add_pages(command, pages);
    write_files(options.pages, pages);
    return kDone;
  };
  App& command = add_command(program, "manual", "Print the manual page of a command, for `man -l`", kLook,
                             "prs manual solve | man -l -\nprs manual --output share/man/man1", manual);
  add_value(command, "command", program.options.words, "COMMAND", "The program itself without one");
  add_value(command, "-o,--output", program.options.pages, "DIR",
            "Write the page and those of its commands into this folder");
}

void add_help(Program& program) {
  const auto help = [&program](const Options& options) {
    const CommandText text = describe(program.app);
    const CommandText& command = find_command(text, options.words);
    print(options.json ? json_text(help_json(command)) : help_text(command));
    return kDone;
  };
  App& command = add_command(program, "help", "Say what a command does, with its options", kLook,
                             "prs help solve\nprs help study merge", help);
  add_value(command, "command", program.options.words, "COMMAND", "All commands without one");
  add_json(command, program.options);
}

/// How to cite the program, as in CITATION.cff.
std::string citation() {
  return fmt::format(
      "@software{{prs,\n  author  = {{{{the prs authors}}}},\n  title   = {{prs: planetary roller screws, "
      "calculated}},\n  version = {{{}}},\n  year    = {{2026}}\n}}",
      kVersion);
}

}  // namespace

void add_commands(Program& program) {
  App& app = program.app;
  app.set_help_flag("-h,--help", "Print this help");
  const std::string about_citation = "With --version: print how to cite this version, as BibTeX";
  CLI::Option* cite = app.add_flag("--cite", about_citation);
  const auto version = [cite] { return cite->count() > 0 ? citation() : kVersion; };
  cite->needs(app.set_version_flag("-V,--version", version, "Print the version"));
  app.require_subcommand(1);
  add_own(program, kStart);
  add_case_commands(program);
  add_own(program, kAnalyse);
  add_merge(program);
  add_own(program, kLook);
  add_help(program);
  add_manual(program);
  add_completion(program);
}

std::string case_name(const Options& options) { return options.file == kStandardInput ? "<stdin>" : options.file; }

input::Source case_source(const Options& options) {
  if (options.file.empty()) throw UsageError("FILE is missing; expected a case, a YAML file");
  if (options.file != kStandardInput) return input::load_source(options.file, options.overrides);
  input::Source source = input::read_source(std::cin, case_name(options), options.overrides);
  if (std::ferror(stdin) != 0)
    throw input::InputError(
        fmt::format("{}:1:1: error: got a standard input that cannot be read; expected a case; "
                    "pipe a file into `prs .. -`",
                    case_name(options)));
  record_case(source.text, source.overrides);
  return source;
}

int run_case(const AnyAnalysis& row, const Options& options) {
  if (options.explain) return explain(options);
  const input::Source source = case_source(options);
  const Delivery delivery = run(row, source);
  return deliver(delivery, document_info(source, row.command), options);
}

namespace {

/// `references=[..]` of files that are named from the current folder or from the root.
std::string override_of(const Options& options) {
  const std::filesystem::path folder = std::filesystem::path(case_name(options)).parent_path();
  Json items = Json::array();
  for (const std::string& file : options.references) {
    if (std::error_code error; !std::filesystem::is_regular_file(file, error))
      fail_option("--reference", "got {}; expected a CSV file; check the path", input::shown(file));
    const bool stays = folder.empty() || std::filesystem::path(file).is_absolute();
    items.push_back({{"file", stays ? file : std::filesystem::proximate(file, folder).string()}});
  }
  return "references=" + items.dump();
}

}  // namespace

int compare(const Options& options) {
  if (!options.references.empty()) {
    if (!options.other.empty())
      fail_option("--reference", "got it with a second case; expected one case; delete one of the two");
    Options with = options;
    with.references.clear();
    with.overrides.push_back(override_of(options));
    return run_case(analysis_of(Command::compare), with);
  }
  if (options.other.empty()) return run_case(analysis_of(Command::compare), options);
  if (options.other == kStandardInput)
    throw UsageError("OTHER: got -; expected a file; standard input may be the first of the two");
  const input::Source source = case_source(options);
  Options second = options;
  second.file = options.other;
  const Delivery delivery = compare_cases(source, case_source(second));
  return deliver(delivery, document_info(source, Command::compare), options);
}

int schema(const Options& options) {
  const std::string of = options.what.empty() ? "input" : options.what;
  const auto other = std::ranges::find(other_files(), of, &OtherFile::name);
  const std::string document = json_text(other != other_files().end() ? other->schema()
                                         : of == "input"              ? input::schema()
                                         : of == "results"            ? results_schema()
                                         : of == "figures"            ? figure_schema()
                                                                      : document_schema(of));
  if (options.output)
    write_files(*options.output, {{of == "input" ? "prs.schema.json" : fmt::format("prs.{}.json", of), document}});
  if (!options.quiet || options.json) print(document);
  return kDone;
}

}  // namespace prs::cli
