#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace prs {

struct OutputFile {
  std::string name;  ///< Inside the output directory.
  std::string content;
};

/// Writes the files into `directory`, which is created where it is missing. All of them are written
/// under temporary names first and renamed at the end, so no reader meets half a file and a full
/// disk leaves earlier files as they were. Throws std::system_error that names the path.
void write_files(const std::filesystem::path& directory, const std::vector<OutputFile>& files);

}  // namespace prs
