#include "prs/record/figure_behind.h"

#include <algorithm>

namespace prs {

std::optional<std::size_t> add_behind(Figure& figure, const Figure& before) {
  if (figure.to_scale || figure.panels.size() != before.panels.size()) return std::nullopt;
  const Style grey = line_of(Colour::muted, Dash::solid, Weight::strong);
  const std::size_t line = figure.add(grey),
                    points = figure.add(points_of(Colour::muted, Mark::circle));
  for (std::size_t k = 0; k < figure.panels.size(); ++k) {
    Panel& panel = figure.panels[k];
    std::vector<Series> behind;
    for (const Series& series : before.panels[k].series) {
      const Style& style = before.styles[series.style];
      if (style.shape != Shape::line || !series.values.empty()) continue;
      behind.push_back({style.dash == Dash::none ? points : line, series.parts});
    }
    panel.series.insert(panel.series.begin(), behind.begin(), behind.end());
  }
  const auto widen = [](Axis& axis, const Axis& other) {
    axis.from = std::min(axis.from, other.from);
    axis.to = std::max(axis.to, other.to);
  };
  widen(figure.x, before.x);
  widen(figure.y, before.y);
  return line;
}

}  // namespace prs
