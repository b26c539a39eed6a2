#include "prs/cli/data_folder.h"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace prs::cli {
namespace {

std::vector<std::filesystem::path> shared_folders() {
  const char* told = std::getenv("PRS_SHARE");
  if (told != nullptr && *told != '\0') return {told};
  const std::filesystem::path above =
      std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
  return {above / "share" / "prs", above.parent_path() / "share" / "prs"};
}

}  // namespace

std::filesystem::path data_folder(const std::string& name) {
  const std::vector<std::filesystem::path> shared = shared_folders();
  for (const std::filesystem::path& folder : shared)
    if (std::filesystem::is_directory(folder / name)) return folder / name;
  throw std::runtime_error(
      fmt::format("the folder `{}` is missing in {}; install the program with its data, or name "
                  "the folder that holds it in PRS_SHARE",
                  name, shared.front().string()));
}

}  // namespace prs::cli
