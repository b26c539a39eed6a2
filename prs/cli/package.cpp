#include "prs/cli/package.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace prs::cli {
namespace {

namespace fs = std::filesystem;

/// The folder that a variable of the environment names; empty where it names none.
fs::path told(const char* variable) {
  const char* folder = std::getenv(variable);
  return folder != nullptr ? folder : "";
}

fs::path own_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

std::vector<fs::path> program_folders() {
  if (const fs::path folder = told("PRS_LIBEXEC"); !folder.empty()) return {folder};
  return {own_folder(), own_folder().parent_path() / "libexec" / "prs"};
}

std::vector<fs::path> shared_folders() {
  if (const fs::path folder = told("PRS_SHARE"); !folder.empty()) return {folder};
  const fs::path above = own_folder().parent_path();
  return {above / "share" / "prs", above.parent_path() / "share" / "prs"};
}

}  // namespace

void become(const std::string& program, int argc, char** argv) {
  std::string own_name = fmt::format("{} {}", argv[0], argv[1]);
  std::vector<char*> arguments{own_name.data()};
  arguments.insert(arguments.end(), argv + 2, argv + argc + 1);  // With the null at the end.
  std::vector<std::string> searched;
  for (const fs::path& folder : program_folders()) {
    searched.push_back(folder.string());
    const fs::path file = folder / program;
    if (!fs::exists(file)) continue;
    ::execv(file.c_str(), arguments.data());
    throw std::system_error(errno, std::generic_category(),
                            fmt::format("cannot run '{}'", file.string()));
  }
  throw std::runtime_error(fmt::format(
      "{0} is missing in {1}; install or build `{0}`, or name its folder in PRS_LIBEXEC", program,
      fmt::join(searched, " and ")));
}

fs::path data_folder(const std::string& name) {
  const std::vector<fs::path> shared = shared_folders();
  for (const fs::path& folder : shared)
    if (fs::is_directory(folder / name)) return folder / name;
  throw std::runtime_error(
      fmt::format("the folder `{}` is missing in {}; install the program with its data, or name "
                  "the folder that holds it in PRS_SHARE",
                  name, shared.front().string()));
}

}  // namespace prs::cli
