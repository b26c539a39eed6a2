#include "prs/cli/study.h"

#include <system_error>

#include "modules/fit/fit_analysis.h"
#include "prs/cli/command_line.h"
#include "prs/cli/interruption.h"
#include "prs/input/optimize_reader.h"
#include "prs/optimize/optimize_pictures.h"
#include "prs/run/study.h"
#include "prs/study/response.h"
#include "prs/study/study_json.h"
#include "prs/study/study_pictures.h"
#include "prs/study/study_table.h"
#include "prs/version.h"

namespace prs::cli {
namespace {

bool is_full_disk(const std::error_code& code) {
  return code == std::errc::no_space_on_device || code == std::errc::file_too_large ||
         (code.category() == std::generic_category() && code.value() == EDQUOT);
}

void show(ProgressLine& line, const StudyProgress& now) {
  line.show([&](double seconds) { return progress_line(now.done, now.total, seconds, now.found); });
}

std::string warning_note(const Warning& warning) { return "warning: " + printable(sentence(warning)); }

/// Writes tables, figures and files of a study whose rows are complete.
int deliver_study(const StoredRows& rows, const input::StudyInput& in, const Study& study,
                  const std::function<const DesignEngine&()>& engine, std::size_t threads, const Options& options) {
  const DocumentInfo info = document_info(in.source, Command::study);
  StudyResult result{study, {}, 0, 0, 0, {}};
  StudyAnalysis analysis(study);
  write_rows(
      rows, study, options.output ? &*options.output : nullptr, threads,
      [&](const RowBlock& block, std::span<const double> inputs) {
        add(result, block);
        analysis.add(block, inputs);
      },
      options.csv);
  result.summary = analysis.summary();
  result.warnings = study_warnings(in, result, engine);
  const Delivery delivery{.file = "study.json",
                          .document = [&](const DocumentInfo& i) { return study_outline(result, i); },
                          .table = [&] { return study_table(result); },
                          .notes = notes_of(study_failures(result)),
                          .files =
                              [&](const CsvStyle& style) {
                                std::vector<OutputFile> files;
                                if (const StudySummary& s = result.summary; s.envelope)
                                  files.push_back({"envelope.csv", envelope_csv(study, *s.maps, *s.envelope, style)});
                                return files;
                              },
                          .pictures = [&] { return study_pictures(result); },
                          .keeps_figures = true,
                          .converged = result.failed == 0,
                          .write = [&](const nlohmann::ordered_json& outline,
                                       const TextSink& sink) { write_study(outline, result, sink); }};
  return deliver(delivery, info, options);
}

/// Runs the plan that is one case with its derivatives.
int derivatives(const input::StudyInput& in, const Options& options) {
  const CaseDerivatives result = run_derivatives(in);
  const Delivery delivery{.file = "derivatives.json",
                          .document = [&](const DocumentInfo& info) { return derivatives_json(result, info); },
                          .table = [&] { return derivatives_table(result); },
                          .notes = each(result.warnings, warning_note),
                          .files =
                              [&](const CsvStyle& style) {
                                return std::vector<OutputFile>{{"derivatives.csv", derivatives_csv(result, style)}};
                              },
                          .pictures = [&] { return derivatives_pictures(result); },
                          .keeps_figures = true};
  return deliver(delivery, document_info(in.source, Command::study), options);
}

/// Origin of the designs of a run, as counts whose sum is their number.
std::string origin(const StudyProgress& progress) {
  return fmt::format("{} were in the journal, {} computed", progress.found, progress.done - progress.found);
}

/// Reports the state of an interrupted study.
int report_interrupted_study(const StudyProgress& progress, const Options& options) {
  say(fmt::format("prs: interrupted; {} designs: {}, {} left; {}\n", progress.total, origin(progress),
                  progress.total - progress.done,
                  options.output ? "the same command continues from there"
                                 : "they are lost: with --output DIR a study can be continued"));
  return Interruption::status();
}

int compute(const input::Source& source, std::size_t threads, const Options& options) {
  const input::StudyInput in = input::read_study_input(source);
  std::optional<StudyFolder> folder;
  const auto open_folder = [&] {
    if (options.output)
      folder.emplace(*options.output, options.shard ? StudyFolder::Use::among_shards : StudyFolder::Use::alone);
  };
  if (in.study.plan == Plan::derivatives) {
    open_folder();
    return derivatives(in, options);
  }
  const DesignEngine engine = study_engine(in);
  const Study& study = engine.study();
  for (const Warning& warning : void_factor_warnings(in, study.responses)) note(options, warning_note(warning));
  open_folder();
  const JournalHeader header{key_of(in, in.study.command), source, study.responses, design_count(study),
                             options.shard.value_or(Shard{})};

  const RunDesigns run = [&](const NextRange& next, const TakeRecord& take) {
    run_schedule(threads, engine.chunk(), next, evaluate_with(engine, Interruption::asked), take);
  };
  ProgressLine line(options.quiet);
  StudyProgress progress;
  if (options.output) interruption_text = kContinues;
  std::optional<Interruption> interruption(patience_for(options.output.has_value()));
  const StoredRows rows = run_study(header, folder ? &*folder : nullptr, run,
                                    {options.restart, Interruption::asked,
                                     [&](const StudyProgress& now) {
                                       progress = now;
                                       show(line, now);
                                     },
                                     [&](const std::string& text) { note(options, text); }});
  interruption.reset();
  line.clear();

  const DesignRange all = part(header.designs, header.shard);
  if (count(rows.missing(all)) > 0) return report_interrupted_study(progress, options);
  if (progress.found > 0) note(options, fmt::format("{} designs: {}", progress.total, origin(progress)));
  if (options.shard) {
    note(options,
         fmt::format("shard {}: {} designs are in {}; with all shards done, `prs study "
                     "merge {} --output DIR` writes the files of the study",
                     name(*options.shard), all.count, options.output->string(), quoted(options.output->string())));
    return kDone;
  }
  const int status = deliver_study(
      rows, in, study, [&]() -> const DesignEngine& { return engine; }, threads, options);
  // If a picture failed, the same command should write it without a new computation.
  if (folder && status != kFailed) folder->remove_journals();
  return status;
}

/// Whether a journal of this study can have that header.
bool agree(const JournalHeader& header, const Study& study) {
  const auto& asked = study.responses;
  if (header.designs != design_count(study)) return false;
  if (!asked.empty()) return are_columns_of(asked, header.responses);
  const std::vector<std::string> known = default_responses(study.command);
  return std::ranges::all_of(header.responses,
                             [&](const std::string& path) { return std::ranges::find(known, path) != known.end(); });
}

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

/// Reports the state of an interrupted search.
int report_interruption(const Options& options) {
  say(options.output ? kContinues : "prs: interrupted; with --output DIR an optimization can be continued\n");
  return Interruption::status();
}

}  // namespace

int study(const Options& options) {
  if (options.shard && !options.output)
    throw UsageError("--shard is given alone; expected --output DIR with it, where its part is kept");
  const std::size_t threads = options.threads > 0 ? options.threads : default_threads();
  const input::Source source = case_source(options);
  try {
    return compute(source, threads, options);
  } catch (const std::system_error& error) {
    if (!options.output || !is_full_disk(error.code())) throw;
    say(
        fmt::format("prs: error: {}\nprs: what was computed is kept; the same command continues "
                    "from there once there is space\n",
                    error.what()));
    return kFailed;
  }
}

int merge_study(const Options& options) {
  if (!options.file.empty())
    throw UsageError("got FILE {} before `merge`; expected `prs study merge DIR..`: the journals hold the file",
                     input::shown(options.file));
  const StoredRows rows = gather_rows(options.folders);
  const JournalHeader& header = rows.journals().front().header();
  input::Source source =
      input::source_of_text(header.source.name, header.source.text, header.source.overrides, header.source.folder);
  source.files.emplace();  // A journal may come from anywhere: files that it names are not opened.
  const input::StudyInput in = input::read_study_input(source);
  if (!agree(header, in.study))
    throw StudyFolderError(
        fmt::format("{}: error: its designs or responses are not those of the study in it; remove "
                    "it, compute its part again, and merge",
                    rows.journals().front().path().string()));
  const std::vector<std::string> referred = referred_of(header.key);
  if (header.key != study_key(kVersion, source, referred))
    throw StudyFolderError(
        fmt::format("{}: error: computed by another version of prs, or changed since; merge with "
                    "that version, or compute it again",
                    rows.journals().front().path().string()));
  Study study = in.study;
  study.responses = header.responses;
  record_case(header.source.text, header.source.overrides);
  std::optional<StudyFolder> folder;
  if (options.output) folder.emplace(*options.output, StudyFolder::Use::alone);
  const std::size_t threads = options.threads > 0 ? options.threads : default_threads();
  std::optional<DesignEngine> engine;
  std::function<const DesignEngine&()> engine_of_study;
  if (referred.empty())
    engine_of_study = [&]() -> const DesignEngine& {
      if (!engine) engine.emplace(in);
      return *engine;
    };
  return deliver_study(rows, in, study, engine_of_study, threads, options);
}

int fit(const Options& options) {
  const input::Source source = case_source(options);
  const auto run_fit = [&](const input::Source& s, const input::CaseInput&) {
    return fit_case(s, {.threads = options.threads});
  };
  const Delivery found = delivered(source, input::read_case_input(source, Command::fit), fit_analysis(), run_fit);
  return deliver(found, document_info(source, Command::fit), options);
}

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
    if (options.output) interruption_text = kContinues;
    const Interruption interruption(patience_for(options.output.has_value()));
    result =
        run_optimization(in, threads, open, {Interruption::asked, [&](const StudyProgress& now) { show(line, now); }});
  }
  if (!result) return report_interruption(options);
  const int status = deliver(delivery_of(*result, source), document_info(source, Command::optimize), options);
  if (folder && status != kFailed) std::filesystem::remove(journal_file);
  return status;
}

}  // namespace prs::cli
