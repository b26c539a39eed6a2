#include "prs/svg/frame.h"

#include <cmath>
#include <optional>

namespace prs {
namespace {

constexpr double kLooseEnds = 0.04;  // Room at the ends of a free axis.

/// All that a panel shows along one axis, 0 for x.
Range shown_range(const Panel& panel, std::size_t axis) {
  Range range;
  for (const Series& series : panel.series)
    for (const Polyline& part : series.parts)
      for (const auto& point : part) range.include(point[axis]);
  for (const ReferenceLine& line : panel.references)
    if (line.vertical == (axis == 0)) range.include(line.at);
  const GridData& grid = panel.surface ? panel.surface->grid : panel.map.grid;
  for (const double node : axis == 0 ? grid.x : grid.y) range.include(node);
  return range;
}

void fit(Axis& axis, Range range) {
  if (has_range(axis)) return;
  if (range.empty()) range = {0.0, 1.0};
  if (!axis.logarithmic) range.widen(kLooseEnds);
  if (range.from == range.to) range = {range.from - 1.0, range.to + 1.0};
  if (!std::isfinite(axis.from)) axis.from = range.from;
  if (!std::isfinite(axis.to)) axis.to = range.to;
}

/// A free axis of the figure, over what all panels that share it show, and those of panels.
void fit(Figure& figure, Axis& shared, std::optional<Axis> Panel::*own, std::size_t axis) {
  Range all;
  for (Panel& panel : figure.panels)
    if (std::optional<Axis>& its = panel.*own)
      fit(*its, shown_range(panel, axis));
    else
      all.include(shown_range(panel, axis));
  fit(shared, all);
}

}  // namespace

Figure with_ranges(Figure figure) {
  fit(figure, figure.x, &Panel::x, 0);
  fit(figure, figure.y, &Panel::y, 1);
  return figure;
}

Frame frame_of(const Figure& figure, const Layout& layout, std::size_t index) {
  const auto [x, y] = drawn_axes(figure, layout, index);
  const Box box = layout.panel(index);
  return {figure.panels[index],
          box,
          x,
          y,
          {x.from, x.to, box.left, box.right, x.logarithmic},
          {y.from, y.to, box.bottom, box.top, y.logarithmic}};
}

}  // namespace prs
