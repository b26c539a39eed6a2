#include "prs/cli/report.h"

#include "prs/page/page.h"

#include <spawn.h>

#include <cstdlib>
#include <system_error>

#include "prs/cli/command_line.h"
#include "prs/cli/package.h"
#include "prs/loads/load_analysis.h"

namespace prs::cli {
namespace {

std::string command_of(const Options& options) {
  std::string command = "prs report " + quoted(options.file);
  for (const std::string& text : options.overrides) command += " --set " + quoted(text);
  for (const std::filesystem::path& folder : options.results) command += " --results " + quoted(folder.string());
  if (options.without_engine) command += " --static";
  if (options.summary) command += " --summary";
  if (options.units == UnitSystem::us) command += " --units us";
  if (options.report) command += " --output " + quoted(options.report->string());
  return command;
}

void require_places(const Options& options) {
  const auto is_folder = [](const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::is_directory(path, error);
  };
  if (const auto& file = options.report) {
    if (is_folder(*file))
      throw UsageError("--output: got {}, which is a folder; expected a file, for example {}",
                       input::shown(file->string()), input::shown((*file / "report.html").string()));
  }
  for (const std::filesystem::path& folder : options.results)
    if (!is_folder(folder))
      throw UsageError(
          "--results: got {}, which is no folder; expected one that `prs study FILE --output DIR` "
          "or `prs optimize` wrote",
          input::shown(folder.string()));
}

/// Notes on named folders that have no results of this case.
void note_empty_results(const Options& options, const input::Source& source) {
  for (const std::filesystem::path& folder : options.results)
    if (files_of_run(folder, "study", source).empty() && files_of_run(folder, "optimize", source).empty())
      note(options, fmt::format("prs: --results: {} has no study or optimization of this case as "
                                "it is; `prs study FILE --output DIR` writes one",
                                input::shown(folder.string())));
}

void write_html(const std::filesystem::path& path, std::string_view html) {
  std::error_code told_by_the_file;
  std::filesystem::create_directories(std::filesystem::absolute(path).parent_path(), told_by_the_file);
  StagedFile file(path);
  file.append(html);
  file.publish();
}

/// Writes the page of a case to the place given by the options.
Report write_page(const Options& options) {
  const input::Source source = case_source(options);
  PageOptions asked{command_of(options), options.results, !options.without_engine, live_parts_folder(),
                    options.summary};
  if (asked.results.empty()) asked.results = {std::filesystem::absolute(options.report.value_or("page")).parent_path()};
  const TableUnits units(options.units);
  Report report = make_report(source, asked);
  if (options.report) write_html(*options.report, report.html);
  note_empty_results(options, source);
  for (const std::string& text : report.notes) note(options, "prs: " + text);
  return report;
}

/// A new temporary folder for a page; without a page in it, it does not outlive the program.
struct PageFolder {
  std::string path = (temporary_folder() / "prs-XXXXXX").string();
  UnfinishedPath unfinished;

  PageFolder() {
    const SignalsHeld held;
    if (::mkdtemp(path.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(), fmt::format("cannot write '{}'", path));
    unfinished = UnfinishedPath(path);
  }
  ~PageFolder() { ::rmdir(path.c_str()); }
  PageFolder(const PageFolder&) = delete;
  PageFolder& operator=(const PageFolder&) = delete;
};

/// Name of a page of this case.
std::string file_of_page(const std::string& file) {
  const std::string stem = std::filesystem::path(file).stem().string();
  return (stem.empty() || stem == "-" ? "case" : stem) + ".html";
}

/// Parts of live pages. Throws std::runtime_error if there are none of this program.
LiveParts require_live_parts() {
  LiveParts parts = read_live_parts(live_parts_folder());
  if (!parts.absent.empty()) throw std::runtime_error(parts.absent);
  return parts;
}

/// Opens a file with the desktop's program for it, without waiting; false if there is none.
bool open_in_browser(const std::filesystem::path& file) {
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", O_RDWR, 0);
  std::string program = "xdg-open", argument = std::filesystem::absolute(file).string();
  char* arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, program.c_str(), &quiet, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&quiet);
  return error == 0;
}

}  // namespace

int report(const Options& options) {
  if (!options.report && !options.json)
    throw UsageError("--output is missing; expected a file, for example --output report.html");
  require_places(options);
  const Report report = write_page(options);
  if (options.json)
    print(json_text(report.data));
  else if (!options.quiet)
    print(fmt::format("{}: {:.0f} kB\n", options.report->string(), static_cast<double>(report.html.size()) / 1000.0));
  return exit_status(report.converged);
}

int workbench(const Options& options) {
  require_places(options);
  const LiveParts parts = require_live_parts();
  std::optional<input::Source> opened;
  if (!options.file.empty()) {
    opened = case_source(options);
    if (!other_file(*opened)) input::read_case_input(*opened, Command::check);
  } else if (!options.overrides.empty()) {
    fail_option("--set", "got a value and no FILE; expected the case that it changes");
  }
  std::vector<NamedText> texts;
  const auto add_companions = [&](const input::Source& source) {
    const std::filesystem::path folder = std::filesystem::path(source.name).parent_path();
    for (const std::string& name : companions(source))
      texts.push_back({name, "", input::load_source((folder / name).string(), {}).text});
  };
  for (const Lesson& lesson : lessons()) {
    const input::Source source = input::load_source(lesson.file.string(), {});
    texts.push_back({lesson.name, lesson.title, source.text});
    add_companions(source);
  }
  if (opened) add_companions(*opened);
  const std::string page = workbench_page(parts, opened, texts);
  write_html(*options.report, page);
  if (!options.quiet)
    print(fmt::format("{}: {:.0f} kB\n", options.report->string(), static_cast<double>(page.size()) / 1000.0));
  return kDone;
}

int explore(const Options& options) {
  require_places(options);
  require_live_parts();
  Options at = options;
  std::optional<PageFolder> folder;
  if (!at.report) at.report = folder.emplace().path / std::filesystem::path(file_of_page(options.file));
  const Report report = write_page(at);
  if (!options.quiet) print(at.report->string() + "\n");
  if (!open_in_browser(*at.report)) note(options, "prs: xdg-open is missing; open the page in a browser yourself");
  return exit_status(report.converged);
}

}  // namespace prs::cli
