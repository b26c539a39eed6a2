#include "prs/output/lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "prs/model/named_lubricants.h"

namespace prs {

std::string lubricants_table() {
  std::string text =
      fmt::format("{:<16}{:>12}{:>12}{:>12}\n{:<16}{:>12}{:>12}{:>12}\n", "name", "nu at 40",
                  "nu at 100", "density", "", "mm^2/s", "mm^2/s", "kg/m^3");
  std::vector<std::string_view> sources;
  for (const NamedLubricant& l : named_lubricants()) {
    auto source = std::ranges::find(sources, l.source);
    if (source == sources.end()) source = sources.insert(source, l.source);
    text +=
        fmt::format("{:<16}{:>12.6g}{:>12.6g}{:>12.6g}   {} [{}]\n", l.name, 1e6 * l.viscosity_40,
                    1e6 * l.viscosity_100, l.density, l.what, source - sources.begin() + 1);
  }
  text += "\nKinematic viscosity nu of the oil, or of the base oil of the grease.\n";
  for (std::size_t i = 0; i < sources.size(); ++i)
    text += fmt::format("[{}] {}\n", i + 1, sources[i]);
  return text;
}

nlohmann::ordered_json lubricants_json() {
  nlohmann::ordered_json json;
  for (const NamedLubricant& l : named_lubricants())
    json["lubricants"].push_back({{"name", l.name},
                                  {"description", l.what},
                                  {"viscosity_40_mm2_per_s", 1e6 * l.viscosity_40},
                                  {"viscosity_100_mm2_per_s", 1e6 * l.viscosity_100},
                                  {"density_kg_per_m3", l.density},
                                  {"source", l.source}});
  return json;
}

}  // namespace prs
