#include "prs/report/findings.h"

#include <fmt/chrono.h>

#include <cstdlib>
#include <ctime>
#include <iterator>

#include "prs/model/void_inputs.h"
#include "prs/output/run_files.h"
#include "prs/report/svg.h"

namespace prs {
namespace {

std::vector<WarningGroup> warnings_of(const Findings& all) {
  std::vector<Warning> warnings = all.of_check;
  for (const CommandAnswer& answer : all.answers)  // The page shows the loads of the case's model.
    if (answer.command != Command::compare || !all.answer(Command::solve))
      std::ranges::move(answer.delivery.warnings(), std::back_inserter(warnings));
  return grouped(warnings);
}

/// By what was computed; `failures` of commands that found the case wrong.
CaseVerdict verdict_of(const Findings& all, const input::CaseInput& in,
                       std::vector<Attempt> failures = {}) {
  for (const CommandAnswer& answer : all.answers)
    failures.push_back({answer.command, &answer.delivery});
  return verdict_by(in, failures);
}

/// SOURCE_DATE_EPOCH where it is set, so that the same case gives the same bytes.
std::string date_of_report() {
  std::time_t now = std::time(nullptr);
  if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH")) {
    char* end = nullptr;
    const long long seconds = std::strtoll(fixed, &end, 10);
    constexpr long long kYear10000 = 253'402'300'800;
    if (end != fixed && *end == '\0' && seconds >= 0 && seconds < kYear10000)
      now = static_cast<std::time_t>(seconds);
  }
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(now));
}

Findings nothing_of(input::Source source, const input::CaseInput& in) {
  Findings all;
  all.source = std::move(source);
  all.date = date_of_report();
  all.is_full = in.values.model.mechanism == ModelOptions::Mechanism::full;
  return all;
}

void add_answer(Findings& all, Command command, Delivery delivery) {
  CommandAnswer answer{command, std::move(delivery), {}};
  DocumentInfo info = document_info(all.source, command);
  info.resolved_input = {};  // That of the check is the page's.
  answer.document = answer.delivery.document(info);
  if (answer.delivery.pictures) answer.pictures = answer.delivery.pictures();
  all.converged = all.converged && answer.delivery.converged;
  all.answers.push_back(std::move(answer));
}

}  // namespace

const CommandAnswer* Findings::answer(Command command) const {
  const auto found = std::ranges::find(answers, command, &CommandAnswer::command);
  return found == answers.end() ? nullptr : &*found;
}

const CommandAnswer* Findings::most_complete() const {
  const CommandAnswer* solve = answer(Command::solve);
  return solve ? solve : answer(Command::contact);
}

std::span<const Command> reported_commands() {
  static const std::vector<Command> all = [] {
    std::vector<Command> commands;
    for (const AnyAnalysis& analysis : analyses())
      if (analysis.run && analysis.command != Command::check) commands.push_back(analysis.command);
    return commands;
  }();
  return all;
}

Findings findings_of(input::Source source, ReportOptions options,
                     std::span<const Command> commands) {
  const input::CaseInput in = input::read_case_input(source, Command::check);
  Findings all = nothing_of(std::move(source), in);
  all.options = std::move(options);
  for (const VoidInput& input : void_inputs(in.values)) all.void_paths.push_back(input.path);
  const Delivery check = run_check(all.source, in);
  all.check = check.document(document_info(all.source, Command::check));
  all.of_check = check.warnings();
  std::vector<Attempt> failures;
  for (const Command command : commands) {
    if (!input::missing(in, command).empty()) continue;
    try {
      add_answer(all, command, analysis_of(command).run(all.source, in));
    } catch (const input::InputError& error) {
      all.notes.push_back(fmt::format("{} was not computed: {}", name(command), error.what()));
      failures.push_back({command, nullptr, error.what()});
    }
  }
  for (const Command command : {Command::study, Command::optimize})
    for (const std::filesystem::path& folder : all.options.results) {
      StoredRun study{command, files_of_run(folder, name(command), all.source)};
      if (study.files.empty()) continue;
      all.studies.push_back(std::move(study));
      break;
    }
  all.warnings = warnings_of(all);
  all.verdict = verdict_of(all, in, std::move(failures));
  return all;
}

Findings quick_findings_of(input::Source source, FullSolver& full) {
  input::CaseInput in = input::read_case_input(source, Command::check);
  in.study.reset();  // Whether its designs are sound is said when the values rest.
  in.optimize.reset();
  in.fields.clear();  // Shown when the values rest.
  Findings all = nothing_of(std::move(source), in);
  all.of_check = run_check(all.source, in).warnings();
  if (input::missing(in, Command::solve).empty())
    add_answer(all, Command::solve, run_solve(all.source, in, {.full = &full}));
  else
    add_answer(all, Command::contact, analysis_of(Command::contact).run(all.source, in));
  all.warnings = warnings_of(all);
  all.verdict = verdict_of(all, in);
  return all;
}

const Json& under(const Json& json, const std::string& key) {
  static const Json none;
  const auto found = json.find(key);
  return found == json.end() ? none : *found;
}

std::string input_value(const Findings& all, std::string_view path) {
  for (const Json& entry : all.check["input"])
    if (entry["path"] == path) return entry["value"].get<std::string>();
  return {};
}

std::string figure_html(Findings& all, Figure figure, bool narrow) {
  const int place = all.places[figure.name]++;
  const FigurePlace key{all.section, figure.name, place};
  if (all.keeps_figures) all.figures.emplace(key, figure);
  if (all.before)
    if (const auto found = all.before->figures.find(key); found != all.before->figures.end())
      add_behind(figure, found->second);
  return fmt::format(
      "<figure data-figure=\"{}\"{}><figcaption>{}</figcaption><div class=\"wide\" "
      "tabindex=\"0\">{}</div></figure>\n",
      html(figure.name), narrow ? " class=\"narrow\"" : "", html(in_table_units(figure.title)),
      svg(figure, fmt::format("{}-{}-{}", all.section, figure.name, place)));
}

}  // namespace prs
