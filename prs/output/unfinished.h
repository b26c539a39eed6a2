#pragma once

#include <signal.h>

#include <filesystem>
#include <memory>
#include <string>

namespace prs {

/// Holds back signals of a thread, from making a file to having it in the list below.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

/// A file or folder that must not outlive the program, while the object lives: also where a signal
/// ends it (`remove_unfinished`). Its owner removes it otherwise.
class UnfinishedPath {
 public:
  UnfinishedPath() = default;
  explicit UnfinishedPath(const std::filesystem::path& path);
  UnfinishedPath(UnfinishedPath&& other) noexcept;
  UnfinishedPath& operator=(UnfinishedPath&& other) noexcept;
  ~UnfinishedPath();

 private:
  std::unique_ptr<std::string> path_;  ///< Stays where it is.
};

/// Removes these paths, for a handler of signals that ends the program.
/// Threads that make or forget one from then on wait for the end.
void remove_unfinished() noexcept;

}  // namespace prs
