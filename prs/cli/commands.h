#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prs/study/design_range.h"

namespace prs::cli {

/// What `prs configurations` is told, quantities as they are written.
struct ConfigurationOptions {
  std::string screw_diameter, lead;
  std::optional<std::string> flank_angle, gap, roller_profile_radius;
  std::optional<std::string> type;  ///< `standard` or `inverted`.
  std::optional<int> starts, roller_starts, rollers;
  std::vector<std::string> write;  ///< Empty, or the number of a line and a file.
};

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
  bool explain = false;                        ///< `prs measures`: formulas in place of numbers.
  bool standard = false;               ///< `prs new`: a standard screw in place of an inverted one.
  std::optional<std::string> recipe;   ///< `prs validate`: a source's formulas for given diameters.
  std::vector<std::string> diameters;  ///< For it: `54 mm, 27 mm, 9 mm` each.
  ConfigurationOptions configurations;
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
/// `options.explain`: prints what the measures are, without a file.
int measures(const Options& options);
int study(const Options& options);
/// Writes the files of a study from the journals in `options.folders`.
int merge_study(const Options& options);
/// Lists the geometries that a screw diameter and a lead allow.
int configurations(const Options& options);
/// Multi-objective design: writes the Pareto front and the chosen design of the file's `optimize`.
int optimize(const Options& options);
int schema(const Options& options);
/// Prints a commented starting case, or writes it to `options.file`, which must not exist.
int new_case(const Options& options);
/// `options.file` is the directory of the sources.
int validate(const Options& options);
/// A source's formulas for diameters of the user, from `options.file` and `options.diameters`.
int recipe(const Options& options);

}  // namespace prs::cli
