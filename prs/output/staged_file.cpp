#include "prs/output/staged_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace prs {
namespace {

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
