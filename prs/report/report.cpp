#include "prs/report/report.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <optional>
#include <set>

#include "prs/figures/pictures.h"
#include "prs/output/run_files.h"
#include "prs/quantities/case_groups.h"
#include "prs/quantities/results_schema.h"
#include "prs/report/page.h"
#include "prs/report/svg.h"
#include "prs/report/tables.h"
#include "prs/run/commands.h"
#include "prs/text.h"
#include "prs/version.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostColumns = 6;  ///< Load cases side by side in a table.
/// Of files that the page carries [bytes]: with pictures and tables it stays below 2.5 MB.
constexpr std::size_t kMostFiles = 1'100'000;
constexpr std::size_t kMostPictures = 600'000;
constexpr std::size_t kMostData = 300'000;

/// What a command found.
struct Answer {
  Command command;
  Delivery delivery;
  Json document;
  Pictures pictures = {};
};

/// Files of a study or an optimization that was run before.
struct Stored {
  Command command;
  std::vector<OutputFile> files;
};

/// What the page is made of.
struct Findings {
  const input::Source& source;
  Json check;
  std::vector<Answer> answers;
  std::vector<Stored> studies;
  std::vector<std::string> notes;
  bool converged = true;
  int figures = 0;  ///< So many were drawn.

  const Answer* answer(Command command) const {
    const auto found = std::ranges::find(answers, command, &Answer::command);
    return found == answers.end() ? nullptr : &*found;
  }
};

/// What stands under a key; null where there is nothing.
const Json& under(const Json& json, const std::string& key) {
  static const Json none;
  const auto found = json.find(key);
  return found == json.end() ? none : *found;
}

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

enum class Pick { range, largest, smallest };

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
      {"Overload of a thread",
       Pick::largest,
       {{Command::solve, "load_cases[].screw.overload_factor"}}},
      {"Lost motion", Pick::largest, {{Command::preload, "preload.lost_motion_um"}}},
      {"Dynamic capacity", Pick::largest, {{Command::measures, "measures.dynamic_capacity_N"}}},
      {"Backlash, screw", Pick::largest, {{Command::contact, "contact.screw.backlash_mm"}}},
      {"Backlash, nut", Pick::largest, {{Command::contact, "contact.nut.backlash_mm"}}},
  };
  return all;
}

std::string unit_in(std::string_view path) {
  for (std::size_t dot = path.size(); dot != std::string_view::npos;
       dot = dot > 0 ? path.rfind('.', dot - 1) : std::string_view::npos) {
    std::string_view key = path.substr(dot < path.size() && path[dot] == '.' ? dot + 1 : dot);
    key = key.substr(0, key.find_first_of(".["));
    if (key.ends_with("_degC")) return "°C";
    if (const ShownUnit& unit = unit_of(key); !unit.text.empty()) return std::string(unit.text);
  }
  return {};
}

std::string tile(const Findings& all, const Headline& headline) {
  for (const auto& [command, path] : headline.places) {
    const Answer* answer = all.answer(command);
    std::vector<Found> found;
    if (answer) collect(answer->document, path, "", found);
    if (found.empty()) continue;
    const auto [least, most] =
        std::ranges::minmax_element(found, {}, [](const Found& f) { return f.value; });
    const std::string unit = unit_in(path);
    const Found& one = headline.pick == Pick::smallest ? *least : *most;
    std::string value = report_number(one.value, unit), where = one.where;
    if (headline.pick == Pick::range)
      if (const std::string low = report_number(least->value, unit); low != value) {
        value = low + " … " + value;
        where = fmt::format("{} load cases", found.size());
      }
    return fmt::format(
        "<div><dt>{}</dt><dd><div class=\"value\">{}{}</div>"
        "<div class=\"where\">{}</div></dd></div>\n",
        headline.title, value, unit.empty() ? "" : fmt::format(" <small>{}</small>", html(unit)),
        html(where));
  }
  return {};
}

// Warnings

struct Warning {
  std::string pattern;  ///< The text without its numbers.
  std::string text;
  std::vector<std::string> cases;
};

