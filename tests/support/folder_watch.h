#pragma once

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <system_error>

namespace test {

/// Waits for changes below folders; uses the clock only to give up on an idle process.
class FolderWatch {
 public:
  FolderWatch() : changes_(::inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
    if (changes_ < 0) throw std::system_error(errno, std::generic_category(), "inotify");
  }
  ~FolderWatch() { ::close(changes_); }
  FolderWatch(const FolderWatch&) = delete;
  FolderWatch& operator=(const FolderWatch&) = delete;

  /// Watches this folder from now on, if it exists.
  void add(const std::filesystem::path& folder) const {
    ::inotify_add_watch(changes_, folder.c_str(), IN_CREATE | IN_MODIFY | IN_MOVED_TO | IN_DELETE | IN_ONLYDIR);
  }

  /// Waits until something has changed, or until the other file is readable; false if neither happens for a minute.
  bool wait(int other = -1) const {
    std::array<pollfd, 2> files{{{changes_, POLLIN, 0}, {other, POLLIN, 0}}};
    int ready = 0;
    do ready = ::poll(files.data(), files.size(), 60'000);
    while (ready < 0 && errno == EINTR);
    std::array<char, 4096> told;
    while (::read(changes_, told.data(), told.size()) > 0) {
    }
    return ready > 0;
  }

 private:
  int changes_;
};

/// Bytes of all files directly in a folder.
inline std::uintmax_t bytes_in(const std::filesystem::path& folder) {
  std::error_code gone;  // Files appear and disappear meanwhile.
  std::uintmax_t bytes = 0;
  for (std::filesystem::directory_iterator entry(folder, gone), end; !gone && entry != end; entry.increment(gone)) {
    std::error_code none;
    if (const std::uintmax_t size = entry->file_size(none); !none) bytes += size;
  }
  return bytes;
}

/// Waits until a file has this many bytes; false if nothing happens in its folder for a minute.
inline bool wait_for_size(const std::filesystem::path& file, std::uintmax_t bytes) {
  const FolderWatch watch;
  do {
    watch.add(file.parent_path().parent_path());  // Folder in which that folder is made.
    watch.add(file.parent_path());
    std::error_code none;
    const std::uintmax_t size = std::filesystem::file_size(file, none);
    if (!none && size >= bytes) return true;
  } while (watch.wait());
  return false;
}

}  // namespace test
