#include "prs/figures/figure_style.h"

#include <fmt/format.h>

#include <utility>

#include "prs/model/units.h"

namespace prs {

std::string interface_title(Interface i) {
  return i == Interface::screw ? "Screw–roller" : "Nut–roller";
}

std::size_t add_to_legend(Figure& figure, std::string title, const LineStyle& style) {
  const std::size_t index = figure.styles.size();
  figure.styles.push_back(style);
  figure.legend.push_back({std::move(title), index});
  return index;
}

void add_mean(Figure& figure, std::size_t threads) {
  const double mean = per_si::percent / static_cast<double>(threads);
  const std::size_t style = add_to_legend(figure, "equal shares", {"#555555", 2, 0, 1.2});
  const Line line{style, {{{figure.x.from, mean}, {figure.x.to, mean}}}};
  for (Panel& panel : figure.panels) panel.lines.insert(panel.lines.begin(), line);
}

void keep_first(std::vector<LoadedConfiguration>& configurations, std::size_t count,
                std::string& title) {
  if (configurations.size() <= count) return;
  title += fmt::format(", first {} of {}", count, configurations.size());
  configurations.resize(count);
}

}  // namespace prs
