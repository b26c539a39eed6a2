#include "prs/file_descriptor.h"

#include <sys/stat.h>

#include <cstdint>
#include <system_error>

namespace prs {
namespace {

std::string_view kind_of(mode_t mode) {
  switch (mode & S_IFMT) {
    case S_IFLNK:
      return "a symbolic link";
    case S_IFDIR:
      return kFolder;
    case S_IFIFO:
      return "a pipe";
    case S_IFSOCK:
      return "a socket";
    default:
      return "a device";
  }
}

}  // namespace

std::string_view obstacle_at(const char* path, int folder) {
  struct stat status {};
  const bool is_other = ::fstatat(folder, path, &status, AT_SYMLINK_NOFOLLOW) == 0 && !S_ISREG(status.st_mode);
  return is_other ? kind_of(status.st_mode) : std::string_view{};
}

RegularFile open_regular(const char* path, int flags, mode_t mode, int folder) {
  RegularFile opened;
  opened.file = FileDescriptor(::openat(folder, path, flags | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, mode));
  struct stat status {};
  if (!opened.file.is_open()) {
    opened.error = errno;
    opened.obstacle = obstacle_at(path, folder);
    return opened;
  }
  if (::fstat(opened.file.get(), &status) != 0) {
    opened.error = errno;
  } else if (!S_ISREG(status.st_mode)) {
    opened.error = EINVAL;
    opened.obstacle = kind_of(status.st_mode);
  }
  if (opened.error != 0) opened.file.close();
  return opened;
}

void throw_if_scarce(int error, const std::string& path) {
  if (error == EMFILE || error == ENFILE || error == ENOMEM)
    throw std::system_error(error, std::generic_category(), "cannot open '" + path + "'");
}

std::optional<std::string> content_of(const FileDescriptor& file, std::size_t most) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0 || static_cast<std::uintmax_t>(status.st_size) > most) return std::nullopt;
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::pread(file.get(), bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace prs
