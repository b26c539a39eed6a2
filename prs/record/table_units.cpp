#include "prs/record/table_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "prs/indices.h"
#include "prs/input/units.h"
#include "prs/model/quantity_text.h"
#include "prs/text.h"

namespace prs {
namespace {

/// Removes `[k]` from the end of a key and returns it as a text: `, thread 1` if `what` is a thread, else `[k]`; empty
/// if there is none.
std::string take_index(std::string_view& key, std::string_view what) {
  if (!key.ends_with(']')) return {};
  const std::size_t at = key.rfind('[');
  std::size_t index = 0;
  if (at == std::string_view::npos) return {};
  const auto [end, error] = std::from_chars(key.data() + at + 1, key.data() + key.size(), index);
  if (error != std::errc{} || end + 1 != key.data() + key.size()) return {};
  const std::string shown = what.empty() ? std::string(key.substr(at)) : fmt::format(", {} {}", what, index + 1);
  key.remove_suffix(key.size() - at);
  return shown;
}

/// Whether the text of a number has only zeros.
bool is_zero(std::string_view text) { return text.find_first_not_of("+-0.") == text.npos; }

}  // namespace

ResponseTitle response_title(std::string_view path) {
  // Words of catalogues for keys, and places, which stand behind the quantity.
  constexpr std::pair<std::string_view, std::string_view> kWords[] = {{"load_rate", "share of the load"},
                                                                      {"solved_static_safety", "static safety"},
                                                                      {"l10_hours", "L10 in time"},
                                                                      {"l10_revolutions", "L10 in turns"},
                                                                      {"torque_screw", "torque on the screw"},
                                                                      {"torque_nut", "torque on the nut"},
                                                                      {"max", "largest "},
                                                                      {"min", "smallest "},
                                                                      {"mean", "mean "}};
  constexpr std::pair<std::string_view, std::string_view> kPlaces[] = {
      {"system", "mechanism"}, {"catalogue", "by the catalogue's formula"}, {"weakest_thread", "weakest thread"}};
  // Design measures that estimate what another command computes.
  constexpr std::string_view kEstimates[] = {"static_safety",   "efficiency", "back_driving_efficiency",
                                             "l10_revolutions", "l10_hours",  "l10_travel_km",
                                             "drive_torque_Nm"};
  const std::size_t measure = path.find("measures.");
  const bool is_estimate = measure != path.npos && contains(kEstimates, path.substr(measure + 9));
  const auto word = [](const auto& words, std::string_view key) {
    const auto found = std::ranges::find(words, key, [](const auto& row) { return row.first; });
    return found == std::end(words) ? std::string_view() : found->second;
  };
  ResponseTitle title{{}, std::string(unit_at(path).text)};
  const bool of_threads = path.starts_with("screw.") || path.starts_with("nut.") || path.starts_with("slip.screw.") ||
                          path.starts_with("slip.nut.");
  std::string summary, name, places;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('.'), path.size());
    std::string_view key = path.substr(0, end);
    path.remove_prefix(std::min(end + 1, path.size()));
    const bool of_rollers = of_threads && key.starts_with("roller_share");
    std::string index = take_index(key, of_rollers ? "roller" : of_threads ? "thread" : "");
    if (key.ends_with(']')) index = take_index(key, of_threads ? "roller" : "") + index;
    std::string_view words = word(kWords, key);
    key.remove_suffix(unit_of(key).suffix.size());
    if (name.empty() && (key == "slip" || key == "contact" || key == "measures" || key == "heat")) continue;
    if (path.empty() && (key == "max" || key == "min" || key == "mean")) {
      summary = words;
    } else if (key == "screw" || key == "roller" || key == "nut" || key.starts_with("carrier_")) {
      places = fmt::format(", {}{}", key, places);
    } else if (const std::string_view place = word(kPlaces, key); !place.empty()) {
      places += fmt::format(", {}", place);
    } else {
      if (words.empty()) words = word(kWords, key);
      name += fmt::format("{}{}", name.empty() ? "" : " ", words.empty() ? key : words);
    }
    (index.starts_with('[') ? name : places) += index;
  }
  title.name = summary + name + (name.empty() ? places.substr(std::min<std::size_t>(2, places.size())) : places);
  std::ranges::replace(title.name, '_', ' ');
  if (is_estimate) title.name += " (estimate)";
  title.name = printable(title.name);
  return title;
}

