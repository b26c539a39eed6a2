#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "prs/study/row_block.h"
#include "prs/model/study.h"

namespace prs {

/// A factor of a grid as an axis of its maps, numbers ascending.
struct MapAxis {
  std::size_t factor = 0;           ///< Of the study's.
  std::vector<std::size_t> levels;  ///< Of the factor, one a node.
  std::vector<double> numbers;      ///< Of the levels, in the factor's unit.
  bool logarithmic = false;         ///< Equidistant in their logarithm.
  /// Whether factor and companions have values between two nodes: no words, no whole numbers.
  bool continuous = false;

  std::size_t nodes() const { return numbers.size(); }
  /// The factor's number at a place from 0, the first node, to nodes - 1: linear between two nodes,
  /// or linear in the logarithm.
  double number(double place) const;
  /// The place of a number; absent outside of the nodes.
  std::optional<double> place(double number) const;
};

/// A place in maps: from 0 to nodes - 1 on each axis.
using MapPlace = std::array<double, 2>;

/// Numbers at the nodes of a grid over two factors; those of the second axis are consecutive. NaN
/// where a design has none.
using GridMap = std::vector<double>;

/// Responses over the two factors of a grid.
struct GridMaps {
  std::array<MapAxis, 2> axes;
  std::vector<GridMap> responses;  ///< One a response of the study.

  std::size_t nodes() const { return axes[0].nodes() * axes[1].nodes(); }
  std::size_t node(std::size_t i, std::size_t j) const { return i * axes[1].nodes() + j; }
  /// The design at a node.
  std::size_t design(std::size_t node) const;
};

/// Numbers that maps of one study may have: nodes x responses.
inline constexpr std::size_t kMostMapValues = 8'000'000;

/// The axes of the maps of a study: a grid over two factors of at least two different numbers each.
/// Absent of any other.
std::optional<std::array<MapAxis, 2>> map_axes(const Study& study);

/// A map at a place, bilinear between four nodes; NaN next to a node without a number.
double map_value(const GridMaps& maps, const GridMap& map, MapPlace place);

/// What the inputs of a study, `drawn_inputs`, are at a place: as they are written at a node, else
/// between two nodes as far as they are continuous.
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
  std::vector<std::size_t> nodes_;  ///< Of designs 1, 2, ..
};

}  // namespace prs
