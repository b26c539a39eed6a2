#pragma once

#include "prs/input/source.h"
#include "prs/output/staged_file.h"
#include "prs/record/delivery.h"

namespace prs {

/// Writes the files into `directory`, which is created where it is missing. All of them are written
/// under temporary names first and renamed at the end, so no reader meets half a file and a full
/// disk leaves earlier files as they were. Throws std::system_error that names the path.
void write_files(const std::filesystem::path& directory, const std::vector<OutputFile>& files);

/// Writes a case that the user goes on with: no later run takes it for an output of its own.
void write_case(const std::filesystem::path& file, const std::string& text);

/// Writes `plots/NAME.svg` below `directory` for every figure, with `png` also `NAME.png`: all of
/// them, or none. Throws std::system_error, with `png` also modules::Missing.
void draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& directory, bool png = false);

/// The folder for temporary files: TMPDIR, or /tmp where it is not set. Throws std::runtime_error
/// where that is no folder that can be written into.
std::filesystem::path temporary_folder();

/// The list of files that runs keep in their output folder.
inline constexpr std::string_view kFileList = ".prs-files.json";

/// Says that the process wrote this file for its user; whoever gives an output file its name calls
/// it. From any thread.
void record_written(const std::filesystem::path& file);

/// Says which case the run in progress is of, where its command line does not name the file.
void record_case(const std::string& text, const std::vector<std::string>& overrides);

/// What one run of the program writes below its output folder: listed there with its digests, so
/// that a later run removes what is out of date. One object at a time.
///
/// A run removes the files that its command listed before and that it did not write again; where
/// the folder's files are of another case, those of all commands but `study` and `optimize`, which
/// may have taken hours. A case is its file, lines of comment apart, with the overrides. The run
/// leaves alone what no run listed, what is not as it was listed, journals, the case itself and the
/// files of the run that the case is from (`best.yaml` of an optimization), and follows no symbolic
/// link.
class RunFiles {
 public:
  /// Records from now on what is written below `folder`, and keeps other runs out of it, see
  /// `FolderLock`; studies and optimizations do so themselves (`StudyFolder`). `case_file` is empty
  /// where the command reads no case.
  RunFiles(std::filesystem::path folder, std::string command, std::filesystem::path case_file,
           const std::vector<std::string>& overrides = {});
  RunFiles(const RunFiles&) = delete;
  RunFiles& operator=(const RunFiles&) = delete;
  /// Lists what was written by a run that did not come to its end, and removes nothing but folders
  /// that were made for it and are empty.
  ~RunFiles();

  /// Removes what is out of date, brings the list up to date where anything was written, and says
  /// what a user should know, a line each. Throws std::system_error where the list cannot be
  /// written.
  std::vector<std::string> finish();

 private:
  std::vector<std::string> update(bool complete);

  std::filesystem::path folder_;
  std::string command_;
  std::filesystem::path case_file_;
  bool finished_ = false;
  std::vector<std::filesystem::path> made_;  ///< Folders that were missing, the innermost first.
  std::optional<FolderLock> lock_;
  std::vector<UnfinishedPath> unfinished_;
};

/// What the last run of a command on a case wrote below a folder, as far as it is unchanged;
/// nothing where there is none.
std::vector<OutputFile> files_of_run(const std::filesystem::path& folder, std::string_view command,
                                     const input::Source& source);

}  // namespace prs
