#include "prs/report/controls.h"

#include <charconv>

#include "prs/indices.h"
#include "prs/mechanism/full_distribution.h"
#include "prs/model/check_case.h"
#include "prs/record/table_layout.h"
#include "prs/report/requirement_page.h"
#include "prs/report/tables.h"
#include "prs/run/document_schema.h"
#include "prs/text.h"

namespace prs {
namespace {

using input::Source;

enum class Span { factor, about, whole };

/// An input that a page varies. `[]` in its path matches any item.
struct Control {
  const char* group;
  const char* path;
  const char* title;
  Span kind = Span::factor;
  double from = 0.5, to = 1.5;  ///< Ends over its value, or differences to it; from 0: not below 0.
  bool of_force = false;        ///< Whether it is a share of the axial force.
};

constexpr const char* kSpectrum = "life.spectrum[].force";
constexpr std::size_t kMostAtOnce = 100;  ///< Largest number of loads of a spectrum that one slider moves.
constexpr const char* kLoads = "Loads";
constexpr const char* kThreads = "Threads";
constexpr const char* kBodies = "Bodies";
constexpr const char* kErrors = "Errors of the parts";
constexpr const char* kRunning = "Running";

constexpr Control kControls[] = {
    {kLoads, "load_cases[].axial_force", "Axial force", Span::factor, 0.05, 2.0},
    {kLoads, "load_cases[].axial_force.to", "Largest axial force", Span::factor, 0.1, 2.0},
    {kLoads, kSpectrum, "Load of the life", Span::factor, 0.05, 2.0},
    {kLoads, "load_cases[].misalignment.nut_tilt.y", "Tilt of the nut about y", Span::about, -0.2, 0.2},
    {kLoads, "load_cases[].misalignment.nut_tilt.z", "Tilt of the nut about z", Span::about, -0.2, 0.2},
    {kLoads, "load_cases[].side_force.y", "Side force along y", Span::about, -0.1, 0.1, true},
    {kLoads, "load_cases[].side_force.z", "Side force along z", Span::about, -0.1, 0.1, true},
    {kLoads, "load_cases[].moment.y", "Moment about y", Span::about, -0.003, 0.003, true},
    {kLoads, "load_cases[].moment.z", "Moment about z", Span::about, -0.003, 0.003, true},
    {kLoads, "preload.force", "Preload", Span::factor, 0.1, 3.0},
    {kThreads, "mechanism.rollers", "Rollers", Span::whole, 0.4, 1.0},
    {kThreads, "mechanism.contacts_per_roller", "Threads of a roller", Span::whole, 0.3, 2.0},
    {kThreads, "mechanism.lead", "Lead"},
    {kThreads, "mechanism.flank_angle", "Flank angle", Span::factor, 0.7, 1.3},
    {kThreads, "mechanism.flank_angle.screw", "Flank angle, screw", Span::factor, 0.7, 1.3},
    {kThreads, "mechanism.flank_angle.roller", "Flank angle, roller", Span::factor, 0.7, 1.3},
    {kThreads, "mechanism.flank_angle.nut", "Flank angle, nut", Span::factor, 0.7, 1.3},
    {kThreads, "mechanism.profile.roller.convex", "Profile radius, roller", Span::factor, 0.5, 2.5},
    {kThreads, "mechanism.pitch_diameter.screw", "Pitch diameter, screw", Span::factor, 0.9, 1.1},
    {kThreads, "mechanism.backlash.screw", "Backlash, screw", Span::factor, 0.0, 3.0},
    {kThreads, "mechanism.backlash.nut", "Backlash, nut", Span::factor, 0.0, 3.0},
    {kBodies, "structure.screw.bore", "Bore of the screw", Span::factor, 0.0, 2.2},
    {kBodies, "structure.screw.free_length", "Free length of the screw", Span::factor, 0.0, 10.0},
    {kBodies, "structure.nut.length", "Length of the nut", Span::factor, 0.8, 1.6},
    {kBodies, "structure.nut.outer_diameter", "Diameter of the nut", Span::factor, 0.85, 1.5},
    {kBodies, "materials.youngs_modulus", "Young's modulus", Span::factor, 0.3, 1.5},
    {kErrors, "deviations.pitch_error.screw.linear", "Pitch error of the screw", Span::about, -0.004, 0.004},
    {kErrors, "deviations.pitch_error.nut.linear", "Pitch error of the nut", Span::about, -0.004, 0.004},
    {kErrors, "deviations.crowning", "Crowning of the rollers", Span::about, 0.0, 0.02},
    {kRunning, "operation.speed", "Speed", Span::factor, 0.02, 3.0},
    {kRunning, "load_cases[].speed", "Speed", Span::factor, 0.02, 3.0},
    {kRunning, "friction.model.coulomb", "Friction coefficient", Span::factor, 0.2, 2.0},
    {kRunning, "friction.model.mixed.boundary", "Boundary friction", Span::factor, 0.2, 2.0},
    {kRunning, "lubricant.temperature", "Temperature of the oil", Span::about, -30.0, 60.0},
    {kRunning, "heat.ambient", "Ambient temperature", Span::about, -40.0, 60.0},
    {kRunning, "heat.conductance.nut_ambient", "Conductance, nut to ambient", Span::factor, 0.2, 5.0},
    {kRunning, "heat.conductance.screw_ambient", "Conductance, screw to ambient", Span::factor, 0.2, 5.0},
};

/// A number and its unit: `45 deg`; absent if a text is no such value.
struct Written {
  double number = 0.0;
  std::string unit;
};

std::optional<Written> number_and_unit(std::string_view text) {
  Written written;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), written.number);
  if (error != std::errc()) return std::nullopt;
  written.unit = std::string(end, text.data() + text.size());
  if (!written.unit.empty() && written.unit.front() == ' ') written.unit.erase(0, 1);
  if (written.unit.find_first_of("{}[],:") != written.unit.npos) return std::nullopt;
  return written;
}

