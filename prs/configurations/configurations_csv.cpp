#include <fmt/format.h>
#include <fmt/ranges.h>

#include "prs/configurations/configurations_csv.h"
#include "prs/configurations/configurations_json.h"
#include "prs/configurations/roller_spacing.h"
#include "prs/model/units.h"
#include "prs/record/csv_writer.h"

namespace prs {
namespace {

void integer(CsvWriter& csv, int value) { csv.integer(static_cast<std::size_t>(value)); }

void header(CsvWriter& csv, std::initializer_list<const char*> keys) {
  for (const char* key : keys) csv.text(key);
  csv.end_row();
}

void row(CsvWriter& csv, std::size_t number, const Configuration& c) {
  const Mechanism& m = c.mechanism;
  csv.integer(number);
  csv.text(type_name(m.type));
  integer(csv, m.starts.screw);
  integer(csv, m.starts.roller);
  csv.number(axial_pitch(m), per_si::millimetre);
  for (const Part p : kParts) csv.number(c.rolling_diameter[p], per_si::millimetre);
  for (const Part p : kParts) csv.number(c.pitch_diameter[p], per_si::millimetre);
  csv.number(c.centre_distance, per_si::millimetre);
  csv.number(c.gear_ratio);
  csv.number(c.lead.screw, per_si::millimetre);
  csv.number(c.lead.roller, per_si::millimetre);
  for (const Part p : kParts) csv.number(c.helix_angle[p], per_si::degree);
  integer(csv, c.most_rollers);
  integer(csv, m.rollers);
  csv.number(c.crest_gap, per_si::millimetre);
  csv.number(indexing_angle(m.type, m.starts, m.rollers), per_si::degree);
  csv.text(fmt::format("{}", fmt::join(c.alike, " ")));
  csv.end_row();
}

}  // namespace

std::string configurations_csv(const Configurations& all, const CsvStyle& style) {
  CsvWriter csv(style);
  header(csv, {"number",
               "type",
               "screw_starts",
               "roller_starts",
               "pitch_mm",
               "screw_rolling_diameter_mm",
               "roller_rolling_diameter_mm",
               "nut_rolling_diameter_mm",
               "screw_pitch_diameter_mm",
               "roller_pitch_diameter_mm",
               "nut_pitch_diameter_mm",
               "centre_distance_mm",
               "gear_ratio",
               "lead_mm",
               "roller_lead_mm",
               "screw_helix_angle_deg",
               "roller_helix_angle_deg",
               "nut_helix_angle_deg",
               "most_rollers",
               "rollers",
               "crest_gap_mm",
               "indexing_angle_deg",
               "alike"});
  for (std::size_t k = 0; k < all.found.size(); ++k) row(csv, k + 1, all.found[k]);
  return csv.take();
}

std::string gear_pairs_csv(const Configurations& all, const CsvStyle& style) {
  CsvWriter csv(style);
  header(csv, {"number", "roller_teeth", "body_teeth", "module_mm", "series",
               "working_pressure_angle_deg", "profile_shift", "most_rollers"});
  for (std::size_t k = 0; k < all.found.size(); ++k)
    for (const GearPair& pair : all.found[k].gears) {
      csv.integer(k + 1);
      integer(csv, pair.roller_teeth);
      integer(csv, pair.body_teeth);
      csv.number(pair.module, per_si::millimetre);
      integer(csv, pair.series);
      csv.number(pair.working_pressure_angle, per_si::degree);
      csv.number(pair.profile_shift);
      integer(csv, pair.most_rollers);
      csv.end_row();
    }
  return csv.take();
}

}  // namespace prs
