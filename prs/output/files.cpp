#include "prs/output/files.h"

#include <fmt/ranges.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <boost/algorithm/string/split.hpp>
#include <cstdlib>
#include <mutex>
#include <system_error>

#include "prs/components/components.h"
#include "prs/sha256.h"
#include "prs/svg/panel.h"
#include "prs/text.h"

namespace prs {
namespace {

void publish(const std::filesystem::path& directory, const std::vector<OutputFile>& files) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw std::system_error(error, fmt::format("cannot write '{}'", directory.string()));

  std::vector<StagedFile> staged;
  for (const OutputFile& file : files) {
    staged.emplace_back(directory / file.name).append(file.content);
    staged.back().close();
  }
  for (StagedFile& file : staged) file.publish();
}

}  // namespace

void write_files(const std::filesystem::path& directory, const std::vector<OutputFile>& files) {
  std::vector<OutputFile> written = files;
  std::erase_if(written, [&](const OutputFile& file) {
    std::error_code ignored;
    return !file.copy_of.empty() && std::filesystem::equivalent(directory / file.name, file.copy_of, ignored);
  });
  publish(directory, written);
  for (const OutputFile& file : written) record_written(directory / file.name);
}

void write_case(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path whole = std::filesystem::absolute(file);
  publish(whole.parent_path(), {{whole.filename().string(), text}});
}

void draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& directory, bool png) {
  constexpr double kPngScale = 2.0;
  std::vector<OutputFile> files;
  for (const Figure& figure : figures) {
    std::string svg = svg_file(figure);
    if (png) files.push_back({figure.name + ".png", modules::loaded<PictureModule>().png(svg, kPngScale)});
    files.push_back({figure.name + ".svg", std::move(svg)});
  }
  if (!files.empty()) write_files(directory / "plots", files);
}

std::filesystem::path temporary_folder() {
  const char* told = std::getenv("TMPDIR");
  const std::filesystem::path folder = told != nullptr && *told != '\0' ? told : "/tmp";
  std::error_code error;
  if (std::filesystem::is_directory(folder, error) && ::access(folder.c_str(), W_OK | X_OK) == 0) return folder;
  throw std::runtime_error(
      fmt::format("TMPDIR: got {}, which is no folder that can be written into; expected one for "
                  "temporary files; set TMPDIR to one, or name a place with --output",
                  printable(folder.string())));
}

namespace {

namespace fs = std::filesystem;

/// Longest list of files that is read [bytes].
constexpr std::size_t kLongestList = std::size_t{16} << 20;
constexpr std::size_t kMostNamed = 3;

/// Files that the process wrote since its run began.
struct RunRecord {
  std::mutex mutex;
  bool active = false;
  std::vector<fs::path> files;
  std::string case_digest;
};

RunRecord& record() {
  static RunRecord only;
  return only;
}

/// Paths below the folder, and the digests of the files that the run wrote there.
using Digests = std::map<std::string, std::string>;

/// The files of one run.
struct Listed {
  std::string command;
  std::string case_digest;  ///< Empty if the command reads no case.
  Digests files;
};

std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts;
  boost::split(parts, path, [](char c) { return c == '/'; });
  return parts;
}

/// Whether a listed path names a result below the folder.
bool is_result(std::string_view path) {
  if (path == kFileList || path.ends_with(".journal") || path.ends_with(".lock") || path.find('\0') != path.npos)
    return false;
  return std::ranges::none_of(parts_of(path),
                              [](const std::string& part) { return part.empty() || part == "." || part == ".."; });
}

/// A file below an open folder: the folders on its path, and its name in the last.
struct Place {
  std::vector<FileDescriptor> folders;  ///< One for each part of the path except the last.
  std::vector<std::string> parts;

  int parent(const FileDescriptor& top) const { return folders.empty() ? top.get() : folders.back().get(); }
};

/// `open_regular` for reading. Throws std::system_error if the machine lacks descriptors or memory.
RegularFile open_to_read(const std::string& name, int folder) {
  RegularFile opened = open_regular(name.c_str(), O_RDONLY, 0, folder);
  throw_if_scarce(opened.error, name);
  return opened;
}

