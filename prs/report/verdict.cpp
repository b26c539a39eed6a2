#include <fmt/format.h>

#include <algorithm>
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

enum class Pick { range, largest, smallest, above_one /* the largest, where it is not 1 */ };

/// A number of the verdict: the first of the paths that has any.
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
      {"Axial stiffness", Pick::range, {{Command::solve, "load_cases[].axial_stiffness_N_per_um"}}},
      {"Peak pressure, screw",
       Pick::largest,
       {{Command::solve, "load_cases[].screw.peak_pressure_MPa[]"},
        {Command::contact, "load_cases[].screw.peak_pressure_MPa[]"}}},
      {"Peak pressure, nut",
       Pick::largest,
       {{Command::solve, "load_cases[].nut.peak_pressure_MPa[]"},
        {Command::contact, "load_cases[].nut.peak_pressure_MPa[]"}}},
      {"Static safety",
       Pick::smallest,
       {{Command::life, "life.static_safety"},
        {Command::measures, "load_cases[].measures.static_safety"}}},
      {"Life under the loads", Pick::smallest, {{Command::life, "life.system.l10_hours"}}},
      {"Life under the loads",
       Pick::smallest,
       {{Command::life, "life.system.l10_travel_km"},
        {Command::measures, "load_cases[].measures.l10_travel_km"}}},
      {"Efficiency", Pick::range, {{Command::slip, "load_cases[].slip.efficiency"}}},
      {"Power lost", Pick::range, {{Command::slip, "load_cases[].slip.power_loss_W"}}},
      {"Temperature, screw",
       Pick::largest,
       {{Command::slip, "heat_cycle.peak_degC.screw"},
        {Command::slip, "load_cases[].heat.temperature_degC.screw"}}},
      {"Temperature, rollers",
       Pick::largest,
       {{Command::slip, "heat_cycle.peak_degC.rollers"},
        {Command::slip, "load_cases[].heat.temperature_degC.rollers"}}},
      {"Temperature, nut",
       Pick::largest,
       {{Command::slip, "heat_cycle.peak_degC.nut"},
        {Command::slip, "load_cases[].heat.temperature_degC.nut"}}},
      {"Overload of a thread, screw",
       Pick::above_one,
       {{Command::solve, "load_cases[].screw.overload_factor"}}},
      {"Overload of a thread, nut",
       Pick::above_one,
       {{Command::solve, "load_cases[].nut.overload_factor"}}},
      {"Lost motion", Pick::largest, {{Command::preload, "preload.lost_motion_um"}}},
      {"Dynamic capacity", Pick::largest, {{Command::measures, "measures.dynamic_capacity_N"}}},
      {"Backlash, screw", Pick::largest, {{Command::contact, "contact.screw.backlash_mm"}}},
      {"Backlash, nut", Pick::largest, {{Command::contact, "contact.nut.backlash_mm"}}},
  };
  return all;
}

/// A number of the verdict as it is shown, in HTML.
struct Tile {
  std::string value, unit, where;
  Command command;
};

std::optional<Tile> tile_of(const Findings& all, const Headline& headline) {
  for (const auto& [command, path] : headline.places) {
    const CommandAnswer* answer = all.answer(command);
    std::vector<Found> found;
    if (answer) collect(answer->document, path, "", found);
    if (found.empty()) continue;
    const ReportUnit unit = report_unit(path, unit_in(path));
    for (Found& one : found) one.value *= unit.factor;
    const auto [least, most] =
        std::ranges::minmax_element(found, {}, [](const Found& f) { return f.value; });
    const Found& one = headline.pick == Pick::smallest ? *least : *most;
    Tile tile{report_number(one.value, unit.text), unit.text, one.where, command};
    if (headline.pick == Pick::above_one && tile.value == report_number(1.0, "")) return {};
    if (headline.pick == Pick::range)
      if (const std::string low = report_number(least->value, unit.text); low != tile.value) {
        tile.value = low + " … " + tile.value;
        tile.where = fmt::format("{} load cases", found.size());
      }
    return tile;
  }
  return {};
}

std::string tile_html(const Findings& all, const Headline& headline) {
  const std::optional<Tile> tile = tile_of(all, headline);
  if (!tile) return {};
  const auto number = [](const Tile& t) {
    return t.value + (t.unit.empty() ? "" : fmt::format(" <small>{}</small>", html(t.unit)));
  };
  const std::optional<Tile> before = all.before ? tile_of(*all.before, headline) : std::nullopt;
  const bool moved = before && before->value != tile->value;
  const bool stays = all.unmoved.contains(tile->command);
  return fmt::format(
      "<div data-tile=\"{}\"{}><dt>{}</dt><dd><div class=\"value\">{}</div>{}"
      "<div class=\"where\">{}</div></dd></div>\n",
      &headline - headlines().data(), stays ? " class=\"stale\"" : "", headline.title,
      number(*tile),
      moved ? fmt::format("<div class=\"before\">report: {}</div>", number(*before)) : "",
      stays ? "does not follow the load cases" : html(tile->where));
}

/// How many load cases of a document have an answer.
std::pair<std::size_t, std::size_t> converged_cases(const Json& document) {
  std::size_t good = 0, count = 0;
  for (const Json& load_case : under(document, "load_cases")) {
    ++count;
    good += load_case.value("converged", true) ? 1 : 0;
  }
  return {good, count};
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
  std::string text, tiles;
  if (const CommandAnswer* solve = all.answer(Command::solve)) {
    const auto [good, count] = converged_cases(solve->document);
    text += good == count ? fmt::format("<span class=\"state good\">{} load case{} solved.</span> ",
                                        count, count == 1 ? "" : "s")
                          : fmt::format(
                                "<span class=\"state bad\">{} of {} load cases did not "
                                "converge.</span> ",
                                count - good, count);
  }
  for (const CommandAnswer& answer : all.answers)
    if (!answer.delivery.converged && answer.command != Command::solve)
      text += fmt::format("<span class=\"state bad\">{} did not converge.</span> ",
                          capitalised(std::string(name(answer.command))));
  text += all.warnings.empty()
              ? "<span>No warnings.</span>"
              : fmt::format("<a href=\"#warnings\">{} warning{}.</a>", all.warnings.size(),
                            all.warnings.size() == 1 ? "" : "s");
  for (const Headline& headline : headlines()) tiles += tile_html(all, headline);
  if (!tiles.empty()) tiles = "<dl class=\"tiles\">\n" + tiles + "</dl>\n";
  return "<p>" + text + "</p>\n" + tiles;
}

std::string warning_list(const Findings& all) {
  if (all.warnings.empty()) return {};
  std::string text = "<ul class=\"warnings\">\n";
  for (const ReportWarning& warning : all.warnings)
    text += fmt::format("<li>{}{}</li>\n", html(in_table_units(warning.text)),
                        warning.cases.empty() ? ""
                                              : fmt::format(" <small>in {}</small>",
                                                            html(folded_names(warning.cases))));
  return text + "</ul>\n";
}

}  // namespace prs
