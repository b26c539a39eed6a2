#include "prs/cli/run_prs.h"

#include <fmt/ranges.h>

#include "prs/cli/command_line.h"
#include "prs/cli/package.h"
#include "prs/cli/program.h"
#include "prs/version.h"
#include "validation/extensions.h"

namespace {

using namespace prs::cli;

using Options = ValidateOptions;

/// Writes the document, and below the name of each source the files and figures of its code.
void write(const std::vector<prs::SourceReport>& reports, const std::string& document, const Options& options) {
  prs::write_files(*options.output, {{"validation.json", document}});
  for (const prs::SourceReport& source : reports) {
    const std::filesystem::path folder = *options.output / source.name;
    if (!source.files.empty()) prs::write_files(folder, source.files);
    prs::draw_figures(source.figures, folder, options.png);
  }
}

int wrong_input(const std::string& message) {
  say(message);
  return kWrongInput;
}

int validate(const Options& options) {
  if (!std::filesystem::is_directory(options.folder))
    return wrong_input(
        fmt::format("prs: error: {}: no such folder; give the folder of the sources as DIR\n", options.folder));
  ProgressLine line(options.quiet);
  const auto progress = [&](const std::string& source, std::size_t done, std::size_t all) {
    line.tell(fmt::format("{} of {} sources done; {}", done, all, source));
  };
  const std::vector<prs::SourceReport> reports = prs::validate(options.folder, prs::extensions(), progress);
  line.clear();
  if (reports.empty())
    return wrong_input(fmt::format(
        "prs: error: {}: no folder with a reference.yaml; give the folder of the sources as DIR\n", options.folder));
  const std::string document =
      prs::json_text(prs::validation_json(reports, {prs::kVersion, prs::kSchemaVersion, "", {}, "validate"}));
  if (options.output) write(reports, document, options);
  if (options.json) {
    print(document);
  } else if (!options.quiet) {
    print(prs::validation_text(reports));
    if (options.output) print(fmt::format("Files: {}\n", options.output->string()));
  }
  return prs::summary(reports).changed > 0 ? kFailed : exit_status(true);
}

int run_command(int argc, char** argv) {
  CLI::App app{"Compare with the published sources", "prs validate"};
  app.set_help_flag("-h,--help", "Print this help");
  Options options;
  add_validate_options(app, options);
  if (const std::optional<int> status = parse(app, argc, argv)) return *status;

  if (options.folder.empty()) options.folder = data_folder("validation").string();
  return run_recorded([&] { return validate(options); }, options, "validate", "", {});
}

}  // namespace

int prs::cli::run_validate(int argc, char** argv) { return run_program(run_command, argc, argv); }
