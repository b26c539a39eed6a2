#include "prs/report/findings.h"

#include <fmt/chrono.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <ctime>

#include "modules/module.h"
#include "prs/indices.h"
#include "prs/model/check_case.h"
#include "prs/output/files.h"
#include "prs/report/glossary.h"
#include "prs/run/analyses.h"
#include "prs/text.h"
#include "prs/version.h"

namespace prs {
namespace {

std::vector<Warning> warnings_of(const Findings& all) {
  std::vector<Warning> warnings = all.check.warnings();
  for (const CommandAnswer& answer : all.answers) {
    std::vector<Warning> its = answer.delivery.warnings();
    if (answer.command == Command::compare &&
        all.answer(Command::solve))  // The page shows the loads of the case's model.
      std::erase_if(its, [](const Warning& warning) { return !warning.code.starts_with("reference_"); });
    append(warnings, its);
  }
  return warnings;
}

/// Verdict by the computed results; `failures`: commands that found an error in the case.
CaseVerdict verdict_of(const Findings& all, const input::CaseInput& in, std::vector<Attempt> failures = {}) {
  for (const CommandAnswer& answer : all.answers) failures.push_back({answer.command, &answer.delivery});
  return verdict_by(in, failures);
}

/// SOURCE_DATE_EPOCH where it is set, so that the same case gives the same bytes.
std::string date_of_report() {
  std::time_t now = std::time(nullptr);
  if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH")) {
    char* end = nullptr;
    const long long seconds = std::strtoll(fixed, &end, 10);
    constexpr long long kYear10000 = 253'402'300'800;
    if (end != fixed && *end == '\0' && seconds >= 0 && seconds < kYear10000) now = static_cast<std::time_t>(seconds);
  }
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(now));
}

Findings nothing_of(input::Source source, const input::CaseInput& in) {
  Findings all;
  all.source = std::move(source);
  all.date = date_of_report();
  all.is_full = in.values.model.all_rollers();
  return all;
}

void add_answer(Findings& all, Command command, Delivery delivery) {
  CommandAnswer answer{command, std::move(delivery), {}};
  DocumentInfo info = document_info(all.source, command);
  info.resolved_input = {};  // The resolved input of the check is that of the page.
  answer.document = answer.delivery.document(info);
  if (answer.delivery.pictures) answer.pictures = answer.delivery.pictures();
  all.converged = all.converged && answer.delivery.converged;
  all.answers.push_back(std::move(answer));
}

std::string number_html(const std::string& value, std::string_view unit) {
  return value + (unit.empty() ? "" : fmt::format(" <small>{}</small>", html(unit)));
}

/// HTML of a tile, without a key for scripts on the first sheet; also if a page moved values away from those of the
/// report.
std::string tile_html(std::string_view key, std::string_view classes, std::string_view title, const std::string& number,
                      const std::string& before, const std::string& below) {
  return fmt::format(
      "<div{}{}><dt>{}</dt><dd><div class=\"value\">{}</div>{}{}</dd></div>\n",
      key.empty() ? "" : fmt::format(" data-tile=\"{}\"", key),
      classes.empty() ? "" : fmt::format(" class=\"{}\"", classes),
      !key.empty() && is_general_term(title) ? term_html(title, title) : html(title), number,
      before.empty() || before == number ? "" : fmt::format("<div class=\"before\">report: {}</div>", before), below);
}

std::string where_html(std::string_view text) { return fmt::format("<div class=\"where\">{}</div>", prose_html(text)); }

// Numbers that keep their load while a page moves that of the load cases.
constexpr std::string_view kStale = "stale", kStays = "does not follow the load cases";

std::string shown(const Headline& headline) {
  const ShownUnit& unit = unit_of(headline.key);
  const ReportUnit of_page = report_unit(headline.key, unit.text);
  return number_html(report_number(headline.value * unit.factor * of_page.factor, of_page.text), of_page.text);
}

std::string headlines_html(const Findings& all) {
  std::string tiles;
  for (const CommandAnswer& answer : all.answers) {
    if (!answer.delivery.headlines) continue;
    const CommandAnswer* other = all.before ? all.before->answer(answer.command) : nullptr;
    const std::vector<Headline> before = other ? other->delivery.headlines() : std::vector<Headline>{};
    const bool stays = all.unmoved.contains(answer.command);
    for (const Headline& headline : answer.delivery.headlines()) {
      const auto same = std::ranges::find(before, headline.title, &Headline::title);
      tiles += tile_html(headline.title, stays ? kStale : "", headline.title, shown(headline),
                         same == before.end() ? "" : shown(*same), where_html(stays ? kStays : headline.where));
    }
  }
  return tiles;
}

