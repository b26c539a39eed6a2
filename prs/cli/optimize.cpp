#include "prs/cli/commands.h"
#include "prs/cli/deliver.h"
#include "prs/cli/interruption.h"
#include "prs/cli/progress_line.h"
#include "prs/optimize/optimize_json.h"
#include "prs/optimize/optimize_pictures.h"
#include "prs/optimize/optimize_table.h"
#include "prs/run/optimization.h"

namespace prs::cli {
namespace {

Delivery delivery_of(const OptimizationResult& result, const input::Source& source) {
  return {.file = "optimize.json",
          .document = [&](const DocumentInfo& info) { return optimize_json(result, info); },
          .table = [&] { return optimize_table(result); },
          .notes = notes_of(optimize_failure(result)),
          .files =
              [&](const CsvStyle& style) {
                std::vector<OutputFile> files{{"front.csv", front_csv(result, style)},
                                              {"history.csv", history_csv(result, style)}};
                if (const std::optional<std::string> chosen = chosen_case(result, source))
                  files.push_back({"best.yaml", *chosen});
                return files;
              },
          .pictures = [&] { return optimization_pictures(result); },
          .keeps_figures = true,
          .converged = result.compromise.has_value()};
}

/// What a run that was stopped leaves behind.
int report_interruption(const Options& options) {
  say(fmt::format("prs: interrupted; {}\n",
                  options.output ? "the same command continues from there"
                                 : "with --output DIR an optimization can be continued"));
  return Interruption::status();
}

}  // namespace

int optimize(const Options& options) {
  const input::Source source = case_source(options);
  const input::OptimizeInput in = input::read_optimize_input(source);
  const std::size_t threads = options.threads > 0 ? options.threads : default_threads();
  const std::filesystem::path journal_file =
      options.output ? *options.output / "optimize.journal" : std::filesystem::path();
  std::optional<StudyFolder> folder;
  const auto open = [&](const JournalHeader& header) {
    if (!options.output) return Journal::temporary(header);
    folder.emplace(*options.output, StudyFolder::Use::alone, "prs optimize");
    return Journal::append_to(journal_file, header, options.restart);
  };
  std::optional<OptimizationResult> result;
  {
    ProgressLine line(options.quiet);
    const Interruption interruption(patience_for(options.output.has_value()));
    result = run_optimization(
        in, threads, open,
        {Interruption::asked, [&](const StudyProgress& progress) { line.show(progress); }});
  }
  if (!result) return report_interruption(options);
  const int status =
      deliver(delivery_of(*result, source), document_info(source, Command::optimize), options);
  if (folder && status != kFailed) std::filesystem::remove(journal_file);
  return status;
}

}  // namespace prs::cli
