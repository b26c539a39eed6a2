#include "validation/jung_2017/scale_chart.h"

#include <cmath>

#include "prs/model/units.h"

namespace prs::jung_2017 {

std::array<ScaleLine, 10> scale_chart() {
  std::array<ScaleLine, 10> lines;
  double sum_of_squares = 0.0;
  for (int k = 0; k < 10; ++k) {
    ScaleLine& line = lines[static_cast<std::size_t>(k)];
    line.rollers = 6 + k;
    line.roller = (7.8 + 1.3 * k) / per_si::millimetre;
    line.screw = (18.0 + 3.0 * k) / per_si::millimetre;
    line.nut_outer = (40.0 + 6.67 * k) / per_si::millimetre;
    sum_of_squares += line.nut_outer * line.nut_outer;
  }
  const double root_mean_square = std::sqrt(sum_of_squares / 10.0);
  for (ScaleLine& line : lines) line.scale = line.nut_outer / root_mean_square;
  return lines;
}

}  // namespace prs::jung_2017