namespace {

thread_local UnitSystem system_of_tables = UnitSystem::si;

/// Decimals needed in the smaller or larger unit for the same digits.
int decimals_in(const ShownUnit& shown, const ShownUnit& unit, int decimals) {
  const int more = static_cast<int>(std::ceil(-std::log10(shown.factor / unit.factor)));
  return std::max(0, decimals + more);
}

}  // namespace

TableUnits::TableUnits(UnitSystem system) : before_(system_of_tables) { system_of_tables = system; }
TableUnits::~TableUnits() { system_of_tables = before_; }

ShownUnit table_unit(const ShownUnit& unit) {
  if (system_of_tables == UnitSystem::si || unit.us_text.empty()) return unit;
  return {"", unit.us_text, unit.us_factor};
}

ShownUnit table_unit(std::string_view text) { return table_unit(unit_written(text)); }

std::string with_table_unit(std::string_view label) {
  if (system_of_tables == UnitSystem::us)
    for (const ShownUnit& unit : kShownUnits) {
      if (unit.us_text.empty() || !label.ends_with(unit.text)) continue;
      const std::string_view before = label.substr(0, label.size() - unit.text.size());
      if (before.empty() || before.ends_with(' ')) return fmt::format("{}{}", before, unit.us_text);
    }
  return std::string(label);
}

UnitSystem table_system() { return system_of_tables; }

std::string table_number(std::string_view number, std::string_view unit) {
  constexpr std::string_view kMinus = "−";
  if (number.starts_with(kMinus)) return std::string(kMinus) + table_number(number.substr(kMinus.size()), unit);
  const double factor = table_factor(unit);
  const std::string_view all = number.substr(0, number.find('e'));
  const std::size_t first = std::min(all.find_first_of("123456789"), all.size());
  const auto digits = std::ranges::count_if(all.substr(first), [](char c) { return c != '.'; });
  return factor == 1.0
             ? std::string(number)
             : significant(factor * input::parse_number(number).value_or(0.0), std::max(3, static_cast<int>(digits)));
}

std::string in_table_unit(std::string_view quantity) {
  const std::size_t blank = quantity.find(' ');
  const std::string_view unit = quantity.substr(blank + 1);
  return fmt::format("{} {}", table_number(quantity.substr(0, blank), unit), table_unit(unit).text);
}

std::string table_sentence(const Warning& warning) { return with_quantities(marked_sentence(warning), in_table_unit); }

double shown(double si, std::string_view unit) { return si * table_unit(unit).factor; }

std::string fixed(std::optional<double> si, std::string_view unit, int decimals) {
  const ShownUnit& documents = unit_written(unit);
  const ShownUnit tables = table_unit(documents);
  return fixed(si, tables.factor, decimals_in(tables, documents, decimals));
}

std::string fixed_with_unit(std::optional<double> si, std::string_view unit, int decimals) {
  if (!si) return std::string(kAbsent);
  return fmt::format("{} {}", fixed(si, unit, decimals), table_unit(unit).text);
}

double table_factor(const ShownUnit& unit) { return table_unit(unit).factor / unit.factor; }

double table_factor(std::string_view unit) { return table_factor(unit_written(unit)); }

std::string TableResponse::text() const {
  return title.unit.empty() ? title.name : fmt::format("{} ({})", title.name, title.unit);
}

TableResponse table_response(std::string_view path) {
  TableResponse response{response_title(path)};
  const ShownUnit& unit = unit_written(response.title.unit);
  if (unit.text.empty()) return response;
  response.factor = table_factor(unit);
  response.title.unit = table_unit(unit).text;
  return response;
}