/// Values nested in one: `{coulomb: 0.11}` has one below `coulomb`.
std::vector<std::pair<std::string, std::string>> values_in(const std::string& path, std::string_view value) {
  if (!value.starts_with('{')) return {{path, std::string(value)}};
  std::vector<std::pair<std::string, std::string>> all;
  value = value.substr(1, value.size() - 2);
  int depth = 0;
  std::size_t start = 0;
  for (std::size_t k = 0; k <= value.size(); ++k) {
    const char c = k < value.size() ? value[k] : ',';
    depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
    if (c != ',' || depth > 0) continue;
    std::string_view entry = value.substr(start, k - start);
    start = k + 1;
    while (entry.starts_with(' ')) entry.remove_prefix(1);
    const std::size_t colon = entry.find(": ");
    if (colon == entry.npos) continue;
    for (auto& inner : values_in(path + "." + std::string(entry.substr(0, colon)), entry.substr(colon + 2)))
      all.push_back(std::move(inner));
  }
  return all;
}

/// `load_cases[3].name` -> `load_cases[].name`
std::string any_item(const std::string& path) {
  std::string pattern;
  for (std::size_t k = 0; k < path.size(); ++k)
    if (!(path[k] >= '0' && path[k] <= '9' && !pattern.empty() && pattern.back() == '['))
      pattern += path[k];
    else
      while (k + 1 < path.size() && path[k + 1] != ']') ++k;
  return pattern;
}

/// Inputs of one value, which one slider moves.
struct Slider {
  const Control* control = nullptr;
  std::string value;  ///< Value in the unit used by `ends_of`.
  std::string shown;  ///< Value in the unit of the page.
  std::vector<std::string> paths;
  std::vector<std::string> cases;  ///< Names of their load cases.
};

