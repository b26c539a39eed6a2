#include "prs/output/staged_file.h"

#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <fstream>
#include <iterator>
#include <regex>
#include <system_error>
#include <thread>

#include "prs/text.h"

namespace prs {
namespace {

/// Paths to remove; further ones are not in the list, and stay if a signal ends the program.
std::array<std::atomic<const char*>, 512> paths;
std::atomic<bool> ending;

void remove_path(const char* path) {
  if (::unlink(path) != 0) ::rmdir(path);
}

/// Waits if a signal handler is removing paths, which reads them until the end.
void wait_if_ending() {
  while (ending) ::pause();
}

namespace fs = std::filesystem;

constexpr std::size_t kLongestHolder = 1000;

/// Whether a process runs; one that has ended and is not yet waited for does not.
bool is_alive(pid_t process) {
  if (::kill(process, 0) != 0) return errno == EPERM;
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t name_end = text.rfind(')');
  return name_end == text.npos || !text.substr(name_end).starts_with(") Z");
}

/// Text that the holder of a lock wrote into its file; none if it has not done so yet.
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
  return ::fstat(file.get(), &opened) == 0 && ::lstat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

[[noreturn]] void refuse_held(const fs::path& folder, const Holder& holder) {
  std::string who;
  if (!holder.run.command.empty()) who = fmt::format(" ({}, number {})", holder.run.command, holder.process);
  throw StudyFolderError(
      fmt::format("{}: error: another process{} writes into this folder; expected a folder for "
                  "this run alone; wait for it, or give another folder with --output",
                  folder.string(), who));
}

/// The lock file, which the process then holds.
FileDescriptor locked(const fs::path& path, int kind, const FolderLock::Run& run) {
  for (;;) {
    FileDescriptor file = open_study_file(path, O_RDWR | O_CREAT);
    struct OfAnotherCase {};
    const auto wait = [&] {
      const std::string other = Holder(file).run.case_digest;
      if (!run.case_digest.empty() && !other.empty() && run.case_digest != other) throw OfAnotherCase{};
      wait_for_lock();
    };
    bool is_ours = false;
    try {
      is_ours = lock_file(file, kind, path, wait);
    } catch (const OfAnotherCase&) {  // The run would remove the files that the other one has just written.
    }
    if (!is_ours) refuse_held(path.parent_path(), Holder(file));
    if (!is_in_place(file, path)) continue;
    // Runs that share the folder name one of them. If writing fails, none is named.
    if (::ftruncate(file.get(), 0) == 0) write_all(file, text_of(run));
    return file;
  }
}

/// Removes files under temporary names of processes that died.
void remove_unfinished(const fs::path& folder) {
  // Temporary files of a study and of pictures are made only by the holder of the lock.
  static const std::regex kOwn(R"((study(_figures)?\..*|.*\.(svg|png))\.\d+-\d+\.tmp)");
  static const std::regex kAny(R"(.+\.(\d{1,9})-\d+\.tmp)");
  for (const fs::path& directory : {folder, folder / "plots"}) {
    std::error_code error;
    std::vector<fs::path> left;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory, error)) {
      const std::string name = entry.path().filename().string();
      std::smatch match;
      if (std::regex_match(name, kOwn) ||
          (std::regex_match(name, match, kAny) && fs::is_regular_file(entry.symlink_status(error)) &&
           !is_alive(std::stoi(match[1]))))
        left.push_back(entry.path());
    }
    for (const fs::path& path : left) fs::remove_all(path, error);
  }
}

}  // namespace

SignalsHeld::SignalsHeld() {
  sigset_t all;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before_);
}

SignalsHeld::~SignalsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

UnfinishedPath::UnfinishedPath(const std::filesystem::path& path)
    : path_(std::make_unique<std::string>(path.string())) {
  for (auto& slot : paths) {
    const char* free = nullptr;
    if (slot.compare_exchange_strong(free, path_->c_str())) break;
  }
  if (ending) remove_path(path_->c_str());
  wait_if_ending();
}

