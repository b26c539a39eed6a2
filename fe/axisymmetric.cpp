#include "fe/axisymmetric.h"

#include <Eigen/LU>
#include <numbers>

#include "fe/cholmod.h"

namespace fe {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;

/// Twice the area of the triangle abc, positive where it turns from r to z.
double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

using StrainMatrix = Eigen::Matrix<double, 6, 24>;

constexpr std::array<double, 3> kThreePoints{-0.7745966692414834, 0.0, 0.7745966692414834};
constexpr std::array<double, 3> kThreeWeights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
constexpr std::array<double, 5> kFivePoints{-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831,
                                            0.9061798459386640};
constexpr std::array<double, 5> kFiveWeights{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                             0.4786286704993665, 0.2369268850561891};

/// Shape functions of the 8-node serendipity element at (x, y) in [-1, 1]^2, with derivatives.
struct Shape {
  Eigen::Matrix<double, 8, 1> value;
  Eigen::Matrix<double, 8, 2> slope;
};

Shape shape(double x, double y) {
  constexpr std::array<double, 4> cx{-1.0, 1.0, 1.0, -1.0}, cy{-1.0, -1.0, 1.0, 1.0};
  Shape s;
  for (Eigen::Index k = 0; k < 4; ++k) {
    const double a = cx[static_cast<std::size_t>(k)], b = cy[static_cast<std::size_t>(k)];
    s.value[k] = 0.25 * (1.0 + a * x) * (1.0 + b * y) * (a * x + b * y - 1.0);
    s.slope(k, 0) = 0.25 * a * (1.0 + b * y) * (2.0 * a * x + b * y);
    s.slope(k, 1) = 0.25 * b * (1.0 + a * x) * (2.0 * b * y + a * x);
  }
  const auto set = [&](Eigen::Index k, double value, double dx, double dy) {
    s.value[k] = value;
    s.slope(k, 0) = dx;
    s.slope(k, 1) = dy;
  };
  set(4, 0.5 * (1.0 - x * x) * (1.0 - y), -x * (1.0 - y), -0.5 * (1.0 - x * x));
  set(5, 0.5 * (1.0 + x) * (1.0 - y * y), 0.5 * (1.0 - y * y), -y * (1.0 + x));
  set(6, 0.5 * (1.0 - x * x) * (1.0 + y), -x * (1.0 + y), 0.5 * (1.0 - x * x));
  set(7, 0.5 * (1.0 - x) * (1.0 - y * y), -0.5 * (1.0 - y * y), -y * (1.0 - x));
  return s;
}

/// Strains (rr, tt, zz, rz, rt, tz): constant + n linear.
struct Strains {
  StrainMatrix constant = StrainMatrix::Zero();
  StrainMatrix linear = StrainMatrix::Zero();
};

Strains strains(const Eigen::Matrix<double, 8, 1>& value, const Eigen::Matrix<double, 8, 2>& slope, double r) {
  Strains b;
  for (Eigen::Index k = 0; k < 8; ++k) {
    const Eigen::Index u = 3 * k, v = u + 1, w = u + 2;
    const double nr = slope(k, 0), nz = slope(k, 1), over_r = value[k] / r;
    b.constant(0, u) = nr;
    b.constant(1, u) = over_r;
    b.constant(2, w) = nz;
    b.constant(3, u) = nz;
    b.constant(3, w) = nr;
    b.constant(4, v) = nr - over_r;
    b.constant(5, v) = nz;
    b.linear(1, v) = over_r;
    b.linear(4, u) = -over_r;
    b.linear(5, w) = -over_r;
  }
  return b;
}

/// D of stress = D strain [Pa].
Eigen::Matrix<double, 6, 6> elasticity(const Isotropic& m) {
  const double shear = m.youngs_modulus / (2.0 * (1.0 + m.poisson_ratio));
  const double lame = 2.0 * shear * m.poisson_ratio / (1.0 - 2.0 * m.poisson_ratio);
  Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();
  d.topLeftCorner<3, 3>().setConstant(lame);
  d.diagonal() << lame + 2.0 * shear, lame + 2.0 * shear, lame + 2.0 * shear, shear, shear, shear;
  return d;
}

int kind_of(int harmonic) { return std::min(harmonic, 2); }

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
      const Vector2d& low = grid.point(i / 2, j / 2);
      const Vector2d& high = grid.point((i + 1) / 2, (j + 1) / 2);
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
      const std::array<Vector2d, 4> corner{grid.point(c, l), grid.point(c, l + 1), grid.point(c + 1, l + 1),
                                           grid.point(c + 1, l)};
      for (std::size_t k = 0; k < 4; ++k)
        if (!(turn(corner[k], corner[(k + 1) % 4], corner[(k + 3) % 4]) > 0.0))
          throw std::invalid_argument("a cell of the meridian mesh is turned over");
      const int i = 2 * c, j = 2 * l;
      mesh_.elements.push_back({node_at(i, j), node_at(i, j + 2), node_at(i + 2, j + 2), node_at(i + 2, j),
                                node_at(i, j + 1), node_at(i + 1, j + 2), node_at(i + 2, j + 1), node_at(i + 1, j)});
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

double circumference_factor(int harmonic) { return harmonic == 0 ? 2.0 * std::numbers::pi : std::numbers::pi; }

HarmonicStiffness element_stiffness(const MeridianMesh& mesh, int element, const Isotropic& material) {
  Eigen::Matrix<double, 8, 2> corner;
  for (std::size_t k = 0; k < 8; ++k)
    corner.row(static_cast<Eigen::Index>(k)) = at(mesh.nodes, at(mesh.elements, element)[k]).transpose();
  const Eigen::Matrix<double, 6, 6> d = elasticity(material);

  HarmonicStiffness k;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Shape s = shape(kThreePoints[i], kThreePoints[j]);
      const Eigen::Matrix2d jacobian = s.slope.transpose() * corner;
      const double determinant = jacobian.determinant();
      if (!(determinant > 0.0)) throw std::invalid_argument("an element is turned over");
      const double r = s.value.dot(corner.col(0));
      const Eigen::Matrix<double, 8, 2> slope = s.slope * jacobian.inverse().transpose();
      const double weight = kThreeWeights[i] * kThreeWeights[j] * determinant * r;
      const Strains b = strains(s.value, slope, r);
      const StrainMatrix stress_0 = weight * d * b.constant;
      const StrainMatrix stress_1 = weight * d * b.linear;
      k.constant.noalias() += b.constant.transpose() * stress_0;
      k.linear.noalias() += b.linear.transpose() * stress_0;
      k.quadratic.noalias() += b.linear.transpose() * stress_1;
    }
  k.linear += k.linear.transpose().eval();
  return k;
}

