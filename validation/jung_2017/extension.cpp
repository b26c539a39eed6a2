#include "validation/extensions.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "prs/model/units.h"
#include "validation/jung_2017/contact_parameters.h"
#include "validation/jung_2017/measures.h"
#include "validation/jung_2017/recipe.h"
#include "validation/jung_2017/scale_chart.h"
#include "validation/jung_2017/volume_fits.h"

namespace prs::jung_2017 {
namespace {

using Json = nlohmann::ordered_json;

/// The sets of tables 8.2 to 8.5 and 8.8 are lines of table 8.1, named by their number of rollers.
Json lines_by_rollers() {
  Json lines = Json::object();
  for (const ScaleLine& line : scale_chart())
    lines[fmt::format("rollers_{}", line.rollers)] = {
        {"scale", line.scale},
        {"roller_mm", line.roller * per_si::millimetre},
        {"screw_mm", line.screw * per_si::millimetre},
        {"nut_outer_mm", line.nut_outer * per_si::millimetre}};
  return lines;
}

Json formulas() {
  Json json{{"table_7_1", Json::array()}, {"table_a1", Json::array()}};
  for (const Diameters& d : case_1())
    json["table_7_1"].push_back(row_json(*find_recipe("jung-as-printed"), d));
  for (const PrintedParameters& line : table_a1()) {
    const ContactParameters p = contact_parameters(line.curvature_difference.value());
    json["table_a1"].push_back(
        {{"semi_major", p.semi_major}, {"semi_minor", p.semi_minor}, {"approach", p.approach}});
  }
  json["table_8_1"] = lines_by_rollers();
  return json;
}

ValidationTable measures_table(std::string title, const std::array<Diameters, 10>& rows,
                               Measures (*measures)(const Diameters&)) {
  ValidationTable table{
      std::move(title),
      {"D_n, mm", "d_r, mm", "T, mm", "V, l", "k, N/mm", "C_a, kN", "W, kg", "C_a/W, kN/kg"},
      {}};
  for (const Diameters& d : rows) {
    const Measures m = measures(d);
    table.rows.push_back(
        {fmt::format("{:g}", d.nut_outer * per_si::millimetre),
         {d.roller * per_si::millimetre, m.nut_thickness * per_si::millimetre, 1e3 * m.volume,
          m.stiffness / per_si::millimetre, m.load_capacity * per_si::kilonewton, m.weight,
          m.force_density() * per_si::kilonewton}});
  }
  return table;
}

/// What the first row of both tables consists of.
ValidationTable compliance_table() {
  ValidationTable table{"Compliance of one thread for D_n = 54 mm, in nm/N",
                        {"formulas", "teeth", "screw, radial", "nut, radial", "Hertz", "all"},
                        {}};
  const auto row = [&](const char* label, const ThreadCompliance& c) {
    table.rows.push_back({label, {c.teeth, c.screw_radial, c.nut_radial, c.hertz, c.total()}});
    for (double& value : table.rows.back().values) value *= per_si::nanometre;
  };
  row("as printed", compliance_as_printed(case_1().front()));
  row("right", right_compliance(case_1().front()));
  return table;
}

std::vector<ValidationTable> tables() {
  std::vector<ValidationTable> all{
      measures_table("Table 7.1, case 1, by the right formulas", case_1(), corrected),
      measures_table("Table 7.2, case 2, by the recipe of table 7.1", case_2(), as_printed),
      measures_table("Table 7.2, case 2, by the right formulas", case_2(), corrected),
      compliance_table()};
  for (ValidationTable& table : fit_tables()) all.push_back(std::move(table));
  all.push_back(deviations_of_table_a1());
  return all;
}

}  // namespace

SourceExtension extension() {
  return {.folder = "jung_2017", .formulas = formulas, .tables = tables};
}

}  // namespace prs::jung_2017