UnfinishedPath::UnfinishedPath(UnfinishedPath&& other) noexcept = default;

UnfinishedPath& UnfinishedPath::operator=(UnfinishedPath&& other) noexcept {
  std::swap(path_, other.path_);
  return *this;
}

UnfinishedPath::~UnfinishedPath() {
  if (!path_) return;
  for (auto& slot : paths) {
    const char* known = path_->c_str();
    if (slot.compare_exchange_strong(known, nullptr)) break;
  }
  wait_if_ending();
}

void remove_unfinished() noexcept {
  ending = true;
  for (const auto remove : {::unlink, ::rmdir})  // Files, then folders if they are empty.
    for (const auto& path : paths)
      if (const char* name = path) remove(name);
}

StagedFile::StagedFile(std::filesystem::path target) : target_(std::move(target)) {
  if (const std::string_view other = obstacle_at(target_.c_str()); !other.empty() && other != kFolder)
    throw std::runtime_error(
        fmt::format("cannot write '{}': got {}; expected a regular file or none; give another name, or remove it",
                    target_.string(), other));
  const SignalsHeld held;
  for (int attempt = 0; !file_.is_open(); ++attempt) {
    temporary_ = target_;
    temporary_ += fmt::format(".{}-{}.tmp", ::getpid(), attempt);
    file_ = FileDescriptor(::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file_.is_open() && errno != EEXIST) fail(errno);
  }
  unfinished_ = UnfinishedPath(temporary_);
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      unfinished_(std::move(other.unfinished_)),
      file_(std::move(other.file_)) {}

StagedFile::~StagedFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void StagedFile::append(std::string_view content) {
  if (const int error = write_all(file_, content); error != 0) fail(error);
}

void StagedFile::close() {
  if (const int error = file_.close(); error != 0) fail(error);
}

void StagedFile::sync() {
  if (::fsync(file_.get()) != 0) fail(errno);
}

void StagedFile::publish() {
  close();
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void StagedFile::fail(int error) const {
  throw std::system_error(error, std::generic_category(), fmt::format("cannot write '{}'", target_.string()));
}

void wait_for_lock() { std::this_thread::sleep_for(std::chrono::milliseconds(20)); }

bool lock_file(const FileDescriptor& file, int operation, const std::filesystem::path& path,
               const std::function<void()>& wait) {
  for (int tries = 1; ::flock(file.get(), operation | LOCK_NB) != 0;) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK)
      throw std::runtime_error(fmt::format("cannot lock '{}': {}; give a folder on another file system with --output",
                                           path.string(), std::generic_category().message(errno)));
    if (tries++ == kMostLockTries) return false;
    wait();
  }
  return true;
}

FolderLock::FolderLock(const fs::path& folder, int kind, const Run& run) : path_(folder / kFolderLock) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::system_error(error, fmt::format("cannot write '{}'", folder.string()));
  const SignalsHeld held;
  file_ = locked(path_, kind, run);
  if (kind != LOCK_EX) return;
  unfinished_ = UnfinishedPath(path_);
  remove_unfinished(folder);
}

FolderLock::~FolderLock() {
  // The last holder removes the file; others that have opened it meanwhile find it out of place.
  if (file_.is_open() && ::flock(file_.get(), LOCK_EX | LOCK_NB) == 0) ::unlink(path_.c_str());
}

FileDescriptor open_study_file(const fs::path& path, int flags) {
  RegularFile opened = open_regular(path.c_str(), flags, 0666);
  if (!opened.obstacle.empty())
    throw StudyFolderError(
        fmt::format("{}: error: got {}; expected the file itself; remove it, or put the file in its place",
                    path.string(), opened.obstacle));
  if (!opened.file.is_open())
    throw std::system_error(
        opened.error, std::generic_category(),
        fmt::format("cannot {} '{}'", (flags & O_ACCMODE) == O_RDONLY ? "read" : "write", path.string()));
  return std::move(opened.file);
}

}  // namespace prs