void add_warning(std::vector<Warning>& all, const std::string& text, const std::string& name) {
  std::string pattern = text;
  std::erase_if(pattern, [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
  auto found = std::ranges::find(all, pattern, &Warning::pattern);
  if (found == all.end()) found = all.insert(found, {pattern, text, {}});
  if (!name.empty() && std::ranges::find(found->cases, name) == found->cases.end())
    found->cases.push_back(name);
}

std::vector<Warning> warnings_of(const Findings& all) {
  std::vector<Warning> warnings;
  const auto take = [&](const Json& document) {
    for (const Json& text : under(document, "warnings"))
      add_warning(warnings, text.get<std::string>(), "");
    for (const Json& load_case : under(document, "load_cases"))
      for (const Json& text : under(load_case, "warnings"))
        add_warning(warnings, text.get<std::string>(), load_case.value("name", ""));
  };
  take(all.check);
  for (const Answer& answer : all.answers) take(answer.document);
  return warnings;
}

std::string warning_list(const std::vector<Warning>& warnings) {
  if (warnings.empty()) return {};
  std::string text = "<ul class=\"warnings\">\n";
  for (const Warning& warning : warnings)
    text += fmt::format("<li>{}{}</li>\n", html(warning.text),
                        warning.cases.empty() ? ""
                                              : fmt::format(" <small>in {}</small>",
                                                            html(folded_names(warning.cases))));
  return text + "</ul>\n";
}

// Load cases

std::string base_name(const std::string& name) { return name.substr(0, name.rfind('[')); }

/// The load cases that tables show: of each range the first, the middle and the last; of many the
/// first few.
std::vector<RecordColumn> case_columns(const Json& document) {
  const Json& cases = under(document, "load_cases");
  std::vector<const Json*> chosen;
  for (const Json& load_case : cases) chosen.push_back(&load_case);
  if (chosen.size() > kMostColumns) {
    std::vector<const Json*> few;
    for (std::size_t first = 0; first < chosen.size();) {
      const std::string name = base_name(chosen[first]->value("name", ""));
      std::size_t last = first;
      while (last + 1 < chosen.size() && base_name(chosen[last + 1]->value("name", "")) == name)
        ++last;
      for (const std::size_t k : std::set{first, (first + last) / 2, last})
        few.push_back(chosen[k]);
      first = last + 1;
    }
    few.resize(std::min(few.size(), kMostColumns));
    chosen = std::move(few);
  }
  std::vector<RecordColumn> columns;
  for (const Json* load_case : chosen) columns.push_back({load_case->value("name", ""), load_case});
  return columns;
}

std::string case_table_html(const Json& document, const RecordChoice& choice) {
  const std::vector<RecordColumn> columns = case_columns(document);
  const std::size_t count = under(document, "load_cases").size();
  std::string text = record_table(*record_at("load_cases[]"), columns, choice);
  if (!text.empty() && columns.size() < count)
    text += fmt::format("<p class=\"default\">{} of {} load cases; the files have all.</p>\n",
                        columns.size(), count);
  return text;
}

// Pictures

std::string figure_html(Findings& all, const Figure& figure, bool narrow = false) {
  return fmt::format(
      "<figure{}><figcaption>{}</figcaption><div class=\"wide\" tabindex=\"0\">{}"
      "</div></figure>\n",
      narrow ? " class=\"narrow\"" : "", html(figure.title),
      svg(figure, fmt::format("p{}", ++all.figures)));
}

/// Those of an answer that a command draws, by a condition on their names; of what shows one load
/// case, one for each of several.
template <class Choose>
std::string pictures_html(Findings& all, const Answer* answer, const Choose& choose) {
  std::string text;
  if (!answer) return text;
  for (const Picture& picture : answer->pictures)
    if (picture.is_drawn && choose(picture.name))
      for (const Figure& figure : picture.make({})) text += figure_html(all, figure);
  return text;
}

/// One by its name for each of the first load cases that it exists for.
std::string each_case_html(Findings& all, const Answer& answer, std::string_view name,
                           bool narrow) {
  constexpr std::size_t kMost = 4;
  const auto picture = std::ranges::find(answer.pictures, name, &Picture::name);
  if (picture == answer.pictures.end()) return {};
  const std::size_t count = under(answer.document, "load_cases").size();
  std::string text;
  for (std::size_t k = 0; k < std::min(kMost, count); ++k)
    for (const Figure& figure : picture->make({.load_case = k}))
      text += figure_html(all, figure, narrow);
  return text;
}

/// Whether it shows more than single points.
bool has_curve(const Figure& figure) {
  return std::ranges::any_of(figure.panels, [](const Panel& panel) {
    return std::ranges::any_of(panel.series, [](const Series& series) {
      return std::ranges::any_of(series.parts, [](const Polyline& p) { return p.size() > 1; });
    });
  });
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}
bool is_of_stiffness(std::string_view name) {
  return is_one_of(name, {"stiffness", "displacement"});
}
bool is_of_pressure(std::string_view name) {
  return is_one_of(name, {"peak_pressure", "ellipses"});
}
bool is_of_solution(std::string_view name) { return name == "convergence"; }
bool is_of_rollers(std::string_view name) {
  return is_one_of(name, {"roller_loads", "roller_shares"});
}

// Sections

bool is_full(const Findings& all) {
  const Json& input = all.check["resolved_input"];
  return input.contains("model") && input["model"].value("mechanism", "") == "full";
}

std::string input_value(const Findings& all, std::string_view path) {
  for (const Json& entry : all.check["input"])
    if (entry["path"] == path) return entry["value"].get<std::string>();
  return {};
}

std::string head_html(const Findings& all, const std::string& title) {
  const Json& diameters = all.check["contact"]["pitch_diameter_mm"];
  const auto diameter = [&](const char* part) {
    return report_number(diameters.value(part, std::numeric_limits<double>::quiet_NaN()), "mm");
  };
  const std::string starts = input_value(all, "mechanism.starts.screw");
  return fmt::format(
      "<p class=\"eyebrow\">Planetary roller screw · report</p>\n<h1>{}</h1>\n<p class=\"lead\">{} "
      "mechanism, {} rollers with {} threads each. Lead {}, {} start{} on the screw. Pitch "
      "diameters: screw {} mm, roller {} mm, nut {} mm.</p>\n",
      html(title), html(capitalised(input_value(all, "mechanism.type"))),
      html(input_value(all, "mechanism.rollers")),
      html(input_value(all, "mechanism.contacts_per_roller")),
      html(input_value(all, "mechanism.lead")), html(starts), starts == "1" ? "" : "s",
      diameter("screw"), diameter("roller"), diameter("nut"));
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

std::string verdict_html(const Findings& all, const std::vector<Warning>& warnings) {
  std::string text, tiles;
  if (const Answer* solve = all.answer(Command::solve)) {
    const auto [good, count] = converged_cases(solve->document);
    text += good == count ? fmt::format("<span class=\"state good\">{} load case{} solved.</span> ",
                                        count, count == 1 ? "" : "s")
                          : fmt::format(
                                "<span class=\"state bad\">{} of {} load cases did not "
                                "converge.</span> ",
                                count - good, count);
  }
  for (const Answer& answer : all.answers)
    if (!answer.delivery.converged && answer.command != Command::solve)
      text += fmt::format("<span class=\"state bad\">{} did not converge.</span> ",
                          capitalised(std::string(name(answer.command))));
  text += warnings.empty() ? "<span>No warnings.</span>"
                           : fmt::format("<a href=\"#warnings\">{} warning{}.</a>", warnings.size(),
                                         warnings.size() == 1 ? "" : "s");
  for (const Headline& headline : headlines()) tiles += tile(all, headline);
  if (!tiles.empty()) tiles = "<dl class=\"tiles\">\n" + tiles + "</dl>\n";
  return "<p>" + text + "</p>\n" + tiles;
}

const Answer* most_complete(const Findings& all) {
  const Answer* solve = all.answer(Command::solve);
  return solve ? solve : all.answer(Command::contact);
}

std::string mechanism_html(Findings& all) {
  const Answer* answer = most_complete(all);
  if (!answer) return {};
  const auto draw = [&](const char* name) {
    return figure_html(all, figure(answer->pictures, name, {}));
  };
  std::string text = draw("section");
  return is_full(all) ? text + each_case_html(all, *answer, "end_view", false)
                      : text + draw("end_view");
}

/// Stiffness and pressure of each model, a row per load case.
std::string comparison_html(const Json& document) {
  const Json& comparison = document["comparison"];
  std::vector<std::string> head{"Load case",        "Model",
                                "Stiffness, N/µm",  "Displacement, µm",
                                "Largest share, %", "Peak pressure, MPa"};
  std::vector<std::vector<std::string>> rows;
  constexpr std::size_t kMost = 12;
  const std::size_t count = comparison["load_cases"].size();
  const std::size_t stride = count > kMost ? (count + kMost - 1) / kMost : 1;
  for (std::size_t k = 0; k < count; k += stride)
    for (const Json& model : comparison["load_cases"][k]["models"]) {
      const auto number = [&](const char* key, const char* unit) {
        return model.contains(key) ? report_value(model[key], unit) : "–";
      };
      double share = std::numeric_limits<double>::quiet_NaN();
      for (const char* side : {"screw", "nut"})
        if (model.contains(side))
          share = std::fmax(share, model[side].value("largest_load_rate_percent", share));
      rows.push_back({html(comparison["load_cases"][k].value("name", "")),
                      html(model.value("bodies", "")), number("axial_stiffness_N_per_um", "N/µm"),
                      number("axial_displacement_um", "µm"),
                      std::isfinite(share) ? report_number(share, "%") : "–",
                      number("largest_peak_pressure_MPa", "MPa")});
    }
  return "<h3>The models side by side</h3>\n" + plain_table(head, rows, true);
}

/// What a load case has of stiffness, in a section of its own.
std::vector<std::string> keys_of_stiffness() {
  return {"axial_displacement_um", "axial_stiffness_N_per_um", "tangent_stiffness_N_per_um"};
}

/// What tables of loads leave to other sections.
std::vector<std::string> without_of_loads() {
  std::vector<std::string> keys = keys_of_stiffness();
  for (const char* key : {"name", "converged", "iterations"}) keys.emplace_back(key);
  return keys;
}

/// Curves over loads, as far as there are any, and the numbers.
std::string stiffness_html(Findings& all) {
  const Answer* solve = all.answer(Command::solve);
  if (!solve) return {};
  std::string text;
  for (const Picture& picture : solve->pictures)
    if (is_of_stiffness(picture.name))
      for (const Figure& figure : picture.make({}))
        if (has_curve(figure)) text += figure_html(all, figure);
  std::vector<std::string> only = keys_of_stiffness();
  only.insert(only.begin(), "axial_force_N");
  return text + case_table_html(solve->document, {.only = only});
}

std::string loads_html(Findings& all) {
  const Answer* solve = all.answer(Command::solve);
  if (!solve) return {};
  std::string text = pictures_html(all, solve, [](std::string_view name) {
    return !is_of_stiffness(name) && !is_of_pressure(name) && !is_of_solution(name) &&
           !is_of_rollers(name);
  });
  if (is_full(all)) {
    text += each_case_html(all, *solve, "roller_loads", false);
    text += each_case_html(all, *solve, "roller_shares", true);
  }
  text +=
      "<h3>Load cases</h3>\n" + case_table_html(solve->document, {.without = without_of_loads()});
  if (const Answer* compare = all.answer(Command::compare))
    text += pictures_html(all, compare, [](std::string_view) { return true; }) +
            comparison_html(compare->document);
  return text;
}

/// The records of a document that are its own, and what its load cases have besides those of
/// `solve`.
std::string document_html(const Findings& all, const Answer& answer) {
  std::string text;
  for (const auto& [key, value] : answer.document.items())
    if (const RecordInfo* info = record_at(key);
        info && value.is_object() && !is_one_of(key, {"contact", "threads", "comparison"}))
      text += record_table(*info, {{"", &value}});
  RecordChoice choice{.without = {"name"}};
  const Answer* solve = all.answer(Command::solve);
  static const Json none;
  if (const Json& known = solve ? under(solve->document, "load_cases") : none; !known.empty())
    for (const auto& [key, value] : known.front().items()) choice.without.push_back(key);
  return case_table_html(answer.document, choice) + text;
}

std::string answer_html(Findings& all, Command command) {
  const Answer* answer = all.answer(command);
  if (!answer) return {};
  return pictures_html(all, answer, [](std::string_view) { return true; }) +
         document_html(all, *answer);
}

std::string contact_html(Findings& all) {
  const Answer* answer = all.answer(Command::contact);
  if (!answer || !answer->document.contains("contact")) return {};
  const Json& contact = answer->document["contact"];
  const RecordInfo& info = *record_at("contact");
  std::string text = pictures_html(all, answer, [](std::string_view) { return true; });
  std::vector<RecordColumn> sides;
  for (const char* side : {"screw", "nut"})
    if (contact.contains(side)) sides.push_back({fmt::format("roller-{}", side), &contact[side]});
  if (const RecordInfo* side = record_in(info, "screw"); side && !sides.empty())
    text += record_table(*side, sides);
  return text + record_table(info, {{"", &contact}}, {.without = {"screw", "nut"}});
}

std::string inputs_html(const Findings& all) {
  std::vector<std::vector<std::string>> rows;
  std::string block;
  std::size_t defaults = 0;
  for (const Json& entry : all.check["input"]) {
    const std::string path = entry["path"];
    if (const std::string own = path.substr(0, path.find_first_of(".["));
        std::exchange(block, own) != own)
      rows.push_back({html(own)});
    const bool is_default = entry.value("default", false);
    defaults += is_default ? 1 : 0;
    const std::string origin = entry.value("origin", "default");
    rows.push_back(
        {fmt::format("<code>{}</code>", html(path)), html(entry["value"].get<std::string>()),
         is_default ? fmt::format("<span class=\"default\">{}</span>", html(origin)) : "given"});
  }
  std::string text = fmt::format(
      "<p>Every value of the case, {} of them defaults that the file does not state.</p>\n",
      defaults);
  text += plain_table({"Input", "Value", "Origin"}, rows);
  std::vector<std::vector<std::string>> derived;
  for (const auto& [key, value] : under(all.check, "derived").items())
    derived.push_back({html(capitalised(words_of(key))), report_value(value, unit_of(key).text),
                       html(unit_of(key).text)});
  if (!derived.empty())
    text += "<h3>What follows from them</h3>\n" + plain_table({"", "Value", "Unit"}, derived);
  return text;
}

/// Variables and responses of the design in the file and of the chosen one.
std::string optimization_html(const Json& document) {
  if (!document.contains("initial") || !document.contains("compromise")) return {};
  const Json& before = document["initial"];
  const Json& after = document["compromise"];
  std::vector<std::vector<std::string>> rows;
  const auto number_of = [](const Json& design, const char* block, const std::string& key) {
    return design.contains(block) && design[block].contains(key) ? design[block][key] : Json();
  };
  for (const char* block : {"variables", "responses"})
    for (const auto& [path, value] : under(after, block).items()) {
      const auto shown = [&](const Json& v) {
        return v.is_object() ? html(v.value("value", "")) : report_value(v, unit_in(path));
      };
      rows.push_back({html(path), shown(number_of(before, block, path)), shown(value)});
    }
  return plain_table({"", "In the file", "Chosen"}, rows, true);
}

std::string studies_html(Findings& all) {
  std::string text;
  std::size_t room = kMostPictures;
  for (const Stored& study : all.studies) {
    text +=
        fmt::format("<h3>{}</h3>\n", study.command == Command::study ? "Study" : "Optimization");
    std::size_t left_out = 0;
    for (const OutputFile& file : study.files) {
      if (file.name.ends_with(".json") && study.command == Command::optimize)
        if (const Json document = Json::parse(file.content, nullptr, false); document.is_object())
          text += optimization_html(document);
      if (!file.name.ends_with(".svg")) continue;
      if (file.content.size() > room) {
        ++left_out;
        continue;
      }
      room -= file.content.size();
      const std::string title = file.name.substr(file.name.rfind('/') + 1);
      text += fmt::format("<figure><div class=\"wide\" tabindex=\"0\">{}</div></figure>\n",
                          embedded_svg(file.content, title.substr(0, title.rfind('.'))));
    }
    if (left_out > 0)
      text += fmt::format(
          "<p class=\"default\">{} more picture{} stand{} in the folder of the "
          "results.</p>\n",
          left_out, left_out == 1 ? "" : "s", left_out == 1 ? "s" : "");
  }
  return text;
}

/// How each load case was solved, and where all comes from.
std::string provenance_html(Findings& all, const ReportOptions& options, const std::string& date) {
  const Json& check = all.check;
  std::string text = "<dl class=\"facts\">\n";
  const auto fact = [&](const char* title, const std::string& value) {
    if (!value.empty()) text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", title, value);
  };
  fact("Program", fmt::format("prs {}", html(kVersion)));
  fact("Date", date);
  fact("Command", fmt::format("<code>{}</code>", html(options.command)));
  fact("Case", fmt::format("<code>{}</code>", html(all.source.name)));
  fact("SHA-256 of the case", fmt::format("<code>{}</code>", check.value("input_sha256", "")));
  std::string overrides;
  for (const std::string& text_of : all.source.overrides)
    overrides += fmt::format("{}<code>{}</code>", overrides.empty() ? "" : ", ", html(text_of));
  fact("Changed by --set", overrides);
  fact("Schema of the input", html(check.value("schema_version", "")));
  const Answer* solve = all.answer(Command::solve);
  if (solve && solve->document.contains("model")) {
    const Json& model = solve->document["model"];
    fact("Model of the bodies", html(model.value("bodies", "")));
    fact("What the model means", html(model.value("note", "")));
  }
  text += "</dl>\n";
  if (solve) {
    text += "<h3>How the load cases were solved</h3>\n" +
            case_table_html(solve->document, {.without = {"name"}, .reach = Reach::document});
    text += pictures_html(all, solve, is_of_solution);
  }
  return text;
}

/// Each file once, small ones first, as far as there is room.
std::string files_html(Findings& all) {
  std::vector<OutputFile> files;
  const auto add = [&](OutputFile file) {
    if (std::ranges::find(files, file.name, &OutputFile::name) == files.end())
      files.push_back(std::move(file));
  };
  for (const Answer& answer : all.answers)
    if (answer.delivery.files)
      for (OutputFile& file : answer.delivery.files({})) add(std::move(file));
  for (const Stored& study : all.studies)
    for (const OutputFile& file : study.files)
      if (file.name.ends_with(".csv")) add(file);
  if (files.empty()) return {};
  std::vector<std::size_t> order(files.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return files[k].content.size(); });
  std::size_t room = kMostFiles;
  std::set<std::size_t> carried;
  for (const std::size_t k : order)
    if (files[k].content.size() <= room) {
      room -= files[k].content.size();
      carried.insert(k);
    }
  std::string links, absent;
  for (std::size_t k = 0; k < files.size(); ++k)
    if (carried.contains(k))
      links +=
          fmt::format("<li>{}</li>\n", download_link(files[k].name, "text/csv", files[k].content));
    else
      absent += (absent.empty() ? "" : ", ") + files[k].name;
  std::string text =
      "<p>Every number behind the tables and pictures, as CSV.</p>\n"
      "<ul class=\"files\">\n" +
      links + "</ul>\n";
  if (!absent.empty()) {
    text += fmt::format(
        "<p>Too large for this page: {}. The commands write them with "
        "<code>--output DIR</code>.</p>\n",
        html(absent));
    all.notes.push_back(fmt::format("too large for the page: {}", absent));
  }
  return text;
}

// The whole

/// SOURCE_DATE_EPOCH where it is set, so that the same case gives the same bytes.
std::string date_of_report() {
  std::time_t now = std::time(nullptr);
  if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH")) {
    char* end = nullptr;
    const long long seconds = std::strtoll(fixed, &end, 10);
    if (end != fixed && *end == '\0') now = static_cast<std::time_t>(seconds);
  }
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(now));
}

