#pragma once

#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace prs {

/// An open file, closed with the object.
class FileDescriptor {
 public:
  explicit FileDescriptor(int number = -1) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~FileDescriptor() { close(); }

  int get() const { return number_; }
  bool is_open() const { return number_ >= 0; }

  /// 0, or the error that the system held back until now.
  int close() {
    const int number = std::exchange(number_, -1);
    return number < 0 || ::close(number) == 0 ? 0 : errno;
  }

 private:
  int number_;
};

/// Writes all of it; 0, or why that did not work.
inline int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      return errno;
  }
  return 0;
}

inline int write_all(const FileDescriptor& file, std::string_view bytes) { return write_all(file.get(), bytes); }

inline constexpr std::string_view kFolder = "a folder";

/// Kind of an entry at `path` (relative to `folder`) that is no regular file: "a symbolic link", "a pipe", `kFolder`.
/// Empty where there is a regular file or nothing.
std::string_view obstacle_at(const char* path, int folder = AT_FDCWD);

/// A regular file that was opened, or why there is none.
struct RegularFile {
  FileDescriptor file;
  int error = 0;              ///< System's error number; 0 where the file is open.
  std::string_view obstacle;  ///< See `obstacle_at`.
};

/// Opens `path`, of `folder` where it is relative, as ::openat does, but nothing other than a
/// regular file: a symbolic link at the end of the path is not followed, a pipe not waited for.
RegularFile open_regular(const char* path, int flags, mode_t mode = 0, int folder = AT_FDCWD);

/// Throws std::system_error if `error`, of a file that could not be opened, says that the machine lacks descriptors
/// or memory.
void throw_if_scarce(int error, const std::string& path);

/// All bytes of an open file from its beginning, absent where it has more than `most` or cannot be
/// read.
std::optional<std::string> content_of(const FileDescriptor& file, std::size_t most);

}  // namespace prs
