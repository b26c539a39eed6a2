#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace fe {

/// Mesh of the meridian half-plane of a body of revolution: points (r, z) [m], r >= 0, and 8-node
/// serendipity quadrilaterals. The corners 0 to 3 of an element turn from r to z (positive area);
/// the midside nodes 4 to 7 follow on the sides 01, 12, 23, 30.
struct MeridianMesh {
  std::vector<Eigen::Vector2d> nodes;
  std::vector<std::array<int, 8>> elements;

  int size() const { return static_cast<int>(nodes.size()); }
};

/// Side of an element: its two ends, then its middle.
using MeridianEdge = std::array<int, 3>;

/// A logically rectangular grid of straight-sided cells: `columns` along the axis, `layers`
/// outwards, any of which may be left empty (steps, flanges).
struct MeridianGrid {
  int columns = 0;
  int layers = 0;
  std::vector<Eigen::Vector2d> points;  ///< (r, z) of (columns + 1)(layers + 1) points [m].
  std::vector<bool> filled;             ///< columns times layers.

  MeridianGrid(int column_count, int layer_count);

  Eigen::Vector2d& point(int column, int layer) { return points[point_index(column, layer)]; }
  const Eigen::Vector2d& point(int column, int layer) const {
    return points[point_index(column, layer)];
  }
  bool is_filled(int column, int layer) const { return filled[cell_index(column, layer)]; }
  void set_filled(int column, int layer, bool on) { filled[cell_index(column, layer)] = on; }

  std::size_t point_index(int column, int layer) const {
    return static_cast<std::size_t>(column * (layers + 1) + layer);
  }
  std::size_t cell_index(int column, int layer) const {
    return static_cast<std::size_t>(column * layers + layer);
  }
};

/// The filled cells of a grid as a mesh. Throws std::invalid_argument where a cell is turned over
/// or a point lies at r < 0.
class MeshedGrid {
 public:
  explicit MeshedGrid(const MeridianGrid& grid);

  const MeridianMesh& mesh() const { return mesh_; }
  /// Node at a grid point, -1 where no filled cell touches it.
  int node(int column, int layer) const { return at(2 * column, 2 * layer); }
  /// Side of the cells along `layer`, from `column` to `column` + 1; it must exist.
  MeridianEdge along_axis(int column, int layer) const;
  /// Side of the cells at `column`, from `layer` to `layer` + 1; it must exist.
  MeridianEdge outwards(int column, int layer) const;

 private:
  /// Node at twice the grid coordinates.
  int at(int i, int j) const { return index_[static_cast<std::size_t>(i * stride_ + j)]; }

  int stride_ = 0;
  std::vector<int> index_;
  MeridianMesh mesh_;
};

}  // namespace fe
