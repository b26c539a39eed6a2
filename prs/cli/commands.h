#pragma once

#include "prs/cli/printing.h"
#include "prs/configurations/new_case.h"
#include "prs/study/designs.h"

namespace CLI {
class App;
}

namespace prs::cli {

/// Arguments of `prs configurations`; quantities as the user wrote them.
struct ConfigurationOptions {
  std::string lead;
  std::optional<std::string> screw_diameter, nut_diameter, flank_angle, gap, roller_profile_radius;
  std::optional<std::string> type;  ///< Name of a type.
  std::optional<int> starts, roller_starts, rollers;
  std::vector<std::string> write;  ///< Empty, or the number of a line and a file.
};

/// Arguments of `prs export`; quantities as the user wrote them.
struct ExportOptions {
  bool fmu = false, modelica = false, step = false, mjcf = false, urdf = false, is_static = false;
  std::optional<std::string> force, speed, load_case, friction_load, play;
  std::optional<std::filesystem::path> output;  ///< Path of a file or a folder.
};

/// Arguments of all commands.
struct Options : OutputOptions {
  std::string file;
  std::vector<std::string> references;          ///< CSV files for `prs compare`.
  std::string other;                            ///< `prs compare`: a second case; empty: none.
  std::vector<std::string> overrides;           ///< Overrides, `path=value` each.
  std::size_t threads = 0;                      ///< Threads of a study; 0: one per processor.
  std::optional<Shard> shard;                   ///< `prs study --shard`: its share of the designs.
  bool restart = false;                         ///< `prs study`: whether to discard earlier results.
  std::vector<std::filesystem::path> folders;   ///< `prs study merge`: folders of the shards.
  std::optional<std::string> explain;           ///< Measure or result to explain.
  std::filesystem::path pages;                  ///< `prs manual`: folder for its pages.
  std::optional<std::filesystem::path> report;  ///< `prs report`: page to write.
  bool without_engine = false;                  ///< `prs report --static`.
  bool summary = false;                         ///< `prs report --summary`.
  std::vector<std::filesystem::path> results;   ///< `prs report`: folders of stored results.
  std::string what;                             ///< `prs list`, `prs schema`: subject.
  std::vector<std::string> words;               ///< `prs help`: the command to explain.
  ConfigurationOptions configurations;
  NewOptions new_case;
  ExportOptions export_model;
  std::size_t top = 10;            ///< `prs size`: rows of the table.
  std::size_t curve = 1;           ///< `prs size`: rank of the candidate whose force over speed is shown.
  std::vector<std::string> write;  ///< `prs size`: empty, or a rank and a file.
};

inline constexpr std::size_t kMostThreads = 4096;

/// FILE for standard input.
inline constexpr std::string_view kStandardInput = "-";

/// Name of the case in messages and documents.
std::string case_name(const Options& options);

/// The case named by the command line. Throws InputError; UsageError if it names none.
input::Source case_source(const Options& options);

/// Runs a command that computes a case and writes its results.
int run_case(const AnyAnalysis& row, const Options& options);
/// Compares the models of the bodies on a case, or two cases.
int compare(const Options& options);
int schema(const Options& options);

}  // namespace prs::cli
