#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "prs/cli/commands.h"
#include "prs/cli/interruption.h"
#include "prs/cli/printing.h"
#include "prs/cli/progress_line.h"
#include "prs/input/fail_at.h"
#include "prs/input/force_history.h"
#include "prs/input/optimize_reader.h"
#include "prs/optimize/optimizer.h"
#include "prs/optimize/parallel_evaluation.h"
#include "prs/output/files.h"
#include "prs/output/optimize_case.h"
#include "prs/output/optimize_csv.h"
#include "prs/output/optimize_designs.h"
#include "prs/output/optimize_figures.h"
#include "prs/output/optimize_json.h"
#include "prs/output/optimize_table.h"
#include "prs/output/plots.h"
#include "prs/study/design_engine.h"
#include "prs/study/schedule.h"
#include "prs/study/study_folder.h"
#include "prs/version.h"

namespace prs::cli {
namespace {

DesignEngine engine_of(const input::OptimizeInput& in) {
  try {
    return DesignEngine(in.start);
  } catch (const UnknownResponse& error) {
    const std::string& at = in.asked_at[error.index()];
    if (at != "optimize.thread_constraints") input::fail_at(in.start.source, at, error.what());
    input::fail_at(in.start.source, at,
                   fmt::format("needs {}, which this mechanism does not have; expected threads "
                               "with heights and a contact at both interfaces; give "
                               "`mechanism.thread` of screw, roller and nut",
                               in.optimization.study.responses[error.index()]));
  }
}

/// What the answers depend on.
std::string key_of(const input::OptimizeInput& in) {
  std::vector<std::string> referred;
  if (in.optimization.study.command == Command::life)
    if (const Case base = input::read_design(in.start, {}); base.life->history)
      referred.push_back(input::force_history_text(*base.life->history, in.start.source));
  return study_key(kVersion, in.start.source, referred);
}

/// Removes what a process left that died while it wrote the files.
void remove_unfinished(const std::filesystem::path& folder) {
  const std::regex unfinished(
      R"((front\.csv|history\.csv|optimize\.json|best\.yaml)\.\d+-\d+\.tmp)");
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (std::regex_match(entry.path().filename().string(), unfinished))
      std::filesystem::remove(entry.path());
}

std::string remark(const OptimizationResult& result, const std::string& file) {
  const Optimization& o = result.optimization;
  return fmt::format("{} of `prs optimize {}`, {} with seed {}: design {} of {}",
                     result.compromise ? "Compromise" : "Nearest design", file, name(o.algorithm),
                     o.seed, result.compromise.value_or(result.nearest.value_or(0)) + 1,
                     result.search.designs.size());
}

int deliver(const OptimizationResult& result, const input::Source& source, const Options& options) {
  std::string document;
  if (options.json || options.output)
    document = json_text(optimize_json(result, document_info(source)));
  if (options.output) {
    for (const std::string& text : draw_figures(optimize_figures(result), *options.output))
      note(options, text);
    std::vector<OutputFile> files{{"front.csv", front_csv(result)},
                                  {"history.csv", history_csv(result)},
                                  {"optimize.json", document}};
    if (const EvaluatedDesign* chosen = result.chosen())
      files.push_back({"best.yaml", case_with(source, settings_of(result.optimization, *chosen),
                                              remark(result, source.name))});
    write_files(*options.output, files);
  }
  if (options.json) {
    print(document);
  } else if (!options.quiet) {
    print(optimize_table(result));
    if (options.output) print(fmt::format("\nFiles: {}\n", options.output->string()));
  }
  return result.compromise ? kDone : kNotConverged;
}

/// What a run that was stopped leaves behind.
int report_interruption(const Options& options) {
  fmt::print(stderr, "prs: interrupted; {}\n",
             options.output ? "the same command continues from there"
                            : "with --output DIR an optimization can be continued");
  return kFailed;
}

}  // namespace

int optimize(const Options& options) {
  let_large_files_fail();
  const input::Source source = input::load_source(options.file, options.overrides);
  const input::OptimizeInput in = input::read_optimize_input(source);
  const DesignEngine engine = engine_of(in);
  const Optimization& optimization = in.optimization;
  const std::size_t threads = options.threads > 0 ? options.threads : available_processors();
  const EvaluateDesigns evaluate = evaluate_in_parallel(engine, threads);
  const std::vector<Draw> as_in_file(optimization.study.factors.size());
  const RowBlock base = evaluate({as_in_file});
  input::check_initial(in, {as_in_file, base.responses,
                            base.failures.empty() ? DesignStatus{} : base.failures[0].status, 0.0});

  std::optional<StudyFolder> folder;
  if (options.output) {
    folder.emplace(*options.output, StudyFolder::Use::alone);
    remove_unfinished(*options.output);
  }
  const std::filesystem::path journal_file =
      options.output ? *options.output / "optimize.journal" : std::filesystem::path();
  const JournalHeader header{key_of(in), source, optimization.study.responses,
                             design_count(optimization), Shard{}};
  std::optional<OptimizationResult> result;
  {
    Journal journal = folder ? Journal::append_to(journal_file, header, options.restart)
                             : Journal::temporary(header);
    ProgressLine line(options.quiet);
    const Interruption interruption;
    result = prs::optimize(
        optimization, evaluate, journal,
        {Interruption::asked, [&](const StudyProgress& progress) { line.show(progress); }});
  }
  if (!result) return report_interruption(options);
  const int status = deliver(*result, source, options);
  if (folder) std::filesystem::remove(journal_file);
  return status;
}

}  // namespace prs::cli
