#include <charconv>

#include "prs/input/units.h"
#include "prs/model/void_inputs.h"
#include "prs/record/table_units.h"
#include "prs/report/findings.h"
#include "prs/report/svg.h"

namespace prs {
namespace {

enum class Span { factor, about, whole };

/// An input that a page moves. `[]` in its path stands for any item.
struct Control {
  const char* group;
  const char* path;
  const char* title;
  Span kind = Span::factor;
  double from = 0.5, to = 1.5;  ///< Over its value, or what is added to it; from 0: not below 0.
  bool of_force = false;        ///< That is a share of the axial force.
};

constexpr const char* kSpectrum = "life.spectrum[].force";
constexpr std::size_t kMostAtOnce = 100;  ///< Loads of a spectrum that one slider moves.
constexpr const char* kLoads = "Loads";
constexpr const char* kThreads = "Threads";
constexpr const char* kBodies = "Bodies";
constexpr const char* kErrors = "Errors of the parts";
constexpr const char* kRunning = "Running";

constexpr Control kControls[] = {
    {kLoads, "load_cases[].axial_force", "Axial force", Span::factor, 0.05, 2.0},
    {kLoads, "load_cases[].axial_force.to", "Largest axial force", Span::factor, 0.1, 2.0},
    {kLoads, kSpectrum, "Load of the life", Span::factor, 0.05, 2.0},
    {kLoads, "load_cases[].misalignment.nut_tilt.y", "Tilt of the nut about y", Span::about, -0.2,
     0.2},
    {kLoads, "load_cases[].misalignment.nut_tilt.z", "Tilt of the nut about z", Span::about, -0.2,
     0.2},
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
    {kErrors, "deviations.pitch_error.screw.linear", "Pitch error of the screw", Span::about,
     -0.004, 0.004},
    {kErrors, "deviations.pitch_error.nut.linear", "Pitch error of the nut", Span::about, -0.004,
     0.004},
    {kErrors, "deviations.crowning", "Crowning of the rollers", Span::about, 0.0, 0.02},
    {kRunning, "operation.speed", "Speed", Span::factor, 0.02, 3.0},
    {kRunning, "load_cases[].speed", "Speed", Span::factor, 0.02, 3.0},
    {kRunning, "friction.model.coulomb", "Friction coefficient", Span::factor, 0.2, 2.0},
    {kRunning, "friction.model.mixed.boundary", "Boundary friction", Span::factor, 0.2, 2.0},
    {kRunning, "lubricant.temperature", "Temperature of the oil", Span::about, -30.0, 60.0},
    {kRunning, "heat.ambient", "Ambient temperature", Span::about, -40.0, 60.0},
    {kRunning, "heat.conductance.nut_ambient", "Conductance, nut to ambient", Span::factor, 0.2,
     5.0},
    {kRunning, "heat.conductance.screw_ambient", "Conductance, screw to ambient", Span::factor, 0.2,
     5.0},
};

/// A number and what stands behind it: `45 deg`; absent where a text is no such value.
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

/// The values within one: `{coulomb: 0.11}` has one below `coulomb`.
std::vector<std::pair<std::string, std::string>> values_in(const std::string& path,
                                                           std::string_view value) {
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
    for (auto& inner :
         values_in(path + "." + std::string(entry.substr(0, colon)), entry.substr(colon + 2)))
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
  std::string value;  ///< In the unit that `ends_of` goes by.
  std::string shown;  ///< In that of the page.
  std::vector<std::string> paths;
  std::vector<std::string> cases;  ///< Names of their load cases.
};

/// Two digits, so that the ends of a slider are round.
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
    const Json& most = under(under(all.check, "contact"), "max_rollers");
    if (std::string_view(control.path) == "mechanism.rollers") {
      from = 2.0;
      if (most.is_number()) to = std::max(value, most.get<double>());
    }
    return {from, to};
  }
  return std::minmax({rounded(from), rounded(to)});
}

/// As the file has it; on a page in US units in these.
std::string shown_text(const std::string& value, const std::string& of_file) {
  const std::string own = number_and_unit(value)->unit, of_table(table_unit(own).text);
  const std::optional<Written> written = number_and_unit(of_file);
  const bool is_other = !of_table.empty() && of_table != own;
  if (const auto number = input::number_in(value, of_table);
      is_other && number && !(written && written->unit == of_table))
    return fmt::format("{:.6g} {}", *number, of_table);
  return written && input::number_in(value, written->unit) ? of_file : value;
}

