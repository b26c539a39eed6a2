#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prs/study/design_range.h"

namespace prs::cli {

/// What every command is told.
struct Options {
  std::string file;
  std::vector<std::string> overrides;  ///< `path=value` each.
  bool json = false;
  bool quiet = false;
  std::optional<std::filesystem::path> output;
  std::size_t threads = 0;                     ///< Of a study; 0: one a processor.
  std::optional<Shard> shard;                  ///< `prs study --shard`: its part of the designs.
  bool restart = false;                        ///< `prs study`: discards what was computed before.
  std::vector<std::filesystem::path> folders;  ///< `prs study merge`: those of the shards.
  bool standard = false;  ///< `prs new`: a standard screw in place of an inverted one.
};

inline constexpr std::size_t kMostThreads = 4096;

/// Exit statuses of the program.
enum Exit { kDone = 0, kFailed = 1, kWrongInput = 2, kNotConverged = 3 };

int check(const Options& options);
int contact(const Options& options);
int solve(const Options& options);
int slip(const Options& options);
int preload(const Options& options);
int life(const Options& options);
int study(const Options& options);
/// Writes the files of a study from the journals in `options.folders`.
int merge_study(const Options& options);
int schema(const Options& options);
/// Prints a commented starting case, or writes it to `options.file`, which must not exist.
int new_case(const Options& options);
/// `options.file` is the directory of the sources.
int validate(const Options& options);

}  // namespace prs::cli
