#include "prs/study/study_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <regex>
#include <system_error>

#include "prs/study/file_lock.h"

namespace prs {
namespace {

namespace fs = std::filesystem;

/// Whether the open file is still the one of that name.
bool is_in_place(const FileDescriptor& file, const fs::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(file.get(), &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

FileDescriptor locked(const fs::path& folder, const fs::path& path, int kind) {
  for (;;) {
    FileDescriptor file = open_study_file(path, O_RDWR | O_CREAT);
    if (!lock_file(file, kind, path))
      throw StudyFolderError(fmt::format(
          "{}: error: another process runs a study in this folder; wait for it, or give "
          "another folder with --output",
          folder.string()));
    if (is_in_place(file, path)) return file;
  }
}

/// Removes the study's files under temporary names, which processes left that died writing them,
/// and folders of pictures that gnuplot was at.
void remove_unfinished(const fs::path& folder) {
  const std::regex unfinished(R"((study(_figures)?\..*|.*\.gp|pictures)\.\d+-\d+\.tmp)");
  for (const fs::path& directory : {folder, folder / "plots"}) {
    std::error_code absent;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory, absent))
      if (std::regex_match(entry.path().filename().string(), unfinished))
        fs::remove_all(entry.path());
  }
}

}  // namespace

fs::path journal_path(const fs::path& folder, Shard shard) {
  return folder / fmt::format("study.{}-of-{}.journal", shard.index + 1, shard.count);
}

std::vector<fs::path> journal_paths(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string file = entry.path().filename().string();
    if (file.starts_with("study.") && file.ends_with(".journal")) paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  return paths;
}

StudyFolder::StudyFolder(fs::path path, Use use)
    : path_(std::move(path)), lock_path_(path_ / "study.lock"), use_(use) {
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) throw std::system_error(error, fmt::format("cannot write '{}'", path_.string()));
  lock_ = locked(path_, lock_path_, use == Use::alone ? LOCK_EX : LOCK_SH);
  if (use == Use::alone) remove_unfinished(path_);
}

StudyFolder::~StudyFolder() {
  // The last one clears up; who opened the file meanwhile finds it out of place.
  if (lock_.is_open() && ::flock(lock_.get(), LOCK_EX | LOCK_NB) == 0) ::unlink(lock_path_.c_str());
}

void StudyFolder::remove_journals() const {
  // The names of the files reach the disk before those of the journals are gone.
  const FileDescriptor folder(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.is_open()) ::fsync(folder.get());
  for (const fs::path& path : journal_paths(path_)) fs::remove(path);
}

}  // namespace prs
