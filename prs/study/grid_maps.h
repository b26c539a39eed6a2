#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "prs/model/map_axes.h"
#include "prs/study/designs.h"
#include "prs/study/row_block.h"

namespace prs {

/// A place in maps: from 0 to nodes - 1 on each axis.
using MapPlace = std::array<double, 2>;

/// Numbers at the nodes of a grid over two factors; those of the second axis are consecutive. NaN
/// where a design has none.
using GridMap = std::vector<double>;

/// Responses over the two factors of a grid.
struct GridMaps {
  std::array<MapAxis, 2> axes;
  std::vector<GridMap> responses;  ///< One per response of the study.

  std::size_t nodes() const { return axes[0].nodes() * axes[1].nodes(); }
  std::size_t node(std::size_t i, std::size_t j) const { return i * axes[1].nodes() + j; }
  /// The design at a node.
  std::size_t design(std::size_t node) const;
};

/// A map at a place, bilinear between four nodes; NaN next to a node without a number.
double map_value(const GridMaps& maps, const GridMap& map, MapPlace place);

/// Values of a study's inputs (`drawn_inputs`) at a place: as written at a node, else interpolated
/// between two nodes where the input is continuous.
std::vector<Level> inputs_at(const Study& study, const GridMaps& maps, MapPlace place);

/// Collects the maps of a study from its rows, block after block in any order.
class GridMapCollector {
 public:
  explicit GridMapCollector(const Study& study);

  void add(const RowBlock& block);

  /// Absent where the study has none, or too many numbers for them.
  const std::optional<GridMaps>& maps() const { return maps_; }

 private:
  std::optional<GridMaps> maps_;
  std::vector<std::size_t> nodes_;  ///< Nodes of designs 1, 2, ..
};

}  // namespace prs
