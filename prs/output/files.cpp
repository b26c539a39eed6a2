#include "prs/output/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

namespace prs {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(int error, const fs::path& path) {
  throw std::system_error(error, std::generic_category(),
                          fmt::format("cannot write '{}'", path.string()));
}

/// A complete file under a temporary name beside its target; gone again unless it is published.
class StagedFile {
 public:
  StagedFile(fs::path target, std::string_view content) : target_(std::move(target)) {
    const int descriptor = create();
    const int write_error = write_all(descriptor, content);
    const int close_error = ::close(descriptor) == 0 ? 0 : errno;
    if (write_error == 0 && close_error == 0) return;
    discard();
    fail(write_error != 0 ? write_error : close_error, target_);
  }
  StagedFile(StagedFile&& other) noexcept
      : target_(std::move(other.target_)), temporary_(std::exchange(other.temporary_, {})) {}
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile() { discard(); }

  void publish() {
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno, target_);
    temporary_.clear();
  }

 private:
  int create() {
    for (int attempt = 0;; ++attempt) {
      temporary_ = target_;
      temporary_ += fmt::format(".{}-{}.tmp", ::getpid(), attempt);
      const int descriptor =
          ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor >= 0) return descriptor;
      if (errno != EEXIST) fail(errno, target_);
    }
  }

  static int write_all(int descriptor, std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(descriptor, content.data(), content.size());
      if (written >= 0)
        content.remove_prefix(static_cast<std::size_t>(written));
      else if (errno != EINTR)
        return errno;
    }
    return 0;
  }

  void discard() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    temporary_.clear();
  }

  fs::path target_;
  fs::path temporary_;  ///< Empty once there is nothing to remove.
};

}  // namespace

void write_files(const fs::path& directory, const std::vector<OutputFile>& files) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) fail(error.value(), directory);

  std::vector<StagedFile> staged;
  for (const OutputFile& file : files) staged.emplace_back(directory / file.name, file.content);
  for (StagedFile& file : staged) file.publish();
}

}  // namespace prs
