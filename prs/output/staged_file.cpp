#include "prs/output/staged_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>

#include <array>
#include <atomic>
#include <system_error>

namespace prs {
namespace {

/// More at once are not in the list, and left where a signal ends the program.
std::array<std::atomic<const char*>, 512> paths;
std::atomic<bool> ending;

void remove_path(const char* path) {
  if (::unlink(path) != 0) ::rmdir(path);
}

/// Who removes paths reads them until the end.
void wait_if_ending() {
  while (ending) ::pause();
}

/// 0, or why the file cannot grow to so many bytes.
int reserve_on_disk(int file, std::uint64_t bytes) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur < bytes) return EFBIG;
  if (::fallocate(file, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(bytes)) == 0) return 0;
  if (errno == ENOSPC || errno == EDQUOT || errno == EFBIG) return errno;
  // A file system that cannot reserve says at least how much there is.
  struct statvfs free {};
  if (::fstatvfs(file, &free) != 0) return 0;
  return free.f_bavail < bytes / free.f_frsize ? ENOSPC : 0;
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
  for (const auto remove : {::unlink, ::rmdir})  // Folders when they are empty.
    for (const auto& path : paths)
      if (const char* name = path) remove(name);
}

StagedFile::StagedFile(std::filesystem::path target) : target_(std::move(target)) {
  const SignalsHeld held;
  for (int attempt = 0; !file_.is_open(); ++attempt) {
    temporary_ = target_;
    temporary_ += fmt::format(".{}-{}.tmp", ::getpid(), attempt);
    file_ =
        FileDescriptor(::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
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

void StagedFile::reserve(std::uint64_t bytes) {
  if (const int error = reserve_on_disk(file_.get(), bytes); error != 0) fail(error);
}

void StagedFile::close() {
  if (const int error = file_.close(); error != 0) fail(error);
}

void StagedFile::sync() {
  struct stat status {};
  if (::fstat(file_.get(), &status) != 0 || ::ftruncate(file_.get(), status.st_size) != 0 ||
      ::fsync(file_.get()) != 0)
    fail(errno);
}

void StagedFile::publish() {
  close();
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void StagedFile::fail(int error) const {
  throw std::system_error(error, std::generic_category(),
                          fmt::format("cannot write '{}'", target_.string()));
}

}  // namespace prs
