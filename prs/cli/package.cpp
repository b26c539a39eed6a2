#include "prs/cli/package.h"

#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "prs/cli/command_line.h"
#include "prs/input/did_you_mean.h"
#include "prs/input/document.h"

namespace prs::cli {
namespace {

namespace fs = std::filesystem;

/// Folder named by a variable of the environment; may be empty.
fs::path told(const char* variable) {
  const char* folder = std::getenv(variable);
  return folder != nullptr ? folder : "";
}

fs::path own_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

std::vector<fs::path> shared_folders() {
  if (const fs::path folder = told("PRS_SHARE"); !folder.empty()) return {folder};
  const fs::path above = own_folder().parent_path();
  return {above / "share" / "prs", above.parent_path() / "share" / "prs"};
}

/// The first existing folder; empty if there is none.
fs::path shared_folder(const std::string& name) {
  std::error_code unreadable;
  for (const fs::path& folder : shared_folders())
    if (fs::is_directory(folder / name, unreadable)) return folder / name;
  return {};
}

}  // namespace

fs::path data_folder(const std::string& name) {
  if (const fs::path folder = shared_folder(name); !folder.empty()) return folder;
  throw std::runtime_error(
      fmt::format("the folder `{}` is missing in {}; install the program with its data, or name "
                  "the folder that holds it in PRS_SHARE",
                  name, shared_folders().front().string()));
}

fs::path live_parts_folder() { return shared_folder("web"); }

namespace {

/// Title in the text: `# Lesson 14: life under a flight's loads.` -> `life under a flight's loads`
std::string title_of(const std::string& text) {
  std::string first = text.substr(0, text.find('\n'));
  if (const std::size_t colon = first.find(": "); colon != std::string::npos) first.erase(0, colon + 2);
  if (first.ends_with('.')) first.pop_back();
  return first;
}

/// Name without its number: `flight_spectrum` of `14_flight_spectrum`.
std::string_view without_number(std::string_view name) {
  return name.substr(std::min(name.find('_') + 1, name.size()));
}

}  // namespace

std::vector<Lesson> lessons() {
  std::vector<Lesson> all;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder("lessons"))) {
    const std::filesystem::path& file = entry.path();
    const std::string name = file.stem().string();
    if (file.extension() == ".yaml" && std::isdigit(static_cast<unsigned char>(name[0])) != 0)
      all.push_back({name, title_of(input::load_source(file.string(), {}).text), file});
  }
  if (all.empty())
    throw std::runtime_error(
        fmt::format("got {}, which has no lesson; expected files as 01_config_1_to_3.yaml; install "
                    "`prs` anew, or set PRS_SHARE to a folder that has them",
                    input::shown(data_folder("lessons").string())));
  std::ranges::sort(all, {}, [](const Lesson& l) { return std::pair(l.number(), l.name); });
  return all;
}

Lesson lesson(const std::string& asked) {
  const std::vector<Lesson> all = lessons();
  const bool is_number = !asked.empty() && asked.size() < 5 &&
                         std::ranges::all_of(asked, [](unsigned char c) { return std::isdigit(c) != 0; });
  const std::string name = asked.ends_with(".yaml") ? asked.substr(0, asked.size() - 5) : asked;
  for (const Lesson& l : all)
    if (is_number ? l.number() == std::stoi(asked) : l.name == name || without_number(l.name) == name) return l;
  std::vector<std::string_view> names;
  for (const Lesson& l : all) names.push_back(without_number(l.name));
  const std::string hint = input::did_you_mean(name, names);
  fail_option("--lesson", "got {}; expected a number from {} to {} or a name of `prs list lessons`{}{}",
              input::shown(asked), all.front().number(), all.back().number(), hint.empty() ? "" : "; ", hint);
}

std::vector<std::string> companions(const input::Source& source) {
  input::ErrorList errors(source);
  const input::Node root = input::read_document(source, errors);
  errors.throw_if_any();
  std::vector<std::string> names;
  for (const char* path : {"life.history.file", "motion.history.file", "candidates.catalogue.file"})
    if (const input::Node* file = input::find_path(root, path)) names.push_back(file->text);
  for (const char* path : {"fit.curves", "references", "candidates.catalogue"})
    if (const input::Node* curves = input::find_path(root, path))
      for (const input::Node& curve : curves->children)
        if (const input::Node* file = find(curve, "file"); file && !std::ranges::count(names, file->text))
          names.push_back(file->text);
  return names;
}

}  // namespace prs::cli
