#include "prs/preload/preload_csv.h"

#include <algorithm>

#include "prs/model/units.h"
#include "prs/record/csv_writer.h"

namespace prs {
namespace {

/// Empty fields where the solve failed.
void curve_fields(CsvWriter& csv, const PreloadPoint* point) {
  const bool solved = point && point->solve.converged();
  csv.fields(
      point ? fe::name(point->solve.status) : "",
      solved ? std::optional(point->axial_displacement * per_si::micrometre) : std::nullopt,
      solved ? scaled(point->tangent_stiffness, per_si::newton_per_micrometre) : std::nullopt);
}

}  // namespace

std::string preload_csv(const PreloadResult& result, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.row("axial_force_N", "status", "axial_displacement_um", "tangent_stiffness_N_per_um",
          "tension_side_load_N", "tension_side_max_normal_load_N", "compression_side_load_N",
          "compression_side_max_normal_load_N", "without_preload_status",
          "without_preload_displacement_um", "without_preload_tangent_stiffness_N_per_um");
  for (std::size_t k = 0; k < result.curve.points.size(); ++k) {
    const PreloadPoint& point = result.curve.points[k];
    csv.number(point.axial_force);
    curve_fields(csv, &point);
    for (const Direction d : kDirections) {
      const SideLoads& side = point.sides[d];
      if (point.solve.converged())
        csv.fields(side.axial_load.screw,
                   std::max(side.max_normal_load.screw, side.max_normal_load.nut));
      else
        csv.fields("", "");
    }
    curve_fields(csv, result.without_preload ? &result.without_preload->points[k] : nullptr);
    csv.end_row();
  }
  return csv.take();
}

}  // namespace prs
