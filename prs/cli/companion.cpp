#include "prs/cli/companion.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace prs::cli {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> folders() {
  const char* told = std::getenv("PRS_LIBEXEC");
  if (told != nullptr && *told != '\0') return {told};
  const fs::path own = fs::read_symlink("/proc/self/exe").parent_path();
  return {own, own.parent_path() / "libexec" / "prs"};
}

}  // namespace

void become(const std::string& program, int argc, char** argv) {
  std::string own_name = fmt::format("{} {}", argv[0], argv[1]);
  std::vector<char*> arguments{own_name.data()};
  arguments.insert(arguments.end(), argv + 2, argv + argc + 1);  // With the null at the end.
  for (const fs::path& folder : folders()) {
    const fs::path file = folder / program;
    if (!fs::exists(file)) continue;
    ::execv(file.c_str(), arguments.data());
    throw std::system_error(errno, std::generic_category(),
                            fmt::format("cannot run '{}'", file.string()));
  }
  std::string searched;
  for (const fs::path& folder : folders())
    searched += (searched.empty() ? "" : " and ") + folder.string();
  throw std::runtime_error(fmt::format(
      "{0} is missing in {1}; install or build `{0}`, or name its folder in PRS_LIBEXEC", program,
      searched));
}

}  // namespace prs::cli