/// As a field has room for it.
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
      html(fmt::format("{}", fmt::join(slider.paths, " "))), html(short_text(slider.shown, shown)),
      index, html(title), in_shown_unit(least), in_shown_unit(most),
      control.kind == Span::whole ? "1" : "any", shown.number, html(shown.unit));
}

/// The item of a list that an input belongs to, `load_cases[0]`; empty where there is none.
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
  return static_cast<std::size_t>(std::ranges::count_if(all.check["input"], [&](const Json& entry) {
    return any_item(entry["path"].get<std::string>()) == pattern;
  }));
}

/// Every load of the spectrum; none where one of them is no load case's.
std::vector<Follower> followers(const Findings& all) {
  struct Load {
    std::string path, force, direction;
  };
  std::map<std::string, Load> cases, spectrum;  // By their items.
  for (const Json& entry : all.check["input"]) {
    const std::string path = entry["path"], pattern = any_item(path);
    auto& loads = pattern.starts_with("load_cases[].") ? cases : spectrum;
    if (pattern == "load_cases[].axial_force" || pattern == "life.spectrum[].force")
      std::tie(loads[item_of(path)].path, loads[item_of(path)].force) =
          std::pair(path, entry["value"].get<std::string>());
    if (pattern == "load_cases[].direction" || pattern == "life.spectrum[].direction")
      loads[item_of(path)].direction = entry["value"];
  }
  std::map<std::pair<std::string, std::string>, std::string> leaders;
  for (const auto& [item, load] : cases)
    leaders.try_emplace({load.force, load.direction}, load.path);
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
  constexpr std::size_t kMostAlike = 6;  // Sliders of one kind, for several load cases.
  if (!all.most_complete()) return {};
  std::vector<Slider> sliders;
  const bool full = input_value(all, "model.mechanism") == "full";
  const std::vector<Follower> led = followers(all);
  const std::size_t cases = count_of(all, "load_cases[].name");
  const bool own_loads = led.empty() && count_of(all, kSpectrum) <= kMostAtOnce;
  for (const Control& control : kControls) {
    const std::string_view wanted = control.path;
    const bool is_of_all =
        control.kind == Span::about && wanted.starts_with("load_cases[].");  // Full alone.
    if ((is_of_all && !full) || (wanted == kSpectrum && !own_loads)) continue;
    std::vector<Slider> own;
    for (const Json& entry : all.check["input"]) {
      const std::string of_entry = entry["path"];
      const auto of_file = values_in(of_entry, entry.value("written", ""));
      for (const auto& [path, value] : values_in(of_entry, entry["value"].get<std::string>())) {
        if (any_item(path) != wanted || !number_and_unit(value)) continue;
        const bool is_default = entry.value("default", false);
        if (is_default && control.kind != Span::about) continue;
        if (number_and_unit(value)->number == 0.0 && control.kind != Span::about) continue;
        if (std::ranges::find(all.void_paths, path) != all.void_paths.end()) continue;
        auto same = std::ranges::find(own, value, &Slider::value);
        if (same == own.end()) {
          const auto written =
              std::ranges::find(of_file, path, &std::pair<std::string, std::string>::first);
          const std::string text = written == of_file.end() ? "" : written->second;
          same = own.insert(own.end(), {&control, value, shown_text(value, text), {}, {}});
        }
        same->paths.push_back(path);
        if (std::string name = name_of_item(all, path); !name.empty())
          same->cases.push_back(std::move(name));
        for (const auto& [follower, leader] : led)
          if (leader == path) same->paths.push_back(follower);
      }
    }
    if (own.size() == 1 && (own.front().cases.size() >= cases || !wanted.starts_with("load_cases")))
      own.front().cases.clear();  // All have the same.
    if (own.size() > kMostAlike) own.resize(kMostAlike);
    std::ranges::move(own, std::back_inserter(sliders));
  }
  std::string text;
  const char* group = nullptr;
  for (std::size_t k = 0; k < sliders.size(); ++k) {
    const Slider& slider = sliders[k];
    if (slider.control->group != group)
      text += fmt::format("{}<fieldset><legend>{}</legend>\n", group ? "</fieldset>\n" : "",
                          slider.control->group);
    group = slider.control->group;
    text += slider_html(all, slider, static_cast<int>(k));
  }
  return group ? text + "</fieldset>\n" : text;
}

}  // namespace prs