void add_edge_load(const MeridianMesh& mesh, const MeridianEdge& edge, int harmonic, const Traction& traction,
                   Eigen::Ref<Eigen::VectorXd> loads) {
  for (std::size_t i = 0; i < kFivePoints.size(); ++i) {
    const double x = kFivePoints[i];
    const std::array<double, 3> value{0.5 * x * (x - 1.0), 0.5 * x * (x + 1.0), 1.0 - x * x};
    const std::array<double, 3> slope{x - 0.5, x + 0.5, -2.0 * x};
    Vector2d point = Vector2d::Zero(), tangent = Vector2d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      point += value[k] * at(mesh.nodes, edge[k]);
      tangent += slope[k] * at(mesh.nodes, edge[k]);
    }
    const double ds = kFiveWeights[i] * tangent.norm();
    const Eigen::Vector3d force = circumference_factor(harmonic) * point.x() * ds * traction(point.x(), point.y());
    for (std::size_t k = 0; k < 3; ++k) loads.segment<kComponents>(kComponents * edge[k]) += value[k] * force;
  }
}

void add_support(std::vector<HarmonicSupport>& supports, const MeridianEdge& edge, Component c) {
  for (const int node : edge) supports.push_back({node, c});
}

HarmonicBody::HarmonicBody(const MeridianMesh& mesh, const Isotropic& material, int harmonic,
                           const std::vector<HarmonicSupport>& supports, const std::vector<HarmonicSpring>& springs)
    : kind_(kind_of(harmonic)) {
  const int equations = number_freedoms(mesh, harmonic, supports);
  Places places;
  const auto couple = [&](const std::vector<int>& rows) {
    for (const int a : rows)
      for (const int b : rows) {
        const int i = at(freedom_, a).equation, j = at(freedom_, b).equation;
        if (i >= 0 && i <= j) places.add(i, j);
      }
  };
  for (int i = 0; i < equations; ++i) places.add(i, i);
  for (const auto& element : mesh.elements) {
    std::vector<int> rows;
    for (const int node : element)
      for (int c = 0; c < kComponents; ++c) rows.push_back(kComponents * node + c);
    couple(rows);
  }
  for (const HarmonicSpring& spring : springs) {
    std::vector<int> rows;
    for (const auto& t : spring.terms) rows.push_back(row_of(t.node, t.component));
    couple(rows);
  }
  // Renumbers the equations to keep the factor small.
  const SparseSymmetric pattern = places.compressed(equations);
  const std::vector<int> place = inverse(minimum_degree_order(pattern));
  stiffness_ = permuted(pattern, place);
  for (Freedom& f : freedom_)
    if (f.equation >= 0) f.equation = at(place, f.equation);
  const auto slot = [&](int i, int j) { return static_cast<std::size_t>(slot_in(stiffness_, i, j)); };

  const std::size_t entries = stiffness_.row.size();
  for (auto* values : {&constant_, &linear_, &quadratic_, &springs_}) values->assign(entries, 0.0);
  for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
    const HarmonicStiffness k = element_stiffness(mesh, e, material);
    std::array<Freedom, 24> f;
    for (std::size_t i = 0; i < 24; ++i)
      f[i] = at(freedom_, kComponents * at(mesh.elements, e)[i / 3] + static_cast<int>(i % 3));
    for (std::size_t i = 0; i < 24; ++i)
      for (std::size_t j = 0; j < 24; ++j) {
        if (f[i].equation < 0 || f[j].equation < f[i].equation) continue;
        const std::size_t s = slot(f[i].equation, f[j].equation);
        const double sign = f[i].sign * f[j].sign;
        const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
        constant_[s] += sign * k.constant(row, column);
        linear_[s] += sign * k.linear(row, column);
        quadratic_[s] += sign * k.quadratic(row, column);
      }
  }
  for (const HarmonicSpring& spring : springs)
    for (const auto& a : spring.terms)
      for (const auto& b : spring.terms) {
        const Freedom i = at(freedom_, row_of(a.node, a.component));
        const Freedom j = at(freedom_, row_of(b.node, b.component));
        if (i.equation < 0 || j.equation < i.equation) continue;
        springs_[slot(i.equation, j.equation)] += spring.stiffness * i.sign * a.weight * j.sign * b.weight;
      }
  cholesky_ = supernodal_factorization(stiffness_);
}