/// Place of a path; absent if a folder on it is missing or a symbolic link. Throws as `open_to_read` does.
std::optional<Place> place_of(const FileDescriptor& top, const std::string& path) {
  Place place{{}, parts_of(path)};
  for (std::size_t k = 0; k + 1 < place.parts.size(); ++k) {
    place.folders.emplace_back(
        ::openat(place.parent(top), place.parts[k].c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (place.folders.back().is_open()) continue;
    throw_if_scarce(errno, path);
    return std::nullopt;
  }
  return place;
}

/// SHA-256 of a regular file; empty if there is none.
std::string digest_of(const FileDescriptor& top, const Place& place) {
  const RegularFile opened = open_to_read(place.parts.back(), place.parent(top));
  return opened.file.is_open() ? sha256(opened.file).value_or("") : "";
}

enum class Removal { removed, changed, absent };

/// Removes a file that is as listed, and folders that become empty.
Removal remove_listed(const FileDescriptor& top, const std::string& path, const std::string& digest) {
  const std::optional<Place> place = place_of(top, path);
  struct stat status {};
  if (!place || ::fstatat(place->parent(top), place->parts.back().c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
    return Removal::absent;
  const std::string found = digest_of(top, *place);
  if (found.empty() || found != digest || ::unlinkat(place->parent(top), place->parts.back().c_str(), 0) != 0)
    return Removal::changed;
  for (std::size_t k = place->folders.size(); k > 0; --k) {
    const int above = k > 1 ? place->folders[k - 2].get() : top.get();
    if (::unlinkat(above, place->parts[k - 1].c_str(), AT_REMOVEDIR) != 0) break;
  }
  return Removal::removed;
}

/// Runs in the text of a list; absent if it is not a list.
std::optional<std::vector<Listed>> parsed_list(const std::string& text) try {
  const Json list = Json::parse(text);
  std::vector<Listed> runs;
  for (const Json& run : list.at("runs")) {
    Listed& listed = runs.emplace_back(Listed{run.at("command"), run.at("case"), {}});
    for (const auto& [path, digest] : run.at("files").items())
      if (is_result(path)) listed.files[path] = digest;
  }
  return runs;
} catch (const Json::exception&) {
  return std::nullopt;
}

std::string list_text(const std::vector<Listed>& runs) {
  Json json{{"about",
             "What prs wrote into this folder, with SHA-256. A later run removes those of these "
             "files that are of another case, or that its command wrote before and does not write "
             "again; what was changed since stays."},
            {"runs", Json::array()}};
  for (const Listed& run : runs)
    json["runs"].push_back({{"command", run.command}, {"case", run.case_digest}, {"files", run.files}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// Locks the list against other runs while the folder is open, if they release it soon.
bool lock(const FileDescriptor& folder, const fs::path& name) try {
  return lock_file(folder, LOCK_EX, name);
} catch (const std::runtime_error&) {  // The file system has no locks.
  return false;
}

/// Whether a command's results are kept beside those of another case.
bool takes_long(std::string_view command) { return command == "study" || command == "optimize"; }

/// Path of a file below a folder; empty if it is elsewhere.
std::string path_below(const fs::path& folder, const fs::path& file) {
  std::error_code ignored;
  const std::string path =
      fs::weakly_canonical(file, ignored).lexically_relative(fs::weakly_canonical(folder, ignored));
  return path.empty() || path == "." || path.starts_with("..") ? std::string() : path;
}

/// Lines of a YAML text that are more than a comment, without comments at their ends.
std::string without_comments(std::string_view text) {
  std::string kept;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    if (const std::size_t first = line.find_first_not_of(" \t"); first != line.npos && line[first] == '#') line = {};
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    if (!line.empty()) kept.append(line).append("\n");
    begin = end + 1;
  }
  return kept;
}

std::string digest_of_case(std::string_view text, const std::vector<std::string>& overrides) {
  std::string all = without_comments(text);
  for (const std::string& given : overrides) all.append("--set ").append(given).append("\n");
  return sha256(all);
}

std::string digest_of_case_file(const fs::path& file, const std::vector<std::string>& overrides) {
  if (file.empty()) return {};
  try {
    return digest_of_case(input::load_source(file.string(), {}).text, overrides);
  } catch (const input::InputError&) {
    return {};  // The command reports it.
  }
}

std::string files_text(std::size_t count) { return count == 1 ? "1 file" : fmt::format("{} files", count); }

/// Files that the process wrote since the record began; stops recording.
Listed files_of_record(const FileDescriptor& folder, const fs::path& name, const std::string& command) {
  Listed own{command, {}, {}};
  std::vector<fs::path> written;
  {
    RunRecord& r = record();
    const std::lock_guard guard(r.mutex);
    r.active = false;
    own.case_digest = r.case_digest;
    written.swap(r.files);
  }
  if (!folder.is_open()) return own;
  for (const fs::path& file : written) {
    const std::string path = path_below(name, file);
    if (path.empty() || !is_result(path)) continue;
    const std::optional<Place> place = place_of(folder, path);
    const std::string digest = place ? digest_of(folder, *place) : std::string();
    if (!digest.empty()) own.files[path] = digest;
  }
  return own;
}

/// Runs in a folder's list, an empty list if there is none; absent if it cannot be read.
std::optional<std::vector<Listed>> former_runs(const FileDescriptor& folder) {
  const RegularFile list = open_to_read(std::string(kFileList), folder.get());
  if (!list.file.is_open()) return std::vector<Listed>{};
  const std::optional<std::string> text = content_of(list.file, kLongestList);
  return text ? parsed_list(*text) : std::nullopt;
}

/// Former runs: those whose files are kept, and those whose files are out of date.
struct SortedRuns {
  std::vector<Listed> listed, stale;
  bool kept = false;  ///< Whether results of long work on another case are kept.
};

/// Sorts former runs. `own` is the ending run; if it is not complete, it makes nothing out of date, and the run that
/// wrote the case is kept.
SortedRuns sorted_runs(std::vector<Listed> former, const Listed& own, bool complete, const std::string& case_path) {
  SortedRuns sorted;
  for (Listed& run : former) {
    for (const auto& [path, digest] : own.files) run.files.erase(path);
    const bool of_other_case =
        !own.case_digest.empty() && !run.case_digest.empty() && run.case_digest != own.case_digest;
    const bool own_command = run.command == own.command;
    const bool stays = !own_command && takes_long(run.command);
    sorted.kept = sorted.kept || (of_other_case && stays && !run.files.empty());
    const bool out_of_date = own_command || (of_other_case && !stays);
    if (complete && out_of_date && !run.files.contains(case_path))
      sorted.stale.push_back(std::move(run));
    else if (!run.files.empty())
      sorted.listed.push_back(std::move(run));
  }
  return sorted;
}

/// Removes files that are as listed, and notes which were removed and which were not.
void remove_stale(const FileDescriptor& folder, const fs::path& name, const std::vector<Listed>& stale,
                  std::vector<std::string>& notes) {
  std::size_t removed = 0;
  std::vector<std::string> changed;
  for (const Listed& run : stale)
    for (const auto& [path, digest] : run.files) {
      const Removal removal = remove_listed(folder, path, digest);
      if (removal == Removal::removed) ++removed;
      if (removal == Removal::changed) changed.push_back((name / path).string());
    }
  if (removed > 0)
    notes.push_back(fmt::format("{} of earlier runs removed from {}, which this run does not write",
                                files_text(removed), name.string()));
  if (changed.empty()) return;
  const std::size_t count = changed.size();
  changed.resize(std::min(count, kMostNamed));
  notes.push_back(fmt::format("{} of earlier runs changed since and stayed; remove what you do not need: {}{}",
                              files_text(count), fmt::join(changed, ", "), count > kMostNamed ? ", .." : ""));
}

}  // namespace

void record_written(const fs::path& file) {
  RunRecord& r = record();
  const std::lock_guard guard(r.mutex);
  if (r.active) r.files.push_back(file);
}

void record_case(const std::string& text, const std::vector<std::string>& overrides) {
  RunRecord& r = record();
  const std::lock_guard guard(r.mutex);
  r.case_digest = digest_of_case(text, overrides);
}

RunFiles::RunFiles(fs::path folder, std::string command, fs::path case_file, const std::vector<std::string>& overrides)
    : folder_(std::move(folder)), command_(std::move(command)), case_file_(std::move(case_file)) {
  RunRecord& r = record();
  const std::lock_guard guard(r.mutex);
  r.active = true;
  r.files.clear();
  r.case_digest = digest_of_case_file(case_file_, overrides);
  if (takes_long(command_)) return;
  std::error_code ignored;
  for (fs::path at = fs::absolute(folder_); !fs::exists(at, ignored); at = at.parent_path())
    if (at.has_filename()) made_.push_back(at);
  const SignalsHeld held;
  lock_.emplace(folder_, LOCK_EX, FolderLock::Run{"prs " + command_, r.case_digest});
  for (const fs::path& made : made_) unfinished_.emplace_back(made);
}

RunFiles::~RunFiles() {
  try {
    if (!finished_) update(false);
  } catch (const std::exception&) {
    // The error that ended the run is reported; unlisted files stay.
  }
  lock_.reset();
  for (const fs::path& folder : made_)
    if (::rmdir(folder.c_str()) != 0) break;  // Not empty: it holds results.
}

std::vector<std::string> RunFiles::finish() {
  finished_ = true;
  return update(true);
}

std::vector<std::string> RunFiles::update(bool complete) {
  const FileDescriptor folder(::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.is_open()) throw_if_scarce(errno, folder_.string());
  Listed own = files_of_record(folder, folder_, command_);
  if (own.files.empty()) return {};
  const std::string list = (folder_ / kFileList).string();
  if (!lock(folder, folder_))
    return {
        fmt::format("{}: another run holds the list of files, or the file system has no locks: "
                    "nothing was removed or listed, files of earlier runs stay",
                    list)};
  std::vector<std::string> notes;
  std::optional<std::vector<Listed>> former = former_runs(folder);
  if (!former)
    notes.push_back(
        fmt::format("{}: no list of what prs wrote, or damaged; files of earlier runs "
                    "stay, remove those that you do not need",
                    list));

  SortedRuns sorted = sorted_runs(std::move(former).value_or(std::vector<Listed>{}), own, complete,
                                  case_file_.empty() ? std::string() : path_below(folder_, case_file_));
  sorted.listed.push_back(std::move(own));
  StagedFile file(folder_ / kFileList);
  file.append(list_text(sorted.listed));
  file.publish();

  if (sorted.kept)
    notes.push_back(
        fmt::format("{} holds results of a study or an optimization of another case, "
                    "which stay; remove them, or take another folder",
                    folder_.string()));
  remove_stale(folder, folder_, sorted.stale, notes);
  return notes;
}

std::vector<OutputFile> files_of_run(const fs::path& folder, std::string_view command, const input::Source& source) {
  std::vector<OutputFile> files;
  const FileDescriptor top(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!top.is_open()) {
    throw_if_scarce(errno, folder.string());
    return files;
  }
  const auto content = [&](const std::string& path) -> std::optional<std::string> {
    const std::optional<Place> place = place_of(top, path);
    if (!place) return std::nullopt;
    const RegularFile opened = open_to_read(place->parts.back(), place->parent(top));
    return opened.file.is_open() ? content_of(opened.file, kLongestList) : std::nullopt;
  };
  const std::optional<std::string> list = content(std::string(kFileList));
  const auto runs = list ? parsed_list(*list) : std::nullopt;
  if (!runs) return files;
  const std::string digest = digest_of_case(source.text, source.overrides);
  for (const Listed& run : *runs) {
    if (run.command != command || run.case_digest != digest) continue;
    files.clear();
    for (const auto& [path, listed] : run.files)
      if (std::optional<std::string> text = content(path); text && sha256(*text) == listed)
        files.push_back({path, *std::move(text)});
  }
  return files;
}

}  // namespace prs
