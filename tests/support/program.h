#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/support/temporary_directory.h"

namespace test {

/// Path of `prs`. No other object than that of this function contains the name of a build folder.
const char* program();

/// Environment of a command, for a shell, that loads a library of the tests before all others. LD_PRELOAD ends a name
/// at a blank, LD_LIBRARY_PATH does not.
inline std::string preloaded(const std::filesystem::path& library) {
  return "LD_LIBRARY_PATH='" + library.parent_path().string() + "' LD_PRELOAD='" + library.filename().string() + "' ";
}

/// Exit status and output of a run of the program.
struct Outcome {
  int status = -1;
  std::string out, err;
};

/// Runs `BEFORE prs ARGUMENTS` in a directory; `prs` may be another copy of the program.
inline Outcome run_prs(const std::string& arguments, const std::filesystem::path& directory = PRS_SOURCE_DIR,
                       const std::string& before = "", const std::string& prs = program()) {
  const TemporaryDirectory folder;
  const std::filesystem::path out = folder.path() / "stdout", err = folder.path() / "stderr";
  const std::string command = "cd '" + directory.string() + "' && " + before + " '" + prs + "' " + arguments + " >'" +
                              out.string() + "' 2>'" + err.string() + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
}

}  // namespace test
