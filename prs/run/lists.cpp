#include "prs/run/lists.h"

#include "prs/indices.h"
#include "prs/loads/case_table.h"
#include "prs/record/table_layout.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kUnitsAt = 60;

}  // namespace

std::string lubricants_table() {
  std::string text = fmt::format("{:<16}{:>12}{:>12}{:>12}\n{:<16}{:>12}{:>12}{:>12}\n", "name", "nu at 40",
                                 "nu at 100", "density", "", "mm^2/s", "mm^2/s", "kg/m^3");
  std::vector<std::string_view> sources;
  for (const NamedLubricant& l : named_lubricants()) {
    auto source = std::ranges::find(sources, l.source);
    if (source == sources.end()) source = sources.insert(source, l.source);
    text += fmt::format("{:<16}{:>12.6g}{:>12.6g}{:>12.6g}   {} [{}]\n", l.name, 1e6 * l.viscosity_40,
                        1e6 * l.viscosity_100, l.density, l.what, source - sources.begin() + 1);
  }
  text +=
      "\nKinematic viscosity nu of the oil, or of the base oil of the grease, which is all that "
      "counts:\nits thickener is not modelled.\n";
  for (const auto i : indices(sources)) text += fmt::format("[{}] {}\n", i + 1, sources[i]);
  return text;
}

Json lubricants_json() {
  Json json;
  for (const NamedLubricant& l : named_lubricants())
    json["lubricants"].push_back({{"name", l.name},
                                  {"description", l.what},
                                  {"viscosity_40_mm2_per_s", 1e6 * l.viscosity_40},
                                  {"viscosity_100_mm2_per_s", 1e6 * l.viscosity_100},
                                  {"density_kg_per_m3", l.density},
                                  {"source", l.source}});
  return json;
}

std::string units_table() {
  std::string text = fmt::format("{:<38}{:<22}{}\n", "quantity", "example", "units");
  for (const input::Dimension* d : input::dimensions()) {
    std::string units;
    for (const input::Unit& unit : d->units) {
      units += units.empty() ? "" : ", ";
      for (const std::string_view spelling : unit.spellings)
        if (!spelling.empty()) units += fmt::format("{}{}", spelling == unit.spellings[0] ? "" : " = ", spelling);
    }
    text += hanging(fmt::format("{:<38}{}", d->name, d->example), kUnitsAt, units);
  }
  return text + "\nA number, then its unit: `5 mm`. Differences of temperatures are in K, degC or degF.\n";
}

Json units_json() {
  Json json;
  for (const input::Dimension* d : input::dimensions()) {
    Json dimension{{"quantity", d->name}, {"example", d->example}, {"shown_in", d->canonical}};
    for (const input::Unit& unit : d->units) {
      Json spellings = Json::array();
      for (const std::string_view spelling : unit.spellings)
        if (!spelling.empty()) spellings.push_back(spelling);
      dimension["units"].push_back(std::move(spellings));
    }
    json["quantities"].push_back(std::move(dimension));
  }
  return json;
}

Json us_units_json() {
  Json json = Json::array();
  for (const ShownUnit& unit : kShownUnits)
    if (!unit.us_text.empty())
      json.push_back({{"text", unit.text}, {"us_text", unit.us_text}, {"factor", unit.us_factor / unit.factor}});
  return json;
}

}  // namespace prs
