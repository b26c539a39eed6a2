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

  /// Closes the file; returns 0, or a delayed error of the system.
  int close() {
    const int number = std::exchange(number_, -1);
    return number < 0 || ::close(number) == 0 ? 0 : errno;
  }

 private:
  int number_;
};

/// Writes all bytes; returns 0, or the error.
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

/// Kind of an entry at `path` (relative to `folder`) that is not a regular file: "a symbolic link", "a pipe",
/// `kFolder`. Empty for a regular file or no entry.
std::string_view obstacle_at(const char* path, int folder = AT_FDCWD);

/// An opened regular file, or the reason why there is none.
struct RegularFile {
  FileDescriptor file;
  int error = 0;              ///< System's error number; 0 if the file is open.
  std::string_view obstacle;  ///< See `obstacle_at`.
};

/// Opens `path`, relative to `folder`, like ::openat, but only a regular file: a symbolic link at the end of the path
/// is not followed, a pipe not waited for.
RegularFile open_regular(const char* path, int flags, mode_t mode = 0, int folder = AT_FDCWD);

/// Throws std::system_error if `error`, from opening a file, means that the machine lacks descriptors or memory.
void throw_if_scarce(int error, const std::string& path);

/// All bytes of an open file from its beginning; absent if it has more than `most` or cannot be read.
std::optional<std::string> content_of(const FileDescriptor& file, std::size_t most);

}  // namespace prs
