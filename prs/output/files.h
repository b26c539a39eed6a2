#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "prs/record/output_file.h"

namespace prs {

/// Writes the files into `directory`, which is created where it is missing. All of them are written
/// under temporary names first and renamed at the end, so no reader meets half a file and a full
/// disk leaves earlier files as they were. Throws std::system_error that names the path.
void write_files(const std::filesystem::path& directory, const std::vector<OutputFile>& files);

/// Writes a case that the user goes on with: no later run takes it for an output of its own.
void write_case(const std::filesystem::path& file, const std::string& text);

}  // namespace prs