int HarmonicBody::number_freedoms(const MeridianMesh& mesh, int harmonic,
                                  const std::vector<HarmonicSupport>& supports) {
  std::vector<bool> held(static_cast<std::size_t>(kComponents * mesh.size()), false);
  std::vector<bool> used(static_cast<std::size_t>(mesh.size()), false);
  for (const auto& element : mesh.elements)
    for (const int node : element) used[static_cast<std::size_t>(node)] = true;
  for (const HarmonicSupport& s : supports) held[static_cast<std::size_t>(row_of(s.node, s.component))] = true;

  double largest = 0.0;
  for (const Vector2d& p : mesh.nodes) largest = std::max(largest, p.x());
  freedom_.assign(held.size(), {});
  int equations = 0;
  for (int node = 0; node < mesh.size(); ++node) {
    if (!used[static_cast<std::size_t>(node)]) continue;
    const int u = row_of(node, Component::radial), v = row_of(node, Component::circumferential),
              w = row_of(node, Component::axial);
    const auto number = [&](int row) {
      if (!held[static_cast<std::size_t>(row)]) at(freedom_, row).equation = equations++;
    };
    if (at(mesh.nodes, node).x() > 1e-12 * largest) {
      number(u);
      if (harmonic > 0) number(v);
      number(w);
    } else if (harmonic == 0) {
      number(w);
    } else if (harmonic == 1 && !held[static_cast<std::size_t>(v)]) {
      number(u);
      at(freedom_, v) = {at(freedom_, u).equation, -1.0};
    }
  }
  return equations;
}

FactorizationStatus HarmonicBody::factorize(int harmonic) {
  assert(kind_of(harmonic) == kind_);
  const double c = circumference_factor(harmonic), n = harmonic;
  for (std::size_t k = 0; k < stiffness_.value.size(); ++k)
    stiffness_.value[k] = c * (constant_[k] + n * linear_[k] + n * n * quadratic_[k]) + springs_[k];
  return cholesky_->factorize(stiffness_);
}

MatrixXd HarmonicBody::solve(const MatrixXd& loads) {
  MatrixXd b = MatrixXd::Zero(unknowns(), loads.cols()), x(unknowns(), loads.cols());
  for (Eigen::Index row = 0; row < loads.rows(); ++row) {
    const Freedom f = freedom_[static_cast<std::size_t>(row)];
    if (f.equation >= 0) b.row(f.equation) += f.sign * loads.row(row);
  }
  cholesky_->solve(b, x);
  MatrixXd displacement = MatrixXd::Zero(loads.rows(), loads.cols());
  for (Eigen::Index row = 0; row < loads.rows(); ++row) {
    const Freedom f = freedom_[static_cast<std::size_t>(row)];
    if (f.equation >= 0) displacement.row(row) = f.sign * x.row(f.equation);
  }
  return displacement;
}

}  // namespace fe
