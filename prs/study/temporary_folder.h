#pragma once

#include <filesystem>

namespace prs {

/// Where temporary files go: TMPDIR, or /tmp where it is not set. Throws std::runtime_error where
/// that is no folder that can be written into.
std::filesystem::path temporary_folder();

}  // namespace prs
