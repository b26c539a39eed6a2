#include "prs/figures/figure.h"

#include <algorithm>
#include <cmath>

namespace prs {

void fit_y_range(Figure& figure) {
  double least = HUGE_VAL;
  double largest = -HUGE_VAL;
  for (const Panel& panel : figure.panels)
    for (const Line& line : panel.lines)
      for (const Polyline& part : line.parts)
        for (const auto& [x, y] : part) {
          least = std::min(least, y);
          largest = std::max(largest, y);
        }
  const bool from_zero = least < 0.5 * largest;
  const double margin = 0.06 * (largest - (from_zero ? 0.0 : least));
  figure.y.from = from_zero ? 0.0 : least - margin;
  figure.y.to = largest > figure.y.from ? largest + margin : figure.y.from + 1.0;
}

}  // namespace prs
