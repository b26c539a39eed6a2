#include "prs/quantities/response_title.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "prs/text.h"

namespace prs {
namespace {

/// How units stand in keys and how people write them, longer ones before their own ends.
constexpr std::pair<std::string_view, std::string_view> kUnits[] = {
    {"_N_per_mm1_5", "N/mm^1.5"},
    {"_mm_per_rad", "mm/rad"},
    {"_kN_per_kg", "kN/kg"},
    {"_W_per_mm2", "W/mm²"},
    {"_N_per_um", "N/µm"},
    {"_mm_per_s", "mm/s"},
    {"_kg_per_m", "kg/m"},
    {"_kg_mm2", "kg mm²"},
    {"_per_mm", "1/mm"},
    {"_revolutions", "revolutions"},
    {"_percent", "%"},
    {"_hours", "h"},
    {"_Nmm", "N mm"},
    {"_Nm", "N m"},
    {"_cm3", "cm³"},
    {"_MPa", "MPa"},
    {"_rpm", "rpm"},
    {"_deg", "deg"},
    {"_km", "km"},
    {"_kg", "kg"},
    {"_mm", "mm"},
    {"_um", "µm"},
    {"_nm", "nm"},
    {"_W", "W"},
    {"_N", "N"},
};

/// Takes the unit from the end of a key.
std::string_view take_unit(std::string_view& key) {
  for (const auto& [suffix, shown] : kUnits)
    if (key.ends_with(suffix)) {
      key.remove_suffix(suffix.size());
      return shown;
    }
  return {};
}

/// Takes `[k]` from the end of a key: the thread where the array is one over threads, else as it
/// is.
std::string take_index(std::string_view& key, bool over_threads) {
  if (!key.ends_with(']')) return {};
  const std::size_t at = key.rfind('[');
  std::size_t index = 0;
  if (at == std::string_view::npos) return {};
  const auto [end, error] = std::from_chars(key.data() + at + 1, key.data() + key.size(), index);
  if (error != std::errc{} || end + 1 != key.data() + key.size()) return {};
  const std::string shown =
      over_threads ? fmt::format(", thread {}", index + 1) : std::string(key.substr(at));
  key.remove_suffix(key.size() - at);
  return shown;
}

}  // namespace

ResponseTitle response_title(std::string_view path) {
  ResponseTitle title;
  const bool of_threads = path.starts_with("screw.") || path.starts_with("nut.") ||
                          path.starts_with("slip.screw.") || path.starts_with("slip.nut.");
  std::string& name = title.name;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('.'), path.size());
    std::string_view key = path.substr(0, end);
    path.remove_prefix(std::min(end + 1, path.size()));
    const std::string index = take_index(key, of_threads);
    if (const std::string_view unit = take_unit(key); !unit.empty()) title.unit = unit;
    if (key == "slip" || key == "contact" || key == "measures") continue;
    const bool is_summary = path.empty() && (key == "max" || key == "min" || key == "mean");
    const bool is_part =
        key == "screw" || key == "roller" || key == "nut" || key.starts_with("carrier_");
    const std::string_view space = name.empty() ? "" : " ";
    name = is_summary || is_part ? fmt::format("{}{}{}", key, space, name)
                                 : fmt::format("{}{}{}{}", name, space, key, index);
  }
  std::ranges::replace(name, '_', ' ');
  name = printable(name);
  return title;
}

}  // namespace prs
