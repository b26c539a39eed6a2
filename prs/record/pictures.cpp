#include "prs/record/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "prs/record/figure_parts.h"

namespace prs {

Figures in_kilonewtons(Figures figures) {
  for (Figure& figure : figures) figure = in_kilonewtons(std::move(figure));
  return figures;
}

Pictures with(Pictures own, Pictures others) {
  for (Picture& picture : others) {
    picture.drawn = Picture::Drawn::by_name;
    own.push_back(std::move(picture));
  }
  return own;
}

Figures figures(const Pictures& pictures, bool all) {
  Figures drawn;
  for (const Picture& picture : pictures)
    if (picture.drawn == Picture::Drawn::always ||
        (all && picture.drawn == Picture::Drawn::with_all))
      for (Figure& figure : picture.make({})) drawn.push_back(std::move(figure));
  return drawn;
}

Figure figure(const Pictures& pictures, std::string_view name, const FigureOptions& options) {
  const auto found = std::ranges::find(pictures, name, &Picture::name);
  if (found == pictures.end()) {
    std::vector<std::string_view> names;
    for (const Picture& picture : pictures) names.push_back(picture.name);
    throw NoFigure(fmt::format("no picture {}; there is {}", name, fmt::join(names, ", ")));
  }
  Figures made = found->make(options);
  if (made.empty()) throw NoFigure(fmt::format("no picture {}: it needs {}", name, found->needs));
  if (options.panel) return only_panel(std::move(made.front()), *options.panel);
  return options.one_panel ? folded(made.front()) : std::move(made.front());
}

bool has_data(const Figure& figure) {
  return std::ranges::any_of(figure.panels, [](const Panel& panel) {
    return !panel.map.grid.empty() || std::ranges::any_of(panel.series, [](const Series& series) {
      return std::ranges::any_of(series.parts, [](const Polyline& p) { return !p.empty(); });
    });
  });
}

}  // namespace prs