constexpr Command kReported[] = {Command::contact, Command::solve, Command::compare, Command::slip,
                                 Command::preload, Command::life,  Command::measures};

Findings find(const input::Source& source, const ReportOptions& options) {
  const input::CaseInput in = input::read_case_input(source, Command::check);
  const CommandRow& check = row_of(Command::check);
  Findings all{
      source, check.run(source, in).document(document_info(source, Command::check)), {}, {}, {}};
  for (const Command command : kReported) {
    if (!input::missing(in, command).empty()) continue;
    try {
      Answer answer{command, run(row_of(command), source), {}};
      answer.document = answer.delivery.document(document_info(source, command));
      answer.document.erase("resolved_input");
      if (answer.delivery.pictures) answer.pictures = answer.delivery.pictures();
      all.converged = all.converged && answer.delivery.converged;
      all.answers.push_back(std::move(answer));
    } catch (const input::InputError& error) {
      all.notes.push_back(fmt::format("{} was not computed: {}", name(command), error.what()));
    }
  }
  for (const Command command : {Command::study, Command::optimize})
    for (const std::filesystem::path& folder : options.results) {
      Stored study{command, files_of_run(folder, name(command), source)};
      if (study.files.empty()) continue;
      all.studies.push_back(std::move(study));
      break;
    }
  return all;
}

