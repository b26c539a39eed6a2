#include "prs/configurations/configurations_csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "prs/configurations/configurations_json.h"
#include "prs/configurations/roller_spacing.h"
#include "prs/model/units.h"
#include "prs/record/csv_writer.h"

namespace prs {

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