/// Value with two digits, so that the ends of a slider are round.
double rounded(double value) {
  const std::string text = fmt::format("{:.1e}", value);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

double largest_force(const Findings& all) {
  double largest = 0.0;
  for (const LoadCaseResult& r : all.most_complete()->delivery.result<Result>()->load_cases)
    largest = std::max(largest, std::abs(r.load_case.axial_force));
  return largest > 0.0 ? largest : 1e4;
}

std::pair<double, double> ends_of(const Findings& all, const Control& control, double value) {
  if (control.kind == Span::about) {
    const double scale = control.of_force ? largest_force(all) : 1.0;
    const double least = control.from == 0.0 ? 0.0 : value + control.from * scale;
    return {rounded(least), rounded(value + control.to * scale)};
  }
  double from = control.from * value, to = control.to * value;
  if (control.kind == Span::whole) {
    from = std::max(1.0, std::floor(from));
    to = std::ceil(to);
    if (std::string_view(control.path) == "mechanism.rollers") {
      from = 2.0;
      to = std::max<double>(value, contact::largest_roller_count(all.checked().geometry.contacts.threads));
    }
    return {from, to};
  }
  return std::minmax({rounded(from), rounded(to)});
}

/// Text in the unit of the file; on a page in US units in these.
std::string shown_text(const std::string& value, const std::string& of_file) {
  const std::string own = number_and_unit(value)->unit, of_table(table_unit(own).text);
  const std::optional<Written> written = number_and_unit(of_file);
  const bool is_other = !of_table.empty() && of_table != own;
  if (const auto number = input::number_in(value, of_table);
      is_other && number && !(written && written->unit == of_table))
    return fmt::format("{:.6g} {}", *number, of_table);
  return written && input::number_in(value, written->unit) ? of_file : value;
}

/// Text short enough for a field.
std::string short_text(const std::string& value, const Written& written) {
  constexpr std::size_t kRoom = 12;
  if (value.size() <= kRoom) return value;
  return fmt::format("{:.6g}{}{}", written.number, written.unit.empty() ? "" : " ", written.unit);
}

std::string slider_html(const Findings& all, const Slider& slider, int index) {
  const Control& control = *slider.control;
  const Written own = *number_and_unit(slider.value), shown = *number_and_unit(slider.shown);
  const auto [least, most] = ends_of(all, control, own.number);
  const auto in_shown_unit = [&](double end) {
    if (shown.unit == own.unit) return end;
    const auto number = input::number_in(fmt::format("{} {}", end, own.unit), shown.unit);
    return number ? rounded(*number) : end;
  };
  std::string title = control.title;
  if (!slider.cases.empty()) {
    title += ", " + slider.cases.front();
    if (slider.cases.size() > 1) title += fmt::format(" and {} more", slider.cases.size() - 1);
  }
  return fmt::format(
      "<div class=\"control\" data-paths=\"{0}\" data-value=\"{1}\"><label "
      "for=\"v{2}\">{3}</label><input id=\"v{2}\" type=\"text\" value=\"{1}\" autocomplete=\"off\" "
      "spellcheck=\"false\"><input type=\"range\" aria-label=\"{3}, slider\" min=\"{4}\" "
      "max=\"{5}\" step=\"{6}\" value=\"{7}\" data-unit=\"{8}\"></div>\n",
      html(fmt::format("{}", fmt::join(slider.paths, " "))), html(short_text(slider.shown, shown)), index,
      html(name_with_signs(title)), in_shown_unit(least), in_shown_unit(most),
      control.kind == Span::whole ? "1" : "any", shown.number, html(shown.unit));
}

/// Item of the list that an input belongs to, `load_cases[0]`; empty if there is none.
std::string item_of(const std::string& path) { return path.substr(0, path.find(']') + 1); }

std::string name_of_item(const Findings& all, const std::string& path) {
  if (path.starts_with("load_cases[")) return input_value(all, item_of(path) + ".name");
  if (any_item(path) != kSpectrum) return {};
  return fmt::format("no. {}", std::stoi(path.substr(path.find('[') + 1)) + 1);
}

/// A load of the life's spectrum and the force of a load case that it follows: one of the same size
/// and direction.
struct Follower {
  std::string path, leader;
};

std::size_t count_of(const Findings& all, std::string_view pattern) {
  return static_cast<std::size_t>(std::ranges::count_if(
      all.checked().fields, [&](const input::EchoEntry& field) { return any_item(field.path) == pattern; }));
}

/// Every load of the spectrum; none if one of them belongs to no load case.
std::vector<Follower> followers(const Findings& all) {
  struct Load {
    std::string path, force, direction;
  };
  std::map<std::string, Load> cases, spectrum;  // Loads by their items.
  for (const input::EchoEntry& field : all.checked().fields) {
    const std::string pattern = any_item(field.path);
    auto& loads = pattern.starts_with("load_cases[].") ? cases : spectrum;
    if (pattern == "load_cases[].axial_force" || pattern == "life.spectrum[].force") {
      loads[item_of(field.path)].path = field.path;
      loads[item_of(field.path)].force = field.value;
    }
    if (pattern == "load_cases[].direction" || pattern == "life.spectrum[].direction")
      loads[item_of(field.path)].direction = field.value;
  }
  std::map<std::pair<std::string, std::string>, std::string> leaders;
  for (const auto& [item, load] : cases) leaders.try_emplace({load.force, load.direction}, load.path);
  std::vector<Follower> found;
  if (spectrum.size() > kMostAtOnce) return found;
  for (const auto& [item, load] : spectrum) {
    const auto leader = leaders.find({load.force, load.direction});
    if (leader == leaders.end()) return {};
    found.push_back({load.path, leader->second});
  }
  return found;
}

}  // namespace

