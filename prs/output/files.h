#pragma once

#include "prs/input/source.h"
#include "prs/output/staged_file.h"
#include "prs/record/delivery.h"

namespace prs {

/// Writes the files into `directory`, which is created if missing. All are first written under temporary names and
/// renamed at the end, so that no reader sees an incomplete file and a full disk leaves earlier files unchanged. Throws
/// std::system_error that names the path. A copy of a file that stands there itself is left out.
void write_files(const std::filesystem::path& directory, const std::vector<OutputFile>& files);

/// Writes a case for further use: no later run treats it as its own output.
void write_case(const std::filesystem::path& file, const std::string& text);

/// Writes `plots/NAME.svg` below `directory` for every figure, with `png` also `NAME.png`: all of
/// them, or none. Throws std::system_error, with `png` also modules::Missing.
void draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& directory, bool png = false);

/// Folder for temporary files: TMPDIR, or /tmp if that is not set. Throws std::runtime_error if it is not a writable
/// folder.
std::filesystem::path temporary_folder();

/// Name of the list of files that runs keep in their output folder.
inline constexpr std::string_view kFileList = ".prs-files.json";

/// Records that the process wrote this file for its user; called wherever an output file gets its name. From any
/// thread.
void record_written(const std::filesystem::path& file);

/// Records the case of the run in progress, if its command line does not name the file.
void record_case(const std::string& text, const std::vector<std::string>& overrides);

/// Files that one run of the program writes below its output folder: listed there with their digests, so that a later
/// run removes those out of date. One object at a time.
///
/// A run removes the files that its command listed before and that it did not write again; if the folder's files belong
/// to another case, those of all commands except `study` and `optimize`, which may have taken hours. A case is its file
/// without comment lines, with the overrides. The run leaves alone files that no run listed, files changed since they
/// were listed, journals, the case itself and the files of the run that wrote the case (`best.yaml` of an
/// optimization), and follows no symbolic link.
class RunFiles {
 public:
  /// Records from now on the files written below `folder`, and keeps other runs out of it, see `FolderLock`; studies
  /// and optimizations do so themselves (`StudyFolder`). `case_file` is empty if the command reads no case.
  RunFiles(std::filesystem::path folder, std::string command, std::filesystem::path case_file,
           const std::vector<std::string>& overrides = {});
  RunFiles(const RunFiles&) = delete;
  RunFiles& operator=(const RunFiles&) = delete;
  /// Lists the files of an incomplete run, and removes only empty folders that were made for it.
  ~RunFiles();

  /// Removes files out of date, updates the list if anything was written, and returns messages for the user, one per
  /// line. Throws std::system_error if the files cannot be read back for lack of descriptors, or the list not written.
  std::vector<std::string> finish();

 private:
  std::vector<std::string> update(bool complete);

  std::filesystem::path folder_;
  std::string command_;
  std::filesystem::path case_file_;
  bool finished_ = false;
  std::vector<std::filesystem::path> made_;  ///< Folders that were created, the innermost first.
  std::optional<FolderLock> lock_;
  std::vector<UnfinishedPath> unfinished_;
};

/// Unchanged files that the last run of a command on a case wrote below a folder; none if there are none.
std::vector<OutputFile> files_of_run(const std::filesystem::path& folder, std::string_view command,
                                     const input::Source& source);

}  // namespace prs
