#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "prs/output/table_units.h"
#include "prs/quantities/case_groups.h"
#include "prs/report/findings.h"
#include "prs/report/svg.h"
#include "prs/report/tables.h"
#include "prs/text.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

// The numbers at a path of a document, `load_cases[].screw.peak_pressure_MPa[]`.

struct Found {
  double value;
  std::string where;  ///< The name of the load case.
};

void collect(const Json& json, std::string_view path, const std::string& where,
             std::vector<Found>& found) {
  if (path.empty()) {
    if (json.is_number()) found.push_back({json.get<double>(), where});
    return;
  }
  if (path.starts_with("[]")) {
    path.remove_prefix(2);
    if (!json.is_array()) return;
    const std::string_view rest = path.starts_with('.') ? path.substr(1) : path;
    for (const Json& entry : json)
      if (entry.is_array())
        collect(entry, "[]", where, found);
      else
        collect(
            entry, rest,
            entry.is_object() && entry.contains("name") ? entry["name"].get<std::string>() : where,
            found);
    return;
  }
  const std::size_t end = std::min(path.find('.'), path.find('['));
  const std::string key(path.substr(0, end));
  if (!json.is_object() || !json.contains(key)) return;
  path.remove_prefix(std::min(end, path.size()));
  if (path.starts_with('.')) path.remove_prefix(1);
  collect(json[key], path, where, found);
}

enum class Pick { largest, above_one /* the largest, where it is not 1 */ };

/// A number shown beside the verdict that has no limit. It is taken from the first of the places
/// that holds one.
struct Headline {
  const char* title;
  Pick pick;
  struct Place {
    Command command;
    const char* path;
  };
  std::vector<Place> places;
};

const std::vector<Headline>& headlines() {
  static const std::vector<Headline> all = {
      {"Power lost", Pick::largest, {{Command::slip, "load_cases[].slip.power_loss_W"}}},
      {"Overload of a thread, screw",
       Pick::above_one,
       {{Command::solve, "load_cases[].screw.overload_factor"}}},
      {"Overload of a thread, nut",
       Pick::above_one,
       {{Command::solve, "load_cases[].nut.overload_factor"}}},
      {"Lost motion", Pick::largest, {{Command::preload, "preload.lost_motion_um"}}},
      {"Dynamic capacity", Pick::largest, {{Command::measures, "measures.dynamic_capacity_N"}}},
  };
  return all;
}

/// What a document has at a path. A duty cycle has temperatures of its own, and with them losses:
/// the power lost is then the mean over the cycle.
std::vector<Found> found_at(const Json& document, std::string_view path) {
  std::vector<Found> found;
  const Json& cycle = under(document, "heat_cycle");
  if (!path.ends_with("power_loss_W") || cycle.is_null()) {
    collect(document, path, "", found);
  } else if (cycle.contains("energy_lost_J")) {
    found.push_back({cycle["energy_lost_J"].get<double>() / cycle["period_s"].get<double>(),
                     "heat.duty: mean over the cycle"});
  }
  return found;
}

/// A number as it is shown, in HTML.
struct Tile {
  std::string value, unit, where;
  Command command;
};

std::optional<Tile> tile_of(const Findings& all, const Headline& headline) {
  for (const auto& [command, path] : headline.places) {
    const CommandAnswer* answer = all.answer(command);
    std::vector<Found> found;
    if (answer) found = found_at(answer->document, path);
    if (found.empty()) continue;
    const ReportUnit unit = report_unit(path, unit_in(path));
    for (Found& one : found) one.value *= unit.factor;
    const Found& one = *std::ranges::max_element(found, {}, &Found::value);
    Tile tile{report_number(one.value, unit.text), unit.text, one.where, command};
    if (headline.pick == Pick::above_one && tile.value == report_number(1.0, "")) return {};
    return tile;
  }
  return {};
}

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

std::string headline_html(const Findings& all, const Headline& headline) {
  const std::optional<Tile> tile = tile_of(all, headline);
  if (!tile) return {};
  const auto number = [](const Tile& t) { return number_html(t.value, t.unit); };
  const std::optional<Tile> before = all.before ? tile_of(*all.before, headline) : std::nullopt;
  const bool stays = all.unmoved.contains(tile->command);
  return tile_html(headline.title, stays ? kStale : "", headline.title, number(*tile),
                   before ? number(*before) : "", where_html(stays ? kStays : tile->where));
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
  const CommandAnswer* slip = all.answer(Command::slip);
  return slip && slip->document.contains("heat_cycle");
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
  if (const CommandAnswer* solve = all.answer(Command::solve)) {
    const Json& cases = under(solve->document, "load_cases");
    const auto failed = std::ranges::count_if(
        cases, [](const Json& load_case) { return !load_case.value("converged", true); });
    const std::size_t count = cases.size();
    text += failed == 0 ? fmt::format("{} load case{} solved. ", count, count == 1 ? "" : "s")
                        : fmt::format(
                              "<span class=\"state red\">{} of {} load cases did not "
                              "converge.</span> ",
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
  for (const Headline& headline : headlines()) cards += headline_html(all, headline);
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
