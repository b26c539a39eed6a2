#include "prs/study/file_lock.h"

#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace prs {

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

}  // namespace prs
