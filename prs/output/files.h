#pragma once

#include <filesystem>

#include "prs/record/delivery.h"
#include "prs/record/figure.h"

namespace prs {

/// Writes the files into `directory`, which is created where it is missing. All of them are written
/// under temporary names first and renamed at the end, so no reader meets half a file and a full
/// disk leaves earlier files as they were. Throws std::system_error that names the path.
void write_files(const std::filesystem::path& directory, const std::vector<OutputFile>& files);

/// Writes a case that the user goes on with: no later run takes it for an output of its own.
void write_case(const std::filesystem::path& file, const std::string& text);

/// Writes `plots/NAME.svg` below `directory` for every figure, with `png` also `NAME.png`: all of
/// them, or none. Throws std::system_error, with `png` also modules::Missing.
void draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& directory,
                  bool png = false);

/// The folder for temporary files: TMPDIR, or /tmp where it is not set. Throws std::runtime_error
/// where that is no folder that can be written into.
std::filesystem::path temporary_folder();

}  // namespace prs
