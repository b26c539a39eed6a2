#include "prs/study/grid_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace prs {
namespace {

/// Nodes of designs 1, 2, ..: the last factor changes fastest.
std::vector<std::size_t> nodes_of(const GridMaps& maps) {
  std::array<std::vector<std::size_t>, 2> node_of_level;
  for (std::size_t a = 0; a < 2; ++a) {
    node_of_level[a].resize(maps.axes[a].nodes());
    for (std::size_t k = 0; k < maps.axes[a].nodes(); ++k)
      node_of_level[a][maps.axes[a].levels[k]] = k;
  }
  std::vector<std::size_t> nodes;
  nodes.reserve(maps.nodes());
  for (const std::size_t i : node_of_level[0])
    for (const std::size_t j : node_of_level[1]) nodes.push_back(maps.node(i, j));
  return nodes;
}

/// An input between two nodes; that of the nearer node where it has no such value.
Level level_at(const Factor& input, const MapAxis& axis, double place) {
  const auto [node, share] = between(place, axis.nodes());
  const Level& from = input.levels[axis.levels[node]];
  const Level& to = input.levels[axis.levels[node + 1]];
  if (share == 0.0 || share == 1.0 || !axis.continuous) return share < 0.5 ? from : to;
  const double number = interpolated(*from.number, *to.number, share, input.logarithmic);
  return {fmt::format("{:.15g}{}{}", number, input.unit.empty() ? "" : " ", input.unit), number};
}

}  // namespace

std::size_t GridMaps::design(std::size_t node) const {
  const std::size_t i = axes[0].levels[node / axes[1].nodes()];
  const std::size_t j = axes[1].levels[node % axes[1].nodes()];
  return 1 + i * axes[1].nodes() + j;
}

double map_value(const GridMaps& maps, const GridMap& map, MapPlace place) {
  const Between u = between(place[0], maps.axes[0].nodes());
  const Between v = between(place[1], maps.axes[1].nodes());
  double sum = 0.0;
  for (const std::size_t i : {0U, 1U})
    for (const std::size_t j : {0U, 1U}) {
      const double weight = (i == 0 ? 1.0 - u.share : u.share) * (j == 0 ? 1.0 - v.share : v.share);
      if (weight != 0.0) sum += weight * map[maps.node(u.node + i, v.node + j)];
    }
  return sum;
}

std::vector<Level> inputs_at(const Study& study, const GridMaps& maps, MapPlace place) {
  std::vector<Level> levels;
  for (const DrawnInput& drawn : drawn_inputs(study))
    levels.push_back(level_at(*drawn.input, maps.axes[drawn.factor], place[drawn.factor]));
  return levels;
}

GridMapCollector::GridMapCollector(const Study& study) {
  std::optional<std::array<MapAxis, 2>> axes = map_axes(study);
  if (!axes) return;
  GridMaps maps{std::move(*axes), {}};
  if (maps.nodes() > kMostMapValues / std::max<std::size_t>(1, study.responses.size())) return;
  maps.responses.assign(study.responses.size(), GridMap(maps.nodes(), kNoResponse));
  nodes_ = nodes_of(maps);
  maps_ = std::move(maps);
}

void GridMapCollector::add(const RowBlock& block) {
  if (!maps_) return;
  const std::size_t width = maps_->responses.size();
  for (std::size_t row = 0; row < block.rows; ++row) {
    const std::size_t design = block.first + row;
    if (design == 0) continue;
    for (std::size_t k = 0; k < width; ++k)
      maps_->responses[k][nodes_[design - 1]] = block.responses[row * width + k];
  }
}

}  // namespace prs
