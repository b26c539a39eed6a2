#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <vector>

#include "tests/support/temporary_directory.h"

namespace test {

/// Another program and its children, without output.
class Process {
 public:
  explicit Process(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    id_ = ::fork();
    if (id_ != 0) return;
    ::setpgid(0, 0);
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (id_ > 0) kill();
    if (id_ > 0) wait();
  }

  void kill() const {
    ::kill(-id_, SIGKILL);
    ::kill(id_, SIGKILL);  // Also before it has its own group.
  }

  /// A file that is readable after the program has ended; the caller closes it.
  int end() const { return static_cast<int>(::syscall(SYS_pidfd_open, id_, 0)); }

  void signal(int number) const { ::kill(id_, number); }

  /// Exit status; below 0 the signal that killed it. `use`: its resource usage.
  int wait(rusage* use = nullptr) {
    int status = 0;
    ::wait4(id_, &status, 0, use);
    id_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  pid_t id_ = -1;
};

/// Contents of all files below a folder by their paths in it.
inline std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files[std::filesystem::relative(entry.path(), folder).string()] = content_of(entry.path());
  }
  return files;
}

}  // namespace test