// Cards of the verdict.

/// Unit in which the page shows value and limit.
ReportUnit card_unit(const Criterion& c) {
  const auto [unit, factor] = shown(c);
  const ReportUnit of_page = report_unit("", unit);
  return {of_page.text, factor * of_page.factor};
}

std::string value_html(const Criterion& c) {
  if (!c.value) return "–";
  const ReportUnit unit = card_unit(c);
  return number_html(report_number(*c.value * unit.factor, unit.text), unit.text);
}

bool has_cycle(const Findings& all) {
  const Result* slip = all.result<Result>(Command::slip);
  return slip && slip->heat_cycle;
}

/// Place of the worst value, and of the best if different; none for efficiencies at temperatures that a duty cycle does
/// not reach.
std::string place_of(const Findings& all, const Criterion& c) {
  constexpr double kSame = 0.01;
  std::string where = c.load_case;
  if (!c.reason.empty()) where += (where.empty() ? "" : ": ") + c.reason;
  if (c.name == "efficiency" && has_cycle(all)) return where;
  if (c.standing == Standing::no_limit && c.best && std::abs(*c.best - *c.value) > kSame * std::abs(*c.value)) {
    const ReportUnit unit = card_unit(c);
    where += fmt::format("; best {}", report_number(*c.best * unit.factor, unit.text));
  }
  return where;
}

/// `at least 20000 h`.
std::string limit_html(const Criterion& c) {
  const auto [unit, factor] = card_unit(c);
  return fmt::format("{} {}{}{}", c.sense == Sense::least ? "at least" : "at most",
                     report_number(*c.limit * factor, unit), unit.empty() ? "" : " ", html(unit));
}

std::string card_html(const Findings& all, const Criterion& c, std::string_view key) {
  std::string below;
  if (c.limit) below += fmt::format("<div class=\"where\">{}, {}</div>", limit_html(c), html(origin(c)));
  std::string before;
  if (all.before)
    for (const Criterion& other : all.before->verdict.criteria)
      if (other.name == c.name) before = value_html(other);
  // The worst load is one of `life`, in a separate spectrum or history.
  if (c.load_case.starts_with("life.") && all.unmoved.contains(Command::life))
    return tile_html(key, kStale, c.title, value_html(c), before, where_html(kStays));
  if (c.limit) below += fmt::format("<div class=\"state {}\">{}</div>", name(c.standing), words(c));
  return tile_html(key, name(c.standing), c.title, value_html(c), before, below + where_html(place_of(all, c)));
}

bool is_card(const Criterion& c) { return (c.value || c.limit) && c.name != "convergence"; }

std::string standing_html(const CaseVerdict& verdict) {
  return fmt::format("<span class=\"state {}\">{}</span>", name(verdict.standing()), prose_html(summary(verdict)));
}

/// Loads, speed and limits that the case states.
std::string requirement_html(const Findings& all) {
  constexpr std::size_t kMostLoads = 4;
  std::vector<std::string> loads, limits;
  if (const CommandAnswer* answer = all.most_complete())
    for (const LoadCaseResult& r : answer->delivery.result<Result>()->load_cases)
      loads.push_back(fmt::format("{}: {}{}", case_name_cell(r),
                                  significant_with_unit(r.load_case.axial_force, "kN", 4),
                                  direction_cell(r) == kAbsent ? "" : " " + direction_cell(r)));
  if (loads.size() > kMostLoads) {
    const std::size_t more = loads.size() - kMostLoads;
    loads.resize(kMostLoads);
    loads.push_back(fmt::format("{} more in the report", more));
  }
  for (const Criterion& c : all.verdict.criteria)
    if (c.limit && c.source == LimitSource::stated)
      limits.push_back(fmt::format("{} {}", html(c.title), limit_html(c)));
  if (limits.empty()) limits.push_back("none stated: recommended values and physical limits");
  const auto fact = [](const char* title, const std::string& value) {
    return value.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>\n", title, value);
  };
  return "<dl class=\"facts\">\n" + fact("Loads", prose_html(fmt::format("{}", fmt::join(loads, "; ")))) +
         fact("Loads of the life", prose_html(input_value(all, "life.history.file"))) +
         fact("Speed", prose_html(input_value(all, "operation.speed"))) +
         fact("Limits", fmt::format("{}", fmt::join(limits, "; "))) + "</dl>\n";
}

