#include <algorithm>

#include "prs/model/units.h"
#include "prs/preload/preload_csv.h"
#include "prs/record/csv_writer.h"

namespace prs {
namespace {

/// Empty fields where the solve failed.
void curve_fields(CsvWriter& csv, const PreloadPoint* point) {
  const bool solved = point && point->solve.converged();
  csv.text(point ? fe::name(point->solve.status) : "");
  csv.number(solved ? std::optional(point->axial_displacement) : std::nullopt, per_si::micrometre);
  csv.number(solved ? point->tangent_stiffness : std::nullopt, per_si::newton_per_micrometre);
}

void side_fields(CsvWriter& csv, const PreloadPoint& point, Direction d) {
  const SideLoads& side = point.sides[d];
  const bool solved = point.solve.converged();
  const double normal = std::max(side.max_normal_load.screw, side.max_normal_load.nut);
  csv.number(solved ? std::optional(side.axial_load.screw) : std::nullopt);
  csv.number(solved ? std::optional(normal) : std::nullopt);
}

}  // namespace

std::string preload_csv(const PreloadResult& result, const CsvStyle& style) {
  CsvWriter csv(style);
  for (const char* key :
       {"axial_force_N", "status", "axial_displacement_um", "tangent_stiffness_N_per_um",
        "tension_side_load_N", "tension_side_max_normal_load_N", "compression_side_load_N",
        "compression_side_max_normal_load_N", "without_preload_status",
        "without_preload_displacement_um", "without_preload_tangent_stiffness_N_per_um"})
    csv.text(key);
  csv.end_row();
  for (std::size_t k = 0; k < result.curve.points.size(); ++k) {
    const PreloadPoint& point = result.curve.points[k];
    csv.number(point.axial_force);
    curve_fields(csv, &point);
    for (const Direction d : kDirections) side_fields(csv, point, d);
    curve_fields(csv, result.without_preload ? &result.without_preload->points[k] : nullptr);
    csv.end_row();
  }
  return csv.take();
}

}  // namespace prs