std::string fixed(std::optional<double> si, double factor, int decimals) {
  if (!si) return std::string(kAbsent);
  std::string text = fmt::format("{:.{}f}", *si * factor, decimals);
  if (text.starts_with('-') && is_zero(text)) text.erase(0, 1);
  return text;
}

std::string fixed_change(double value, int decimals) {
  std::string text = fmt::format("{:+.{}f}", value, decimals);
  if (is_zero(text)) text[0] = '+';
  return text;
}

std::string significant(std::optional<double> value, int digits) {
  if (!value || !std::isfinite(*value)) return std::string(kAbsent);
  const double size = std::abs(*value);
  const double digit = std::pow(10.0, std::floor(std::log10(size)) + 1.0 - digits);
  if (!(digit >= 1.0 && size < 1e9)) return fmt::format("{:.{}g}", *value, digits);
  return fmt::format("{:.0f}", std::round(*value / digit) * digit);
}

std::string significant_with_unit(std::optional<double> si, std::string_view unit, int digits) {
  if (!si) return std::string(kAbsent);
  return fmt::format("{} {}", significant(shown(*si, unit), digits), table_unit(unit).text);
}

std::string digits(std::optional<double> value, int digits) {
  return value && std::isfinite(*value) ? fmt::format("{:.{}g}", *value, digits) : std::string(kAbsent);
}

std::string all_in(std::string_view file) { return fmt::format("all in {}, with --output DIR", file); }

std::string padded(const std::string& text, std::size_t columns, bool left_aligned) {
  const std::string space(columns - std::min(columns, width(text)), ' ');
  return left_aligned ? text + space : space + text;
}

std::string fitted(std::string_view text, std::size_t columns, bool left_aligned) {
  return padded(shortened(text, columns), columns, left_aligned);
}

std::string TableRows::operator()(const std::string& label, const std::vector<std::string>& cells,
                                  std::string_view remark) const {
  std::string line = padded(label, label_width, true);
  for (const std::string& cell : cells) line.append(gap, ' ').append(padded(cell, cell_width, false));
  return ended(line.append(remark));
}

std::string hanging(const std::string& label, std::size_t columns, std::string_view text) {
  return wrapped(text, std::string(columns, ' '), kTableWidth).replace(0, columns, padded(label, columns, true));
}

std::string ended(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line += '\n';
}

std::string words_of_text(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> kWords[] = {
      {"flank_edge", "edge loading"}, {"lemor", "Lemor's formula"}, {"given", "stated value"}, {"static", "at rest"}};
  for (const auto& [known, words] : kWords)
    if (text == known) return std::string(words);
  std::string words(text);
  std::ranges::replace(words, '_', ' ');
  return words;
}

namespace {

constexpr int kBarCells = 36;
constexpr std::size_t kBarColumn = kBarCells + 9;
constexpr std::string_view kEighths[] = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};

/// A bar with a resolution of an eighth of a character.
std::string bar(double value, double largest) {
  const double share = largest > 0.0 ? std::clamp(value / largest, 0.0, 1.0) : 0.0;
  const auto [cells, eighths] = std::div(static_cast<int>(std::lround(8 * kBarCells * share)), 8);
  std::string text;
  for (int k = 0; k < cells; ++k) text += "█";
  return text.append(kEighths[eighths]);
}

double largest_of(const PerInterface<std::vector<double>>& values) {
  double largest = 0.0;
  for (const Interface i : kInterfaces)
    for (const double value : values[i]) largest = std::max(largest, value);
  return largest;
}

}  // namespace

std::string bar_chart(const PerInterface<std::vector<double>>& values, int decimals, std::string_view unit) {
  const double largest = largest_of(values);
  const auto bar_and_value = [&](double value) {
    return fmt::format("{} {:.{}f} {}", bar(value, largest), value, decimals, unit);
  };
  std::string chart = fmt::format("     {}  nut\n", padded("screw", kBarColumn, true));
  for (const auto k : indices(values.screw))
    chart += fmt::format("{:3}  {}  {}\n", k + 1, padded(bar_and_value(values.screw[k]), kBarColumn, true),
                         bar_and_value(values.nut[k]));
  return chart;
}

}  // namespace prs
