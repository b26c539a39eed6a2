#include "prs/output/gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "prs/text.h"

namespace prs {
namespace {

/// Of processor time, where memory is limited.
constexpr rlim_t kMostSeconds = 3;

[[noreturn]] void fail(int error) {
  throw std::system_error(error, std::generic_category(), "gnuplot");
}

/// What the child does between fork and exec: working directory and standard streams.
class SpawnActions {
 public:
  SpawnActions(const std::filesystem::path& directory, int standard_error) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, directory.c_str());
    // First: it may have the number of a stream that is closed here.
    posix_spawn_file_actions_adddup2(&actions_, standard_error, STDERR_FILENO);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// Ctrl-C reaches every process of a terminal; gnuplot's handler of it may wait for itself for ever
/// where it interrupts a drawing library. So gnuplot ends its script, and the program what it does.
class DeafToInterrupts {
 public:
  DeafToInterrupts() {
    sigset_t blocked;
    ::pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
    sigaddset(&blocked, SIGINT);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigmask(&attributes_, &blocked);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK);
  }
  DeafToInterrupts(const DeafToInterrupts&) = delete;
  DeafToInterrupts& operator=(const DeafToInterrupts&) = delete;
  ~DeafToInterrupts() { posix_spawnattr_destroy(&attributes_); }

  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

}  // namespace

GnuplotProcess::GnuplotProcess(const std::filesystem::path& directory, const std::string& script) {
  std::array<int, 2> pipe;
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) fail(errno);
  const SpawnActions actions(directory, pipe[1]);
  std::array<std::string, 3> words = {"gnuplot", "-d", script};  // -d: no start-up files.
  std::array<char*, 4> arguments = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  const DeafToInterrupts deaf;
  int error = 0;
  {
    const SignalsHeld held;
    error = posix_spawnp(&child_, words[0].c_str(), actions.get(), deaf.get(), arguments.data(),
                         environ);
    if (error == 0) unfinished_ = UnfinishedProcess(child_);
  }
  // Without memory for its fonts, gnuplot looks for them for ever.
  rlimit memory{};
  constexpr rlimit kTime{kMostSeconds, kMostSeconds + 1};
  if (error == 0 && ::getrlimit(RLIMIT_AS, &memory) == 0 && memory.rlim_cur != RLIM_INFINITY)
    ::prlimit(child_, RLIMIT_CPU, &kTime, nullptr);
  ::close(pipe[1]);
  messages_ = pipe[0];
  if (error == 0) return;
  ::close(messages_);
  fail(error);
}

GnuplotProcess::GnuplotProcess(GnuplotProcess&& other) noexcept
    : child_(std::exchange(other.child_, -1)),
      messages_(std::exchange(other.messages_, -1)),
      unfinished_(std::move(other.unfinished_)) {}

GnuplotProcess::~GnuplotProcess() {
  if (messages_ != -1) ::close(messages_);
  if (child_ != -1) status();
}

int GnuplotProcess::status() noexcept {
  int status = 0;
  const pid_t child = std::exchange(child_, -1);
  while (::waitpid(child, &status, 0) == -1 && errno == EINTR) {
  }
  unfinished_ = UnfinishedProcess();
  return status;
}

std::string GnuplotProcess::wait() {
  const std::string messages = read_messages();
  const int ended = status();
  if (WIFEXITED(ended) && WEXITSTATUS(ended) == 0) return {};
  if (!messages.empty()) return messages;
  if (WIFSIGNALED(ended) && WTERMSIG(ended) == SIGXCPU)
    return fmt::format("gnuplot took more than {} s under a limit of memory; give it more memory",
                       kMostSeconds);
  return WIFSIGNALED(ended) ? fmt::format("gnuplot was ended by signal {}", WTERMSIG(ended))
                            : fmt::format("gnuplot ended with status {}", WEXITSTATUS(ended));
}

std::string GnuplotProcess::read_messages() {
  std::string messages;
  std::array<char, 1024> buffer;
  for (;;) {
    const ssize_t count = ::read(messages_, buffer.data(), buffer.size());
    if (count > 0)
      messages.append(buffer.data(), static_cast<std::size_t>(count));
    else if (count == 0 || errno != EINTR)
      break;
  }
  ::close(std::exchange(messages_, -1));
  return printable(messages);
}

}  // namespace prs