std::string controls_html(const Findings& all) {
  constexpr std::size_t kMostAlike = 6;  // Largest number of sliders of one kind, for several load cases.
  if (!all.most_complete()) return {};
  std::vector<Slider> sliders;
  const bool full = input_value(all, "model.mechanism") == "full";
  const std::vector<Follower> led = followers(all);
  const std::size_t cases = count_of(all, "load_cases[].name");
  const bool own_loads = led.empty() && count_of(all, kSpectrum) <= kMostAtOnce;
  for (const Control& control : kControls) {
    const std::string_view wanted = control.path;
    // Only if it is complete.
    const bool is_of_all = control.kind == Span::about && wanted.starts_with("load_cases[].");
    if ((is_of_all && !full) || (wanted == kSpectrum && !own_loads)) continue;
    std::vector<Slider> own;
    for (const input::EchoEntry& field : all.checked().fields) {
      const auto of_file = values_in(field.path, field.written);
      for (const auto& [path, value] : values_in(field.path, field.value)) {
        if (any_item(path) != wanted || !number_and_unit(value)) continue;
        if (field.is_default && control.kind != Span::about) continue;
        if (number_and_unit(value)->number == 0.0 && control.kind != Span::about) continue;
        if (contains(all.void_paths, path)) continue;
        auto same = std::ranges::find(own, value, &Slider::value);
        if (same == own.end()) {
          const auto written = std::ranges::find(of_file, path, &std::pair<std::string, std::string>::first);
          const std::string text = written == of_file.end() ? "" : written->second;
          same = own.insert(own.end(), {&control, value, shown_text(value, text), {}, {}});
        }
        same->paths.push_back(path);
        if (std::string name = name_of_item(all, path); !name.empty()) same->cases.push_back(std::move(name));
        for (const auto& [follower, leader] : led)
          if (leader == path) same->paths.push_back(follower);
      }
    }
    if (own.size() == 1 && (own.front().cases.size() >= cases || !wanted.starts_with("load_cases")))
      own.front().cases.clear();  // All load cases have the same.
    if (own.size() > kMostAlike) own.resize(kMostAlike);
    append(sliders, own);
  }
  std::string text;
  const char* group = nullptr;
  for (const auto k : indices(sliders)) {
    const Slider& slider = sliders[k];
    if (slider.control->group != group)
      text += fmt::format("{}<fieldset><legend>{}</legend>\n", group ? "</fieldset>\n" : "", slider.control->group);
    group = slider.control->group;
    text += slider_html(all, slider, static_cast<int>(k));
  }
  return group ? text + "</fieldset>\n" : text;
}

