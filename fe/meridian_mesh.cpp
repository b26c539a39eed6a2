#include "fe/meridian_mesh.h"

#include <cassert>
#include <stdexcept>

namespace fe {
namespace {

/// Twice the area of the triangle abc, positive where it turns from r to z.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

}  // namespace

MeridianGrid::MeridianGrid(int column_count, int layer_count)
    : columns(column_count),
      layers(layer_count),
      points(static_cast<std::size_t>((column_count + 1) * (layer_count + 1))),
      filled(static_cast<std::size_t>(column_count * layer_count), true) {}

MeshedGrid::MeshedGrid(const MeridianGrid& grid) : stride_(2 * grid.layers + 1) {
  index_.assign(static_cast<std::size_t>((2 * grid.columns + 1) * stride_), -1);
  const auto node_at = [&](int i, int j) {
    int& node = index_[static_cast<std::size_t>(i * stride_ + j)];
    if (node < 0) {
      const Eigen::Vector2d& low = grid.point(i / 2, j / 2);
      const Eigen::Vector2d& high = grid.point((i + 1) / 2, (j + 1) / 2);
      node = mesh_.size();
      mesh_.nodes.push_back(0.5 * (low + high));
      if (!(mesh_.nodes.back().x() >= 0.0))
        throw std::invalid_argument("a point of the meridian mesh lies beyond the axis");
    }
    return node;
  };
  for (int c = 0; c < grid.columns; ++c)
    for (int l = 0; l < grid.layers; ++l) {
      if (!grid.is_filled(c, l)) continue;
      const std::array<Eigen::Vector2d, 4> corner{grid.point(c, l), grid.point(c, l + 1),
                                                  grid.point(c + 1, l + 1), grid.point(c + 1, l)};
      for (std::size_t k = 0; k < 4; ++k)
        if (!(turn(corner[k], corner[(k + 1) % 4], corner[(k + 3) % 4]) > 0.0))
          throw std::invalid_argument("a cell of the meridian mesh is turned over");
      const int i = 2 * c, j = 2 * l;
      mesh_.elements.push_back({node_at(i, j), node_at(i, j + 2), node_at(i + 2, j + 2),
                                node_at(i + 2, j), node_at(i, j + 1), node_at(i + 1, j + 2),
                                node_at(i + 2, j + 1), node_at(i + 1, j)});
    }
}

MeridianEdge MeshedGrid::along_axis(int column, int layer) const {
  const int i = 2 * column, j = 2 * layer;
  assert(at(i + 1, j) >= 0);
  return {at(i, j), at(i + 2, j), at(i + 1, j)};
}

MeridianEdge MeshedGrid::outwards(int column, int layer) const {
  const int i = 2 * column, j = 2 * layer;
  assert(at(i, j + 1) >= 0);
  return {at(i, j), at(i, j + 2), at(i, j + 1)};
}

}  // namespace fe
