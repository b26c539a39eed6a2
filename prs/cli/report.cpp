#include "prs/report/report.h"

#include <fmt/format.h>

#include <system_error>

#include "prs/cli/commands.h"
#include "prs/cli/usage_error.h"
#include "prs/output/staged_file.h"
#include "prs/quantities/json.h"

namespace prs::cli {
namespace {

/// As a shell takes it for one word.
std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./=:,+@%[]";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string command_of(const Options& options) {
  std::string command = "prs report " + quoted(options.file);
  for (const std::string& text : options.overrides) command += " --set " + quoted(text);
  for (const std::filesystem::path& folder : options.results)
    command += " --results " + quoted(folder.string());
  if (!options.report.empty()) command += " --output " + quoted(options.report.string());
  return command;
}

}  // namespace

int report(const Options& options) {
  if (options.report.empty() && !options.json)
    throw UsageError("--output is missing; expected a file, for example --output report.html");
  if (std::error_code error; std::filesystem::is_directory(options.report, error))
    throw UsageError(
        fmt::format("--output: got {}, which is a folder; expected a file, for example {}",
                    input::shown(options.report.string()),
                    input::shown((options.report / "report.html").string())));
  const input::Source source = case_source(options);
  ReportOptions asked{command_of(options), options.results};
  if (asked.results.empty())
    asked.results = {std::filesystem::absolute(options.report).parent_path()};
  const Report report = make_report(source, asked);
  if (!options.report.empty()) {
    StagedFile file(options.report);
    file.append(report.html);
    file.publish();
  }
  for (const std::string& text : report.notes) note(options, "prs: " + text);
  if (options.json)
    print(json_text(report.data));
  else if (!options.quiet)
    print(fmt::format("{}: {:.0f} kB\n", options.report.string(),
                      static_cast<double>(report.html.size()) / 1000.0));
  return exit_status(true, report.converged);
}

}  // namespace prs::cli
