#include "prs/loads/case_groups.h"
#include "prs/record/table_units.h"
#include "prs/report/findings.h"
#include "prs/report/svg.h"
#include "prs/report/tables.h"
#include "prs/text.h"

namespace prs {
namespace {

std::string number_html(const std::string& value, std::string_view unit) {
  return value + (unit.empty() ? "" : fmt::format(" <small>{}</small>", html(unit)));
}

/// Also where a page moved values away from those of the report.
std::string tile_html(std::string_view key, std::string_view classes, std::string_view title,
                      const std::string& number, const std::string& before,
                      const std::string& below) {
  return fmt::format(
      "<div data-tile=\"{}\"{}><dt>{}</dt><dd><div class=\"value\">{}</div>{}{}</dd></div>\n", key,
      classes.empty() ? "" : fmt::format(" class=\"{}\"", classes), html(title), number,
      before.empty() || before == number
          ? ""
          : fmt::format("<div class=\"before\">report: {}</div>", before),
      below);
}

std::string where_html(std::string_view text) {
  return fmt::format("<div class=\"where\">{}</div>", html(text));
}

// Numbers that keep their load while a page moves that of the load cases.
constexpr std::string_view kStale = "stale", kStays = "does not follow the load cases";

std::string shown(const Headline& headline) {
  const ShownUnit& unit = unit_of(headline.key);
  const ReportUnit of_page = report_unit(headline.key, unit.text);
  return number_html(report_number(headline.value * unit.factor * of_page.factor, of_page.text),
                     of_page.text);
}

std::string headlines_html(const Findings& all) {
  std::string tiles;
  for (const CommandAnswer& answer : all.answers) {
    if (!answer.delivery.headlines) continue;
    const CommandAnswer* other = all.before ? all.before->answer(answer.command) : nullptr;
    const std::vector<Headline> before =
        other ? other->delivery.headlines() : std::vector<Headline>{};
    const bool stays = all.unmoved.contains(answer.command);
    for (const Headline& headline : answer.delivery.headlines()) {
      const auto same = std::ranges::find(before, headline.title, &Headline::title);
      tiles += tile_html(headline.title, stays ? kStale : "", headline.title, shown(headline),
                         same == before.end() ? "" : shown(*same),
                         where_html(stays ? kStays : headline.where));
    }
  }
  return tiles;
}

// Cards of the verdict.

/// In what the page shows value and limit.
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

/// Where the worst value stands, and the best where that is another one; none of efficiencies at
/// temperatures that a duty cycle does not reach.
std::string place_of(const Findings& all, const Criterion& c) {
  constexpr double kSame = 0.01;
  std::string where = c.load_case;
  if (!c.reason.empty()) where += (where.empty() ? "" : ": ") + c.reason;
  if (c.name == "efficiency" && has_cycle(all)) return where;
  if (c.standing == Standing::no_limit && c.best &&
      std::abs(*c.best - *c.value) > kSame * std::abs(*c.value)) {
    const ReportUnit unit = card_unit(c);
    where += fmt::format("; best {}", report_number(*c.best * unit.factor, unit.text));
  }
  return where;
}

std::string card_html(const Findings& all, const Criterion& c) {
  const auto [unit, factor] = card_unit(c);
  std::string below;
  if (c.limit)
    below += fmt::format("<div class=\"where\">{} {}{}{}, {}</div>",
                         c.sense == Sense::least ? "at least" : "at most",
                         report_number(*c.limit * factor, unit), unit.empty() ? "" : " ",
                         html(unit), html(origin(c)));
  std::string before;
  if (all.before)
    for (const Criterion& other : all.before->verdict.criteria)
      if (other.name == c.name) before = value_html(other);
  // Its worst load is one of `life`, in a spectrum or history of its own.
  if (c.load_case.starts_with("life.") && all.unmoved.contains(Command::life))
    return tile_html(c.name, kStale, c.title, value_html(c), before, where_html(kStays));
  if (c.limit)
    below += fmt::format("<div class=\"state {}\">{}</div>", name(c.standing), words(c.standing));
  return tile_html(c.name, name(c.standing), c.title, value_html(c), before,
                   below + where_html(place_of(all, c)));
}

}  // namespace

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
  std::string text = fmt::format("<span class=\"state {}\">{}</span> ", name(verdict.standing()),
                                 html(summary(verdict)));
  if (const Result* solve = all.result<Result>(Command::solve)) {
    const auto failed = std::ranges::count(solve->load_cases, false, &LoadCaseResult::converged);
    const std::size_t count = solve->load_cases.size();
    text +=
        failed == 0
            ? fmt::format("{} load case{} solved. ", count, count == 1 ? "" : "s")
            : fmt::format("<span class=\"state red\">{} of {} load cases did not converge.</span> ",
                          failed, count);
  }
  for (const CommandAnswer& answer : all.answers)
    if (!answer.delivery.converged && answer.command != Command::solve)
      text += fmt::format("<span class=\"state red\">{} did not converge.</span> ",
                          capitalised(std::string(name(answer.command))));
  if (all.warnings.empty()) text += "No warnings.";
  std::string cards;
  for (const Criterion& c : verdict.criteria)
    if ((c.value || c.limit) && c.name != "convergence") cards += card_html(all, c);
  cards += headlines_html(all);
  if (!cards.empty()) cards = "<dl class=\"tiles\">\n" + cards + "</dl>\n";
  const std::string rest = not_computed(verdict);
  if (!rest.empty()) cards += fmt::format("<p class=\"default\">No value: {}.</p>\n", html(rest));
  return "<p>" + text + "</p>\n" + cards;
}

std::string warning_list(const Findings& all) {
  if (all.warnings.empty()) return {};
  std::string text = "<ul class=\"warnings\">\n";
  for (const WarningGroup& warning : all.warnings)
    text += fmt::format(
        "<li>{}{}</li>\n", html(in_table_units(warning.text())),
        warning.cases.empty() ? "" : fmt::format(" <small>{}</small>", html(warning.where())));
  return text + "</ul>\n";
}

}  // namespace prs
