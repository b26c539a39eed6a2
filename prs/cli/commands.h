#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace prs::cli {

/// What every command is told.
struct Options {
  std::string file;
  std::vector<std::string> overrides;  ///< `path=value` each.
  bool json = false;
  bool quiet = false;
  std::optional<std::filesystem::path> output;
  bool standard = false;  ///< `prs new`: a standard screw in place of an inverted one.
};

/// Exit statuses of the program.
enum Exit { kDone = 0, kFailed = 1, kWrongInput = 2, kNotConverged = 3 };

int check(const Options& options);
int contact(const Options& options);
int solve(const Options& options);
int slip(const Options& options);
int preload(const Options& options);
int study(const Options& options);
int schema(const Options& options);
/// Prints a commented starting case, or writes it to `options.file`, which must not exist.
int new_case(const Options& options);
/// `options.file` is the directory of the sources.
int validate(const Options& options);

}  // namespace prs::cli
