#pragma once

#include <array>
#include <functional>

#include "fe/cholesky.h"

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
  const Eigen::Vector2d& point(int column, int layer) const { return points[point_index(column, layer)]; }
  bool is_filled(int column, int layer) const { return filled[cell_index(column, layer)]; }
  void set_filled(int column, int layer, bool on) { filled[cell_index(column, layer)] = on; }

  std::size_t point_index(int column, int layer) const {
    return static_cast<std::size_t>(column * (layers + 1) + layer);
  }
  std::size_t cell_index(int column, int layer) const { return static_cast<std::size_t>(column * layers + layer); }
};

/// The filled cells of a grid as a mesh. Throws std::invalid_argument if a cell is turned over or a point
/// has r < 0.
class MeshedGrid {
 public:
  explicit MeshedGrid(const MeridianGrid& grid);

  const MeridianMesh& mesh() const { return mesh_; }
  /// Node at a grid point, -1 if no filled cell touches the point.
  int node(int column, int layer) const { return at(2 * column, 2 * layer); }
  /// Side of the cells along `layer`, from `column` to `column` + 1; it must exist.
  MeridianEdge along_axis(int column, int layer) const;
  /// Side of the cells at `column`, from `layer` to `layer` + 1; it must exist.
  MeridianEdge outwards(int column, int layer) const;

 private:
  /// Node at the grid point (i/2, j/2); with an odd i or j the middle of a side.
  int at(int i, int j) const { return index_[static_cast<std::size_t>(i * stride_ + j)]; }

  int stride_ = 0;
  std::vector<int> index_;
  MeridianMesh mesh_;
};

// Bodies of revolution under loads expanded in Fourier series around the axis (Wilson, AIAA J. 3,
// 1965; Zienkiewicz and Taylor, The Finite Element Method, vol. 2, chapter on semi-analytical
// processes). The displacement of harmonic n, symmetric about the plane theta = 0, is
//
//     u_r = U(r, z) cos(n theta),  u_theta = V(r, z) sin(n theta),  u_z = W(r, z) cos(n theta),
//
// and harmonics are uncoupled. n = 0 has no V: torsion is left out. Vectors over the mesh
// hold (U, V, W) of node after node [m], nodal loads the work-conjugate forces [N]: load times
// displacement is the work over the whole circumference, so that the loads contain
//
//     c_n = 2 pi for n = 0 (int cos^2 over the circle), pi for n >= 1.

/// Displacements of a harmonic: U, V and W.
enum class Component { radial, circumferential, axial };
inline constexpr int kComponents = 3;

/// Row of a component of a node in vectors over the mesh.
constexpr int row_of(int node, Component c) { return kComponents * node + static_cast<int>(c); }

/// c_n [-].
double circumference_factor(int harmonic);

/// Linear elastic, isotropic material.
struct Isotropic {
  double youngs_modulus = 0.0;  ///< E [Pa], > 0.
  double poisson_ratio = 0.0;   ///< nu, -1 < nu < 1/2.
};

using HarmonicMatrix = Eigen::Matrix<double, 24, 24>;

/// Stiffness of one element over (U, V, W) of its nodes, for all harmonics at once [N/m]:
///
///     K(n) = c_n (constant + n linear + n^2 quadratic),
///
/// since the strains are B_0 + n B_1: e_rr = U,r, e_tt = (U + n V)/r, e_zz = W,z,
/// g_rz = U,z + W,r, g_rt = V,r - (V + n U)/r, g_tz = V,z - n W/r. 3 x 3 Gauss points.
struct HarmonicStiffness {
  HarmonicMatrix constant = HarmonicMatrix::Zero();
  HarmonicMatrix linear = HarmonicMatrix::Zero();
  HarmonicMatrix quadratic = HarmonicMatrix::Zero();

  HarmonicMatrix at(int harmonic) const {
    return circumference_factor(harmonic) * (constant + harmonic * linear + harmonic * harmonic * quadratic);
  }
};

HarmonicStiffness element_stiffness(const MeridianMesh& mesh, int element, const Isotropic& material);

/// Amplitudes (t_r cos, t_theta sin, t_z cos) of the traction of one harmonic [Pa] at (r, z) [m].
using Traction = std::function<Eigen::Vector3d(double r, double z)>;

/// Adds the consistent nodal loads c_n int N t r ds of a traction on one edge to `loads` [N]. Five
/// Gauss points: exact on a straight edge for tractions up to the sixth order in s.
void add_edge_load(const MeridianMesh& mesh, const MeridianEdge& edge, int harmonic, const Traction& traction,
                   Eigen::Ref<Eigen::VectorXd> loads);

/// Support that holds one component of one node.
struct HarmonicSupport {
  int node = 0;
  Component component = Component::axial;
};

/// Holds a component of all three nodes of an edge.
void add_support(std::vector<HarmonicSupport>& supports, const MeridianEdge& edge, Component c);

/// A linear spring on a weighted sum of displacements: energy 1/2 stiffness (sum w q)^2 [J].
struct HarmonicSpring {
  struct Term {
    int node = 0;
    Component component = Component::axial;
    double weight = 0.0;
  };
  std::vector<Term> terms;
  double stiffness = 0.0;  ///< [N/m]
};

/// Equations of one body for harmonics of one kind, n = 0, n = 1 or n >= 2, which differ in the displacements of the
/// axis: U = V = 0 for n = 0, V = -U and W = 0 for n = 1 (a point of the axis moves sideways), U = V = W = 0 above.
/// Pattern, order and symbolic factorization are computed once. Without supports the stiffness is singular for n = 0
/// (axial translation) and n = 1 (lateral translation and rotation); for n >= 2 it never is.
class HarmonicBody {
 public:
  HarmonicBody(const MeridianMesh& mesh, const Isotropic& material, int harmonic,
               const std::vector<HarmonicSupport>& supports = {}, const std::vector<HarmonicSpring>& springs = {});

  /// Recomputes the stiffness for a harmonic of the same kind as at construction, and factorizes it.
  FactorizationStatus factorize(int harmonic);

  /// Displacements over the mesh, one column for each column of nodal loads. Loads on held
  /// components go into the supports. The last factorization must have been `ok`.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& loads);

  int unknowns() const { return stiffness_.size(); }

 private:
  /// Equation of a row and its sign. The equation is -1 if the row is held.
  struct Freedom {
    int equation = -1;
    double sign = 1.0;
  };

  /// Number of equations.
  int number_freedoms(const MeridianMesh& mesh, int harmonic, const std::vector<HarmonicSupport>& supports);

  int kind_ = 0;
  std::vector<Freedom> freedom_;
  SparseSymmetric stiffness_;
  std::vector<double> constant_, linear_, quadratic_;  ///< Terms of K(n)/c_n, on the pattern.
  std::vector<double> springs_;
  std::unique_ptr<SparseFactorization> cholesky_;
};

}  // namespace fe
