#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "prs/output/unfinished.h"

namespace prs {

/// A gnuplot process at work on one script. No shell is involved and no start-up file is read.
class GnuplotProcess {
 public:
  /// Starts `gnuplot SCRIPT` in the directory. Throws std::system_error where that does not work,
  /// ENOENT where there is no gnuplot.
  GnuplotProcess(const std::filesystem::path& directory, const std::string& script);
  GnuplotProcess(GnuplotProcess&& other) noexcept;
  GnuplotProcess& operator=(GnuplotProcess&&) = delete;
  ~GnuplotProcess();

  /// Waits for the end; returns what gnuplot complained of, empty if it says that it succeeded. A
  /// full disk is no failure to gnuplot: look at what it drew.
  std::string wait();

 private:
  std::string read_messages();
  int status() noexcept;  ///< Waits for the end of the process.

  pid_t child_ = -1;   ///< -1 once it has been waited for.
  int messages_ = -1;  ///< Its standard error.
  UnfinishedProcess unfinished_;
};

}  // namespace prs
