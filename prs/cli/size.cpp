#include "prs/cli/size.h"

#include "prs/cli/command_line.h"
#include "prs/cli/new_case.h"
#include "prs/size/size_analysis.h"

namespace prs::cli {
namespace {

/// Candidates and their files, by `--write RANK FILE`.
std::vector<std::pair<std::size_t, std::string>> written_of(const Options& options) {
  std::vector<std::pair<std::size_t, std::string>> all;
  if (options.write.size() % 2 != 0)
    fail_option("--write", "got a rank without a file; expected `--write 1 screw.yaml`");
  for (std::size_t k = 0; k < options.write.size(); k += 2) {
    const std::string &rank = options.write[k], &file = options.write[k + 1];
    const std::optional<double> number = input::parse_number(rank);
    if (!number || !(*number >= 1.0) || *number != std::floor(*number))
      fail_option("--write",
                  "got {}; expected the rank of a candidate and a file, for example `--write 1 "
                  "screw.yaml`",
                  input::shown(rank));
    refuse_taken(options, file);
    const auto same = [&](const auto& before) {
      return std::filesystem::path(before.second).lexically_normal() == std::filesystem::path(file).lexically_normal();
    };
    if (std::ranges::any_of(all, same))
      fail_option("--write", "got {} twice; expected a file for each candidate; give another name", input::shown(file));
    all.emplace_back(*number, file);
  }
  return all;
}

}  // namespace

int size(const Options& options) {
  const auto cases = written_of(options);
  const input::Source source = case_source(options);
  SizeOptions how{.curve_of = options.curve, .threads = options.threads};
  SizeResult result = [&] {
    ProgressLine line(options.quiet);
    how.progress = [&](std::size_t done, std::size_t all) { line.tell(fmt::format("{} of {} candidates", done, all)); };
    return size_screws(read_requirement(source), how);
  }();
  const std::size_t ranks = result.candidates.size();
  const auto require = [&](const char* option, std::size_t rank) {
    if (rank > ranks) fail_option(option, "got {}; expected a rank of the list, 1 to {}", rank, ranks);
  };
  require("--curve", options.curve);
  for (const auto& written : cases) require("--write", written.first);
  Options rest = options;
  for (const auto& [rank, file] : cases) {
    const SizedCandidate& c = result.candidates[rank - 1];
    write_new(
        options, file, written_candidate(result.input, c),
        fmt::format("{}, rank {}, is written{}", c.name, rank, c.passes ? "" : "; it does not pass: see the list"));
    if (file == kStandardInput) rest.quiet = true;
  }
  return deliver(size_delivery(std::move(result), options.top), document_info(source, Command::size), rest);
}

}  // namespace prs::cli