namespace {

using ThreadRows = std::vector<std::vector<std::string>>;

/// Entries of an array, nested arrays joined: roller after roller.
std::vector<Json> flat(const Json& array) {
  std::vector<Json> all;
  if (!array.is_array()) return all;
  for (const Json& entry : array)
    if (entry.is_array())
      std::ranges::copy(flat(entry), std::back_inserter(all));
    else
      all.push_back(entry);
  return all;
}

/// Adds rows for the values of one thread at both interfaces: entries of series as long as that of the loads.
void add_thread_rows(const RecordInfo& info, const Json& json, std::size_t thread, std::size_t threads,
                     ThreadRows& rows) {
  const Json& screw = under(json, "screw");
  const Json& nut = under(json, "nut");
  const RecordInfo* side = record_in(info, "screw");
  if (side && screw.is_object() && nut.is_object()) {
    for (const QuantityInfo& q : side->quantities) {
      const auto value = [&](const Json& body) {
        const std::vector<Json> values = flat(under(body, std::string(q.key)));
        return values.size() == threads ? values[thread] : Json();
      };
      const Json screw_value = value(screw), nut_value = value(nut);
      double largest = 0.0;
      for (const Json* one : {&screw_value, &nut_value})
        if (one->is_number()) largest = std::max(largest, std::abs(one->get<double>()));
      const ReportUnit unit = report_unit(q.key, q.unit, largest);
      const std::string at_screw = report_value(screw_value, unit), at_nut = report_value(nut_value, unit);
      if (at_screw.empty() && at_nut.empty()) continue;
      rows.push_back({html(capitalised(q.title)), at_screw, at_nut, html(unit.text)});
    }
  }
  for (const QuantityInfo& q : info.quantities) {
    const Json& inner = under(json, std::string(q.key));
    if (q.kind == Kind::record && inner.is_object() && q.key != "screw" && q.key != "nut")
      add_thread_rows(q.record(), inner, thread, threads, rows);
  }
}

/// Loads, pressures, friction of one thread, with its pictures.
std::string thread_html(Findings& all, const ThreadChoice& choice) {
  const CommandAnswer* numbers = all.of_threads();
  if (!numbers) return {};
  const Result& result = *numbers->delivery.result<Result>();
  if (choice.load_case >= result.load_cases.size()) return "<p>There is no such load case.</p>\n";
  const auto& known = result.load_cases[choice.load_case].threads;
  const std::size_t threads = known ? known->screw.normal_load.size() : 0;
  if (threads == 0) return "<p>The loads of this case are not known.</p>\n";
  if (choice.thread >= threads) return "<p>There is no such thread.</p>\n";
  ThreadRows rows;
  add_thread_rows(*record_at("load_cases[]"), numbers->document["load_cases"][choice.load_case], choice.thread, threads,
                  rows);
  std::string text;
  const FigureOptions options{.load_case = choice.load_case, .thread = choice.thread};
  for (const char* of_thread : {"thread_pressure", "thread_stress", "thread_friction"})
    if (const auto picture = std::ranges::find(numbers->pictures, of_thread, &Picture::name);
        picture != numbers->pictures.end())
      for (const Figure& figure : picture->make(options)) text += figure_html(all, figure);
  return text +
         fmt::format("<h3>Thread loads {}</h3>\n", words_of_text(name(result.load_cases[choice.load_case].loads))) +
         plain_table({"", "Roller-screw", "Roller-nut", "Unit"}, rows, true);
}

}  // namespace

Json thread_choices(const Findings& all) {
  const CommandAnswer* loads = all.of_threads();
  if (!loads) return nullptr;
  Json choices{{"cases", Json::array()}};
  double most = -1.0;
  for (const LoadCaseResult& load_case : loads->delivery.result<Result>()->load_cases) {
    const std::size_t place = choices["cases"].size();
    choices["cases"].push_back(name_with_signs(printable(load_case.load_case.name)));
    if (!load_case.threads || load_case.threads->screw.normal_load.empty()) continue;
    const InterfaceLoads& screw = load_case.threads->screw;
    const std::size_t count = screw.normal_load.size();
    const auto row = screw.threads_per_roller > 0 ? static_cast<std::size_t>(screw.threads_per_roller) : count;
    const auto largest = std::ranges::max_element(screw.normal_load);
    if (*largest <= most) continue;
    most = *largest;
    choices["rollers"] = count / row;
    choices["threads"] = row;
    choices["load_case"] = place;
    choices["thread"] = largest - screw.normal_load.begin();
  }
  return choices.contains("threads") ? choices : Json();
}

