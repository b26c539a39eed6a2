#include "prs/record/response_title.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "prs/indices.h"
#include "prs/record/record.h"
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

}  // namespace prs
