#include "prs/output/file_lock.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <charconv>
#include <chrono>
#include <fstream>
#include <iterator>
#include <regex>
#include <system_error>
#include <thread>

#include "prs/regular_file.h"
#include "prs/text.h"

namespace prs {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestHolder = 1000;

/// A process that has ended and that nobody has waited for does not live.
bool is_alive(pid_t process) {
  if (::kill(process, 0) != 0) return errno == EPERM;
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t name_end = text.rfind(')');
  return name_end == text.npos || !text.substr(name_end).starts_with(") Z");
}

/// What the holder of a lock wrote into its file; nothing where it has not come that far.
struct Holder {
  pid_t process = 0;
  FolderLock::Run run;

  explicit Holder(const FileDescriptor& file) {
    const std::string text = content_of(file, kLongestHolder).value_or("");
    const std::size_t first = text.find('\n'), second = text.find('\n', first + 1);
    if (second == text.npos) return;
    std::from_chars(text.data(), text.data() + first, process);
    if (process <= 0 || !is_alive(process)) return;
    run = {printable(text.substr(first + 1, second - first - 1)),
           text.substr(second + 1, text.find('\n', second + 1) - second - 1)};
  }
};

std::string text_of(const FolderLock::Run& run) {
  return fmt::format("{}\n{}\n{}\n", ::getpid(), run.command, run.case_digest);
}

/// Whether the open file is still the one of that name.
bool is_in_place(const FileDescriptor& file, const fs::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(file.get(), &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

[[noreturn]] void refuse_held(const fs::path& folder, const Holder& holder) {
  std::string who;
  if (!holder.run.command.empty())
    who = fmt::format(" ({}, number {})", holder.run.command, holder.process);
  throw StudyFolderError(
      fmt::format("{}: error: another process{} writes into this folder; expected a folder for "
                  "this run alone; wait for it, or give another folder with --output",
                  folder.string(), who));
}

/// The file of the lock, which the process has from now on.
FileDescriptor locked(const fs::path& path, int kind, const FolderLock::Run& run) {
  for (;;) {
    FileDescriptor file = open_study_file(path, O_RDWR | O_CREAT);
    struct OfAnotherCase {};
    const auto wait = [&] {
      const std::string other = Holder(file).run.case_digest;
      if (!run.case_digest.empty() && !other.empty() && run.case_digest != other)
        throw OfAnotherCase{};
      wait_for_lock();
    };
    bool is_ours = false;
    try {
      is_ours = lock_file(file, kind, path, wait);
    } catch (const OfAnotherCase&) {  // It would remove what the other one has just written.
    }
    if (!is_ours) refuse_held(path.parent_path(), Holder(file));
    if (!is_in_place(file, path)) continue;
    // Who shares the folder names one of those who do. Where it cannot be written, nobody is named.
    if (::ftruncate(file.get(), 0) == 0) write_all(file, text_of(run));
    return file;
  }
}

/// Removes files that processes wrote under temporary names when they died.
void remove_unfinished(const fs::path& folder) {
  // Those of a study and of pictures are made under the lock alone.
  static const std::regex kOwn(R"((study(_figures)?\..*|.*\.(svg|png))\.\d+-\d+\.tmp)");
  static const std::regex kAny(R"(.+\.(\d{1,9})-\d+\.tmp)");
  for (const fs::path& directory : {folder, folder / "plots"}) {
    std::error_code error;
    std::vector<fs::path> left;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory, error)) {
      const std::string name = entry.path().filename().string();
      std::smatch match;
      if (std::regex_match(name, kOwn) ||
          (std::regex_match(name, match, kAny) &&
           fs::is_regular_file(entry.symlink_status(error)) && !is_alive(std::stoi(match[1]))))
        left.push_back(entry.path());
    }
    for (const fs::path& path : left) fs::remove_all(path, error);
  }
}

}  // namespace

void wait_for_lock() { std::this_thread::sleep_for(std::chrono::milliseconds(20)); }

bool lock_file(const FileDescriptor& file, int operation, const std::filesystem::path& path,
               const std::function<void()>& wait) {
  for (int tries = 1; ::flock(file.get(), operation | LOCK_NB) != 0;) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK)
      throw std::runtime_error(
          fmt::format("cannot lock '{}': {}; give a folder on another file system with --output",
                      path.string(), std::generic_category().message(errno)));
    if (tries++ == kMostLockTries) return false;
    wait();
  }
  return true;
}

FolderLock::FolderLock(const fs::path& folder, int kind, const Run& run)
    : path_(folder / kFolderLock) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::system_error(error, fmt::format("cannot write '{}'", folder.string()));
  file_ = locked(path_, kind, run);
  if (kind == LOCK_EX) remove_unfinished(folder);
}

FolderLock::~FolderLock() {
  // The last one clears up; who opened the file meanwhile finds it out of place.
  if (file_.is_open() && ::flock(file_.get(), LOCK_EX | LOCK_NB) == 0) ::unlink(path_.c_str());
}

FileDescriptor open_study_file(const fs::path& path, int flags) {
  RegularFile opened = open_regular(path.c_str(), flags, 0666);
  if (!opened.obstacle.empty())
    throw StudyFolderError(fmt::format(
        "{}: error: got {}; expected the file itself; remove it, or put the file in its place",
        path.string(), opened.obstacle));
  if (!opened.file.is_open())
    throw std::system_error(
        opened.error, std::generic_category(),
        fmt::format("cannot {} '{}'", (flags & O_ACCMODE) == O_RDONLY ? "read" : "write",
                    path.string()));
  return std::move(opened.file);
}

}  // namespace prs