namespace {

constexpr std::string_view kThread = "thread";

bool is_wanted(const LiveQuestion& q, const SectionRow& row) {
  constexpr std::string_view kOfReport[] = {"studies", "provenance"};
  if (contains(kOfReport, row.id)) return false;
  if (q.quick && !row.is_quick) return false;
  return q.sections.empty() || contains(q.sections, row.id);
}

/// The report that a page started from, and data for its questions, kept between them.
struct Kept {
  Source source;
  std::unique_ptr<Findings> quick, complete;
  FullSolver full{FullStart::neighbour};
};

bool is_same(const Source& a, const Source& b) {
  return a.text == b.text && a.overrides == b.overrides && a.name == b.name && a.files == b.files;
}

Findings findings_for(const Source& source, bool quick, Kept& kept) {
  return quick ? quick_findings_of(source, kept.full) : findings_of(source, {}, reported_commands());
}

/// The findings of the report with its figures.
Findings& report_of(const Source& report, bool quick, Kept& kept) {
  if (!is_same(kept.source, report)) {
    kept.quick.reset();
    kept.complete.reset();
    kept.source = report;
  }
  std::unique_ptr<Findings>& known = quick ? kept.quick : kept.complete;
  if (known) return *known;
  auto found = std::make_unique<Findings>(findings_for(report, quick, kept));
  found->keeps_figures = true;
  for (const SectionRow& row : section_rows())
    if (!quick || row.is_quick) section_of(*found, row);
  found->keeps_figures = false;
  known = std::move(found);
  return *known;
}

/// Commands whose own loads are still the report's, while the load cases have others.
std::map<Command, std::string> unmoved(const Source& report, const Source& changed) {
  const auto values = [](const Source& source) { return input::read_case_input(source, Command::check).values; };
  const Case before = values(report), now = values(changed);
  const auto told = [](std::string_view key) {
    return fmt::format(
        "This does not follow the axial force of the load cases: its loads are those of "
        "<code>{}</code>.",
        key);
  };
  std::map<Command, std::string> all;
  const auto same_force = [](const LoadCase& a, const LoadCase& b) { return a.axial_force == b.axial_force; };
  const auto same_load = [](const SpectrumLoad& a, const SpectrumLoad& b) { return a.force == b.force; };
  if (std::ranges::equal(before.load_cases, now.load_cases, same_force)) return all;
  if (now.life && before.life && std::ranges::equal(before.life->spectrum, now.life->spectrum, same_load))
    all[Command::life] = told(now.life->history ? "life.history" : "life.spectrum");
  if (now.preload && before.preload && before.preload->load.from == now.preload->load.from &&
      before.preload->load.to == now.preload->load.to)
    all[Command::preload] = told("preload.load");
  return all;
}

LiveAnswer answer_of(Findings& all, const LiveQuestion& question) {
  const bool all_follow = all.unmoved.empty() && all.lacking.empty();
  LiveAnswer answer{Json::object(), {}, nullptr, all_follow, {}, all.notes, all.converged};
  for (const SectionRow& row : section_rows()) {
    if (!is_wanted(question, row)) continue;
    if (std::ranges::any_of(all.lacking, [&](Command c) { return name(c) == row.id; })) {
      answer.kept.emplace_back(row.id);
      continue;
    }
    std::string body = section_of(all, row).body;
    for (const auto& [command, why] : all.unmoved)
      if (name(command) == row.id && !body.empty())
        body = fmt::format("<p>{}</p>\n<div class=\"stale\">\n{}</div>\n", why, body);
    answer.sections[std::string(row.id)] = std::move(body);
  }
  if (!question.quick) {
    answer.head = head_html(all);
    answer.threads = thread_choices(all);
  }
  if (question.thread) {
    all.section = kThread;
    answer.sections[std::string(kThread)] = thread_html(all, *question.thread);
  }
  return answer;
}

}  // namespace

LiveAnswer live_sections(const Source& source, const LiveQuestion& question) {
  constexpr Command kOfThread[] = {Command::contact, Command::solve, Command::slip};
  thread_local Kept kept;
  const TableUnits units(question.units);
  if (other_file(source)) {
    ReportParts parts = requirement_parts(source, {});
    LiveAnswer answer;
    answer.head = std::move(parts.head);
    answer.notes = std::move(parts.notes);
    for (ReportSection& section : parts.sections) answer.sections[section.id] = std::move(section.body);
    return answer;
  }
  if (question.sections == std::vector{std::string(kThread)}) {
    Findings few = findings_of(source, {}, kOfThread);
    return answer_of(few, question);
  }
  Source own = source;
  own.overrides.resize(std::min(question.own, own.overrides.size()));
  Findings& report = report_of(own, question.quick, kept);
  if (is_same(source, own)) return answer_of(report, question);
  Findings changed = findings_for(source, question.quick, kept);
  changed.before = &report;
  if (!question.quick) changed.unmoved = unmoved(own, source);
  return answer_of(changed, question);
}

}  // namespace prs