/// All documents, but those that are too long for the page.
Json data_of(const Findings& all, const std::string& date, std::size_t most) {
  Json data{{"prs_version", kVersion}, {"date", date}};
  for (const char* key : {"schema_version", "case_file", "input_sha256", "resolved_input"})
    if (all.check.contains(key)) data[key] = all.check[key];
  data["overrides"] = all.source.overrides;
  data["results"] = Json::object();
  for (const Answer& answer : all.answers)
    if (most == 0 ||
        answer.document.dump(-1, ' ', false, Json::error_handler_t::replace).size() <= most)
      data["results"][std::string(name(answer.command))] = answer.document;
  return data;
}

}  // namespace

Report make_report(const input::Source& source, const ReportOptions& options) {
  Findings all = find(source, options);
  const std::string date = date_of_report();
  const std::string title = std::filesystem::path(source.name).stem().string();
  const std::vector<Warning> warnings = warnings_of(all);
  std::string refused;
  for (const std::string& note : all.notes) refused += fmt::format("<p>{}</p>\n", html(note));

  Page page;
  page.title = fmt::format("{} · planetary roller screw", title);
  page.head = head_html(all, title);
  page.sections = {
      {"verdict", "Verdict", verdict_html(all, warnings)},
      {"mechanism", "Mechanism", mechanism_html(all)},
      {"loads", "Load distribution", loads_html(all)},
      {"stiffness", "Stiffness", stiffness_html(all)},
      {"pressures", "Pressures", pictures_html(all, all.answer(Command::solve), is_of_pressure)},
      {"slip", "Slip and losses", answer_html(all, Command::slip)},
      {"preload", "Preload", answer_html(all, Command::preload)},
      {"life", "Life", answer_html(all, Command::life)},
      {"measures", "Design measures", answer_html(all, Command::measures)},
      {"contacts", "Contacts", contact_html(all)},
      {"studies", "Studies", studies_html(all)},
      {"warnings", "Warnings", warning_list(warnings) + refused},
      {"inputs", "Inputs and assumptions", inputs_html(all)},
      {"data", "Data", files_html(all)},
      {"provenance", "Provenance", provenance_html(all, options, date)},
  };
  page.foot = fmt::format(
      "<p>Made by prs {} on {}. SHA-256 of the case: <span class=\"mono\">{}"
      "</span></p>",
      html(kVersion), date, all.check.value("input_sha256", ""));
  page.data = data_of(all, date, kMostData).dump(-1, ' ', false, Json::error_handler_t::replace);
  return {page_html(page), data_of(all, date, 0), all.notes, all.converged};
}

}  // namespace prs
