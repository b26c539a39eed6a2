#include "prs/configurations/configurations_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "prs/configurations/configurations_json.h"
#include "prs/configurations/roller_spacing.h"
#include "prs/input/units.h"
#include "prs/model/units.h"
#include "prs/record/csv_writer.h"
#include "prs/record/table_text.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {
namespace {

/// Most left-out geometries that the table explains; beyond that, see the document.
constexpr std::size_t kMostDetails = 6;

std::string gears_cell(const Configuration& c) {
  if (c.gears.empty()) return std::string(kAbsent);
  const GearPair& best = c.gears.front();
  std::string text = fmt::format("{}:{}, {:.4g}{}", best.roller_teeth, best.body_teeth,
                                 best.module * per_si::millimetre, best.series == 1 ? "" : "*");
  if (best.most_rollers < c.mechanism.rollers) text += fmt::format(" ≤{}", best.most_rollers);
  return text;
}

std::string millimetres(double si) { return fixed(si, "mm", 3); }

using Found = const Configuration&;

struct Column {
  const char* title;
  const char* subtitle;
  std::size_t width;
  std::string (*cell)(Found);
  bool left_aligned = false;
};

constexpr Column kColumns[] = {
    {"  type", "", 12, [](Found c) { return fmt::format("  {}", type_name(c.mechanism.type)); },
     true},
    {"starts", "S/R", 6,
     [](Found c) {
       return fmt::format("{}/{}", c.mechanism.starts.screw, c.mechanism.starts.roller);
     }},
    {"pitch", "mm", 7, [](Found c) { return millimetres(axial_pitch(c.mechanism)); }},
    {"screw", "mm", 8, [](Found c) { return millimetres(c.pitch_diameter.screw); }},
    {"roller", "mm", 8, [](Found c) { return millimetres(c.pitch_diameter.roller); }},
    {"nut", "mm", 8, [](Found c) { return millimetres(c.pitch_diameter.nut); }},
    {"centres", "mm", 8, [](Found c) { return millimetres(c.centre_distance); }},
    {"hand", "roller", 7,
     [](Found c) { return std::string(c.lead.roller > 0.0 ? "right" : "left"); }},
    {"rollers", "≤", 8, [](Found c) { return std::to_string(c.most_rollers); }},
    {"one", "angle", 7,
     [](Found c) {
       return c.alike.empty() ? std::string(kAbsent) : fmt::format("{}", fmt::join(c.alike, " "));
     }},
    {"gears", "teeth, module/mm", 18, gears_cell}};

/// A number and the cells behind it.
std::string line(std::string text, const auto& cell) {
  text = padded(text, 3, false);
  for (const Column& column : kColumns)
    text += padded(cell(column), column.width, column.left_aligned);
  return ended(text);
}

std::string heading(const ConfigurationQuery& q) {
  const auto length = [](double si) {
    return fmt::format("{:.6g} {}", shown(si, "mm"), table_unit("mm").text);
  };
  return fmt::format(
      "Screw {}, lead {}, flanks {}, no backlash, crests of neighbours {} apart or more\n\n",
      length(q.screw_diameter), length(q.lead),
      input::format_quantity(q.flank_angle, input::unit::angle), length(q.gap));
}

}  // namespace

std::string left_out_text(const Configurations& all) {
  const bool with_details = all.left_out.size() <= kMostDetails;
  std::vector<std::pair<std::string, std::string>> reasons;  // Reason, who.
  for (const LeftOut& left_out : all.left_out) {
    std::string key = fmt::format("{}: {}", type_name(left_out.type), left_out.reason);
    if (with_details && !left_out.detail.empty()) key += fmt::format(" ({})", left_out.detail);
    auto known = std::ranges::find(reasons, key, &std::pair<std::string, std::string>::first);
    if (known == reasons.end()) {
      reasons.emplace_back(key, std::string(type_name(left_out.type)));
      known = reasons.end() - 1;
    }
    known->second += fmt::format(" {}/{}", left_out.starts.screw, left_out.starts.roller);
  }
  std::string text;
  for (const auto& [key, who] : reasons)
    text += wrapped(who + key.substr(key.find(':')), "  ", kTableWidth);
  return text;
}

std::string configurations_table(const ConfigurationQuery& query, const Configurations& all) {
  std::string text = heading(query);
  text += line("#", [](const Column& column) { return column.title; });
  text += line("", [](const Column& column) { return with_table_unit(column.subtitle); });
  for (std::size_t k = 0; k < all.found.size(); ++k)
    text += line(std::to_string(k + 1),
                 [&](const Column& column) { return column.cell(all.found[k]); });
  text += "\n";
  text += wrapped(
      "Every number of rollers up to the one given meshes at equal spacing; with those of `one "
      "angle` "
      "all go in turned the same way. Gears: roller to nut (standard) or screw (inverted), the "
      "most suitable pair; * second series of modules, ≤ rollers whose pinions clear each other.",
      "", kTableWidth);
  if (!all.left_out.empty()) text += "\nLeft out\n" + left_out_text(all);
  return text;
}

std::string configurations_csv(const Configurations& all, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.row("number", "type", "screw_starts", "roller_starts", "pitch_mm",
          "screw_rolling_diameter_mm", "roller_rolling_diameter_mm", "nut_rolling_diameter_mm",
          "screw_pitch_diameter_mm", "roller_pitch_diameter_mm", "nut_pitch_diameter_mm",
          "centre_distance_mm", "gear_ratio", "lead_mm", "roller_lead_mm", "screw_helix_angle_deg",
          "roller_helix_angle_deg", "nut_helix_angle_deg", "most_rollers", "rollers",
          "crest_gap_mm", "indexing_angle_deg", "alike");
  constexpr double mm = per_si::millimetre, degree = per_si::degree;
  for (std::size_t k = 0; k < all.found.size(); ++k) {
    const Configuration& c = all.found[k];
    const Mechanism& m = c.mechanism;
    csv.fields(k + 1, type_name(m.type), m.starts.screw, m.starts.roller, axial_pitch(m) * mm);
    for (const auto* diameter : {&c.rolling_diameter, &c.pitch_diameter})
      for (const Part p : kParts) csv.number((*diameter)[p], mm);
    csv.fields(c.centre_distance * mm, c.gear_ratio, c.lead.screw * mm, c.lead.roller * mm);
    for (const Part p : kParts) csv.number(c.helix_angle[p], degree);
    csv.row(c.most_rollers, m.rollers, scaled(c.crest_gap, mm),
            scaled(indexing_angle(m.type, m.starts, m.rollers), degree),
            fmt::format("{}", fmt::join(c.alike, " ")));
  }
  return csv.take();
}

std::string gear_pairs_csv(const Configurations& all, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.row("number", "roller_teeth", "body_teeth", "module_mm", "series",
          "working_pressure_angle_deg", "profile_shift", "most_rollers");
  for (std::size_t k = 0; k < all.found.size(); ++k)
    for (const GearPair& g : all.found[k].gears)
      csv.row(k + 1, g.roller_teeth, g.body_teeth, g.module * per_si::millimetre, g.series,
              g.working_pressure_angle * per_si::degree, g.profile_shift, g.most_rollers);
  return csv.take();
}

}  // namespace prs