/// Warnings, then assumptions, as many as fit on the sheet, and how many inputs are assumed.
std::string foundations_html(const Findings& all) {
  constexpr std::size_t kMost = 6, kLetters = 900;
  std::vector<std::string> lines;
  for (const bool assumptions : {false, true})
    for (const WarningGroup& group : grouped(selected(all.warnings, assumptions))) lines.push_back(group.text());
  std::size_t shown = 0, letters = 0;
  std::string text = "<ul class=\"warnings\">\n";
  for (; shown < std::min(lines.size(), kMost) && (letters += lines[shown].size()) < kLetters; ++shown)
    text += fmt::format("<li>{}</li>\n", prose_html(lines[shown]));
  if (shown < lines.size()) text += fmt::format("<li>{} more in the report</li>\n", lines.size() - shown);
  const std::size_t assumed = assumed_inputs(all);
  if (assumed > 0)
    text += fmt::format("<li>{} inputs are assumed by rule: the report lists each with its reason</li>\n", assumed);
  return assumed == 0 && lines.empty() ? "<p>None.</p>\n" : text + "</ul>\n";
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

const CommandAnswer* Findings::of_threads() const {
  const CommandAnswer* slip = answer(Command::slip);
  return slip ? slip : most_complete();
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

Findings findings_of(input::Source source, ReportOptions options, std::span<const Command> commands) {
  const input::CaseInput in = input::read_case_input(source, Command::check);
  Findings all = nothing_of(std::move(source), in);
  all.options = std::move(options);
  for (const VoidInput& input : void_inputs(in.values)) all.void_paths.push_back(input.path);
  all.origin = document_info(all.source, Command::check);
  all.check = run_check(all.source, in);
  std::vector<Attempt> failures;
  for (const Command command : commands) {
    if (!input::missing(in, command).empty()) continue;
    try {
      add_answer(all, command, analysis_of(command).run(all.source, in));
    } catch (const input::InputError& error) {
      all.notes.push_back(fmt::format("{} was not computed: {}", name(command), error.what()));
      failures.push_back({command, nullptr, error.what()});
    } catch (const modules::Missing& error) {
      all.lacking.push_back(command);
      failures.push_back({command, nullptr, error.what(), Attempt::Lacking::module});
      all.notes.push_back(fmt::format("{} was not computed: {}", name(command), error.what()));
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
  if (!all.verdict.impossible.empty()) throw input::InputError(all.verdict.impossible);
  return all;
}

Findings quick_findings_of(input::Source source, FullSolver& full) {
  input::CaseInput in = input::read_case_input(source, Command::check);
  in.study.reset();  // The study's designs are checked after the values are at rest.
  in.optimize.reset();
  in.fields.clear();  // Shown when the values rest.
  Findings all = nothing_of(std::move(source), in);
  all.check = run_check(all.source, in);
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
  const std::vector<input::EchoEntry>& fields = all.checked().fields;
  const auto found = std::ranges::find(fields, path, &input::EchoEntry::path);
  return found == fields.end() ? std::string() : found->value;
}

std::size_t assumed_inputs(const Findings& all) {
  return static_cast<std::size_t>(std::ranges::count_if(all.checked().fields, [&](const input::EchoEntry& field) {
    return basis_of(field, all.checked()).first == "assumed";
  }));
}

std::string figure_html(Findings& all, Figure figure) {
  const int place = all.places[figure.name]++;
  const FigurePlace key{all.section, figure.name, place};
  if (all.keeps_figures) all.figures.emplace(key, figure);
  if (all.before)
    if (const auto found = all.before->figures.find(key); found != all.before->figures.end())
      add_behind(figure, found->second);
  return fmt::format(
      "<figure data-figure=\"{}\"><figcaption>{}</figcaption><div class=\"wide\" "
      "tabindex=\"0\">{}</div></figure>\n",
      html(figure.name), prose_html(figure.title),
      svg(figure, fmt::format("{}-{}-{}", all.section, figure.name, place)));
}

std::vector<std::string> unconverged(const Findings& all) {
  std::vector<std::string> notes;
  for (const CommandAnswer& answer : all.answers) {
    if (answer.delivery.converged) continue;
    std::vector<std::string> names;
    for (const Json& load_case : under(answer.document, "load_cases"))
      if (!load_case.value("converged", true)) names.push_back(load_case.value("name", ""));
    notes.push_back(fmt::format("{} did not converge{}; the page says why", name(answer.command),
                                names.empty() ? "" : ": load case " + folded_names(names)));
  }
  return notes;
}

std::string verdict_html(const Findings& all) {
  const CaseVerdict& verdict = all.verdict;
  std::string text = standing_html(verdict) + " ";
  if (const Result* solve = all.result<Result>(Command::solve)) {
    const auto failed = std::ranges::count(solve->load_cases, false, &LoadCaseResult::converged);
    const std::size_t count = solve->load_cases.size();
    text += failed == 0
                ? fmt::format("{} load case{} solved. ", count, count == 1 ? "" : "s")
                : fmt::format("<span class=\"state red\">{} of {} load cases did not converge.</span> ", failed, count);
  }
  for (const CommandAnswer& answer : all.answers)
    if (!answer.delivery.converged && answer.command != Command::solve)
      text += fmt::format("<span class=\"state red\">{} did not converge.</span> ",
                          capitalised(std::string(name(answer.command))));
  if (selected(all.warnings, false).empty()) text += "No warnings.";
  std::string cards;
  for (const Criterion& c : verdict.criteria)
    if (is_card(c)) cards += card_html(all, c, c.name);
  cards += headlines_html(all);
  if (!cards.empty()) cards = "<dl class=\"tiles\">\n" + cards + "</dl>\n";
  const std::string rest = not_computed(verdict);
  if (!rest.empty()) cards += fmt::format("<p class=\"default\">No value: {}.</p>\n", prose_html(rest));
  return "<p>" + text + "</p>\n" + cards;
}

std::string summary_html(Findings& all) {
  constexpr std::ptrdiff_t kNumbers = 5;
  std::vector<const Criterion*> numbers;
  for (const Criterion& c : all.verdict.criteria)
    if (is_card(c)) numbers.push_back(&c);
  const auto weight = [](const Criterion* c) {
    return c->standing == Standing::red ? 0 : c->standing == Standing::amber ? 1 : c->limit ? 2 : 3;
  };
  std::ranges::sort(numbers, {}, [&](const Criterion* c) { return std::pair(weight(c), c); });
  if (std::ssize(numbers) > kNumbers) numbers.resize(kNumbers);
  std::ranges::sort(numbers);
  std::string tiles;
  for (const Criterion* c : numbers) tiles += card_html(all, *c, "");
  std::string drawing;
  if (const CommandAnswer* answer = all.most_complete())
    drawing = figure_html(all, figure(answer->pictures, "section", {}));
  std::string signatures;
  for (const auto& [role, person] : {std::pair{"Prepared", input_value(all, "report.author")},
                                     {"Checked", std::string()},
                                     {"Approved", std::string()}})
    signatures += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td></td><td></td></tr>\n", role, html(person));
  return "<h3>Requirement</h3>\n" + requirement_html(all) + "<h3>Verdict</h3>\n<p>" + standing_html(all.verdict) +
         "</p>\n" + (tiles.empty() ? "" : "<dl class=\"tiles\">\n" + tiles + "</dl>\n") + drawing +
         "<h3>Assumptions and warnings</h3>\n" + foundations_html(all) +
         "<table class=\"sign\">\n<thead><tr><td></td><th scope=\"col\">Name</th><th scope=\"col\">Date</th>"
         "<th scope=\"col\">Signature</th></tr></thead>\n<tbody>\n" +
         signatures + "</tbody></table>\n" +
         fmt::format("<p class=\"default\">prs {}, {}; SHA-256 of the case <span class=\"mono\">{}</span></p>\n",
                     html(kVersion), all.date, all.origin.input_sha256);
}

std::string warning_list(const Findings& all, bool assumptions) {
  const std::vector<WarningGroup> groups = grouped(selected(all.warnings, assumptions));
  if (groups.empty()) return {};
  std::string text = "<ul class=\"warnings\">\n";
  for (const WarningGroup& warning : groups)
    text += fmt::format("<li>{}{}</li>\n", prose_html(warning.text()),
                        warning.cases.empty() ? "" : fmt::format(" <small>{}</small>", prose_html(warning.where())));
  return text + "</ul>\n";
}

}  // namespace prs
