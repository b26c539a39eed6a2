#include "prs/study/study_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>

namespace prs {

namespace fs = std::filesystem;

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

StudyFolder::StudyFolder(fs::path path, Use use, const std::string& command)
    : path_(std::move(path)),
      use_(use),
      lock_(path_, use == Use::alone ? LOCK_EX : LOCK_SH, {command}) {}

void StudyFolder::remove_journals() const {
  // The names of the files reach the disk before those of the journals are gone.
  const FileDescriptor folder(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.is_open()) ::fsync(folder.get());
  for (const fs::path& path : journal_paths(path_)) fs::remove(path);
}

}  // namespace prs
