#include "prs/record/response_title.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "prs/record/shown_unit.h"
#include "prs/text.h"

namespace prs {
namespace {

/// Takes `[k]` from the end of a key: the number of a `thread`, for example, else as it is.
std::string take_index(std::string_view& key, std::string_view what) {
  if (!key.ends_with(']')) return {};
  const std::size_t at = key.rfind('[');
  std::size_t index = 0;
  if (at == std::string_view::npos) return {};
  const auto [end, error] = std::from_chars(key.data() + at + 1, key.data() + key.size(), index);
  if (error != std::errc{} || end + 1 != key.data() + key.size()) return {};
  const std::string shown =
      what.empty() ? std::string(key.substr(at)) : fmt::format(", {} {}", what, index + 1);
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
    const bool of_rollers = of_threads && key.starts_with("roller_share");
    std::string index = take_index(key, of_rollers ? "roller" : of_threads ? "thread" : "");
    if (key.ends_with(']')) index = take_index(key, of_threads ? "roller" : "") + index;
    if (const ShownUnit& unit = unit_of(key); !unit.text.empty()) {
      title.unit = unit.text;
      key.remove_suffix(unit.suffix.size());
    }
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

std::string axis_title(std::string_view path) {
  const ResponseTitle title = response_title(path);
  const std::string name = capitalised(title.name);
  return title.unit.empty() ? name : fmt::format("{} ({})", name, title.unit);
}

}  // namespace prs
