#include "prs/study/temporary_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

#include "prs/printable.h"

namespace prs {

std::filesystem::path temporary_folder() {
  const char* told = std::getenv("TMPDIR");
  const std::filesystem::path folder = told != nullptr && *told != '\0' ? told : "/tmp";
  std::error_code error;
  if (std::filesystem::is_directory(folder, error) && ::access(folder.c_str(), W_OK | X_OK) == 0)
    return folder;
  throw std::runtime_error(
      fmt::format("TMPDIR: got {}, which is no folder that can be written into; expected one for "
                  "temporary files; set TMPDIR to one, or name a place with --output",
                  printable(folder.string())));
}

}  // namespace prs
