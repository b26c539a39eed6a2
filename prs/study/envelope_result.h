#pragma once

#include "prs/model/map_axes.h"
#include "prs/study/designs.h"

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

/// A measure over the grid.
struct MeasureMap {
  std::size_t response = 0;    ///< Index among the study's responses.
  double weight = 1.0;         ///< w_i
  double rms = 0.0;            ///< Root mean square of all its numbers, in its unit.
  double normalised_by = 1.0;  ///< n_i, in its unit.
  std::size_t without = 0;     ///< Nodes without a number.
};

/// A design read off the envelope, between two nodes by interpolation.
struct EnvelopePoint {
  std::string name;
  std::string reason = {};  ///< Why there is no such design; empty where there is one.
  MapPlace place = {};
  std::optional<std::size_t> design = {};  ///< The node's design, if it has one.
  std::vector<Level> inputs = {};          ///< One per drawn input (`drawn_inputs`).
  std::vector<double> responses = {};      ///< All of the study's; NaN next to designs without.
  std::vector<double> normalised = {};     ///< m_i / n_i, one per measure.
  double envelope = 0.0;
};

/// An envelope over the grid and the designs read off it.
struct EnvelopeResult {
  std::vector<MeasureMap> measures;
  GridMap values;    ///< E; NaN where it is not defined, as for a root of a negative measure.
  double rms = 0.0;  ///< Root mean square of the values.
  std::size_t without = 0;               ///< Nodes without a value.
  std::optional<std::size_t> best = {};  ///< The first node with the largest value.
  std::vector<EnvelopePoint> points;
};

/// The envelope of a study that has one. Each response is bilinear between four nodes, E is that of
/// the responses at the place.
EnvelopeResult evaluate_envelope(const Study& study, const GridMaps& maps);

/// m_i / n_i over the grid.
GridMap normalised(const GridMaps& maps, const MeasureMap& measure);

}  // namespace prs
