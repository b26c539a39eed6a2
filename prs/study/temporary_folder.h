#pragma once

#include <filesystem>

namespace prs {

/// The folder for temporary files: TMPDIR, or /tmp where it is not set. Throws std::runtime_error
/// where that is no folder that can be written into.
std::filesystem::path temporary_folder();

}  // namespace prs
