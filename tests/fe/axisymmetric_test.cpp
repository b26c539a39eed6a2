#include "fe/axisymmetric.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>

namespace fe {
namespace {

using std::numbers::pi;

constexpr Isotropic kSteel{209e9, 0.3};

/// Rectangle between two radii and two heights.
MeridianGrid rectangle(double inner, double outer, double low, double high, int columns, int layers) {
  MeridianGrid g(columns, layers);
  for (int c = 0; c <= columns; ++c)
    for (int l = 0; l <= layers; ++l)
      g.point(c, l) = {inner + (outer - inner) * l / layers, low + (high - low) * c / columns};
  return g;
}

/// The inner points of a grid moved at random by up to `share` of a cell.
MeridianGrid distorted(MeridianGrid g, double share) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-share, share);
  const Eigen::Vector2d cell = (g.point(1, 1) - g.point(0, 0)).cwiseAbs();
  for (int c = 1; c < g.columns; ++c)
    for (int l = 1; l < g.layers; ++l)
      g.point(c, l) += cell.cwiseProduct(Eigen::Vector2d(uniform(random), uniform(random)));
  return g;
}

/// Internal forces K(n) u on the nodes [N]; at a support, less the loads there, its reaction.
Eigen::VectorXd nodal_forces(const MeridianMesh& mesh, const Isotropic& material, int harmonic,
                             const Eigen::VectorXd& displacement) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(displacement.size());
  for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
    Eigen::Matrix<double, 24, 1> u;
    for (Eigen::Index k = 0; k < 8; ++k)
      u.segment<3>(3 * k) = displacement.segment<3>(kComponents * at(mesh.elements, e)[static_cast<std::size_t>(k)]);
    const Eigen::Matrix<double, 24, 1> f = element_stiffness(mesh, e, material).at(harmonic) * u;
    for (Eigen::Index k = 0; k < 8; ++k)
      forces.segment<3>(kComponents * at(mesh.elements, e)[static_cast<std::size_t>(k)]) += f.segment<3>(3 * k);
  }
  return forces;
}

using Field = Eigen::Vector3d (*)(double r, double z);

Eigen::VectorXd sample(const MeridianMesh& mesh, const auto& field) {
  Eigen::VectorXd u(kComponents * mesh.size());
  for (int k = 0; k < mesh.size(); ++k) {
    const Eigen::Vector2d& p = mesh.nodes[static_cast<std::size_t>(k)];
    u.segment<3>(kComponents * k) = field(p.x(), p.y());
  }
  return u;
}

/// Largest force on a node that does not lie on the boundary of the rectangle.
double largest_inner_force(const MeridianMesh& mesh, const Eigen::VectorXd& force, double inner, double outer,
                           double low, double high) {
  double f = 0.0;
  for (int k = 0; k < mesh.size(); ++k) {
    const Eigen::Vector2d& p = mesh.nodes[static_cast<std::size_t>(k)];
    const auto near = [](double a, double b) { return std::abs(a - b) < 1e-9; };
    if (near(p.x(), outer) || near(p.y(), low) || near(p.y(), high)) continue;
    if (inner > 0.0 && near(p.x(), inner)) continue;
    f = std::max(f, force.segment<3>(kComponents * k).cwiseAbs().maxCoeff());
  }
  return f;
}

struct NamedField {
  const char* name;
  int harmonic;
  Field field;
};

/// Uniform strains; each is in equilibrium without body forces.
const NamedField kLinearFields[] = {
    {"radial stretch", 0, [](double r, double) { return Eigen::Vector3d(r, 0.0, 0.0); }},
    {"axial stretch", 0, [](double, double z) { return Eigen::Vector3d(0.0, 0.0, z); }},
    {"shear", 1, [](double, double z) { return Eigen::Vector3d(z, -z, 0.0); }},
    {"plane shear", 2, [](double r, double) { return Eigen::Vector3d(r, -r, 0.0); }},
};

TEST(Axisymmetric, PatchTestOnDistortedMesh) {
  for (const double inner : {0.0, 2e-3}) {
    const MeshedGrid g(distorted(rectangle(inner, 7e-3, -1e-3, 5e-3, 6, 5), 0.3));
    for (const NamedField& f : kLinearFields) {
      SCOPED_TRACE(f.name);
      const Eigen::VectorXd force = nodal_forces(g.mesh(), kSteel, f.harmonic, sample(g.mesh(), f.field));
      EXPECT_LT(largest_inner_force(g.mesh(), force, inner, 7e-3, -1e-3, 5e-3), 1e-13 * force.cwiseAbs().maxCoeff());
    }
  }
}

TEST(Axisymmetric, RigidMotionsMeetNoForce) {
  const NamedField rigid[] = {
      {"axial", 0, [](double, double) { return Eigen::Vector3d(0.0, 0.0, 1.0); }},
      {"lateral", 1, [](double, double) { return Eigen::Vector3d(1.0, -1.0, 0.0); }},
      {"rotation", 1, [](double r, double z) { return Eigen::Vector3d(z, -z, -r); }},
  };
  const MeshedGrid g(distorted(rectangle(0.0, 0.7, -0.1, 0.5, 6, 5), 0.3));
  const double scale = nodal_forces(g.mesh(), kSteel, 2, sample(g.mesh(), kLinearFields[3].field)).norm();
  for (const NamedField& f : rigid) {
    const Eigen::VectorXd u = sample(g.mesh(), f.field);
    EXPECT_LT(nodal_forces(g.mesh(), kSteel, f.harmonic, u).norm(), 1e-13 * scale) << f.name;
  }
}

TEST(Axisymmetric, QuadraticFieldsAreSolvedExactly) {
  // Pure bending with its anticlastic part, curvature -1: u_x = -(z^2 + nu (x^2 - y^2))/2,
  // u_y = -nu x y, u_z = x z; and the plane harmonic field grad(r^3 cos(3 theta)).
  const auto bending = [](double r, double z) {
    const double nu = kSteel.poisson_ratio;
    return Eigen::Vector3d(-0.5 * (z * z + nu * r * r), 0.5 * (z * z - nu * r * r), r * z);
  };
  const auto plane = [](double r, double) { return Eigen::Vector3d(r * r, -r * r, 0.0); };
  const MeshedGrid g(rectangle(0.0, 0.7, 0.0, 2.0, 8, 4));
  const auto check = [&](int harmonic, const Eigen::VectorXd& u, const std::vector<HarmonicSupport>& supports) {
    const Eigen::VectorXd force = nodal_forces(g.mesh(), kSteel, harmonic, u);
    EXPECT_LT(largest_inner_force(g.mesh(), force, 0.0, 0.7, 0.0, 2.0), 1e-12 * force.norm());
    HarmonicBody body(g.mesh(), kSteel, harmonic, supports);
    ASSERT_EQ(body.factorize(harmonic), FactorizationStatus::ok);
    EXPECT_LT((body.solve(force) - u).norm(), 1e-10 * u.norm());
  };
  // The point (0, 0) of the axis and the axial displacement of the face z = 0 are held.
  std::vector<HarmonicSupport> held{{g.node(0, 0), Component::radial}};
  for (int l = 0; l < 4; ++l) add_support(held, g.outwards(0, l), Component::axial);
  check(1, sample(g.mesh(), bending), held);
  check(3, sample(g.mesh(), plane), {});
}

/// Relative error of the radial displacement at the bore of a thick cylinder under inner pressure, plane strain,
/// against Lame.
double lame_error(int elements) {
  const double a = 1.0, b = 3.0, p = 1e6;
  const MeshedGrid g(rectangle(a, b, 0.0, 0.5, 1, elements));
  std::vector<HarmonicSupport> held;
  for (int l = 0; l < elements; ++l)
    for (const int c : {0, 1}) add_support(held, g.outwards(c, l), Component::axial);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(kComponents * g.mesh().size());
  add_edge_load(
      g.mesh(), g.along_axis(0, 0), 0, [&](double, double) { return Eigen::Vector3d(p, 0.0, 0.0); }, load);
  HarmonicBody body(g.mesh(), kSteel, 0, held);
  EXPECT_EQ(body.factorize(0), FactorizationStatus::ok);
  const double u = body.solve(load)(row_of(g.node(0, 0), Component::radial), 0);
  const double nu = kSteel.poisson_ratio;
  const double exact =
      (1.0 + nu) / kSteel.youngs_modulus * p * a * a / (b * b - a * a) * ((1.0 - 2.0 * nu) * a + b * b / a);
  return std::abs(u / exact - 1.0);
}

TEST(Axisymmetric, LameCylinderConvergesWithFourthOrder) {
  const double coarse = lame_error(4), middle = lame_error(8), fine = lame_error(16);
  EXPECT_LT(fine, 4e-6);
  EXPECT_NEAR(std::log2(coarse / middle), 4.0, 0.5);
  EXPECT_NEAR(std::log2(middle / fine), 4.0, 0.25);
}

TEST(Axisymmetric, AxialBarIsExact) {
  const double radius = 3e-3, length = 20e-3, p = 1e8;
  const MeshedGrid g(rectangle(0.0, radius, 0.0, length, 5, 3));
  std::vector<HarmonicSupport> held;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(kComponents * g.mesh().size());
  for (int l = 0; l < 3; ++l) {
    add_support(held, g.outwards(0, l), Component::axial);
    add_edge_load(
        g.mesh(), g.outwards(5, l), 0, [&](double, double) { return Eigen::Vector3d(0.0, 0.0, p); }, load);
  }
  double force = 0.0;
  for (int k = 0; k < g.mesh().size(); ++k) force += load[row_of(k, Component::axial)];
  EXPECT_NEAR(force, p * pi * radius * radius, 1e-12 * force);
  HarmonicBody body(g.mesh(), kSteel, 0, held);
  ASSERT_EQ(body.factorize(0), FactorizationStatus::ok);
  const Eigen::VectorXd u = body.solve(load);
  const double e = p / kSteel.youngs_modulus, nu = kSteel.poisson_ratio;
  const Eigen::VectorXd exact =
      sample(g.mesh(), [&](double r, double z) { return Eigen::Vector3d(-nu * e * r, 0.0, e * z); });
  EXPECT_LT((u - exact).norm(), 1e-11 * exact.norm());
}

TEST(Axisymmetric, CantileverTendsToTimoshenko) {
  // The clamped end shortens the cantilever by a fixed share of the radius (here 0.044), an error
  // of first order in radius/length, which two lengths eliminate; the next order tends to zero.
  const double radius = 1.0, p = 1.0, nu = kSteel.poisson_ratio, e = kSteel.youngs_modulus;
  std::vector<double> errors;
  for (const double length : {10.0, 20.0, 40.0}) {
    const int columns = static_cast<int>(2.0 * length);
    const MeshedGrid g(rectangle(0.0, radius, 0.0, length, columns, 4));
    std::vector<HarmonicSupport> held;
    Eigen::VectorXd load = Eigen::VectorXd::Zero(kComponents * g.mesh().size());
    for (int l = 0; l < 4; ++l) {
      for (const Component c : {Component::radial, Component::circumferential, Component::axial})
        add_support(held, g.outwards(0, l), c);
      add_edge_load(
          g.mesh(), g.outwards(columns, l), 1, [&](double, double) { return Eigen::Vector3d(p, -p, 0.0); }, load);
    }
    HarmonicBody body(g.mesh(), kSteel, 1, held);
    ASSERT_EQ(body.factorize(1), FactorizationStatus::ok);
    const double force = p * pi * radius * radius;
    const double deflection = load.dot(body.solve(load).col(0)) / force;
    const double inertia = pi / 4.0 * std::pow(radius, 4), area = pi * radius * radius;
    const double bending = force * std::pow(length, 3) / (3.0 * e * inertia);
    const double shear = force * length * 2.0 * (1.0 + nu) / e * (7.0 + 6.0 * nu) / (6.0 * (1.0 + nu) * area);
    errors.push_back(deflection / (bending + shear) - 1.0);
  }
  EXPECT_NEAR(errors[0], -0.0133, 1e-3);
  EXPECT_LT(std::abs(2.0 * errors[1] - errors[0]), 5e-4);
  EXPECT_LT(std::abs(2.0 * errors[2] - errors[1]), 1e-4);
}

/// Relative error of the sinking of the centre of a Hertz pressure on a circle of radius 1 against its edge, on a block
/// that is 30 radii wide and deep, against the half-space.
double hertz_patch_error(int cells) {
  const double size = 30.0, p = 1.0, nu = kSteel.poisson_ratio;
  MeridianGrid grid(cells, cells);
  const int edge = cells / 4;  // cells under the pressure
  // Equal cells under the pressure, then growing ones; the same downwards.
  std::vector<double> x;
  const double growth = std::pow(size, 1.0 / (cells - edge));
  for (int k = 0; k <= cells; ++k) x.push_back(k <= edge ? static_cast<double>(k) / edge : std::pow(growth, k - edge));
  for (int c = 0; c <= cells; ++c)
    for (int l = 0; l <= cells; ++l)
      grid.point(c, l) = {x[static_cast<std::size_t>(l)], -x[static_cast<std::size_t>(cells - c)]};
  const MeshedGrid g(grid);
  std::vector<HarmonicSupport> held;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(kComponents * g.mesh().size());
  for (int l = 0; l < cells; ++l) add_support(held, g.outwards(0, l), Component::axial);
  const auto pressure = [&](double r, double) {
    return Eigen::Vector3d(0.0, 0.0, -p * std::sqrt(std::max(0.0, 1.0 - r * r)));
  };
  for (int l = 0; l < edge; ++l) add_edge_load(g.mesh(), g.outwards(cells, l), 0, pressure, load);
  HarmonicBody body(g.mesh(), kSteel, 0, held);
  EXPECT_EQ(body.factorize(0), FactorizationStatus::ok);
  const Eigen::MatrixXd u = body.solve(load);
  const auto sink = [&](int layer) { return -u(row_of(g.node(cells, layer), Component::axial), 0); };
  const double exact = pi / 4.0 * (1.0 - nu * nu) * p / kSteel.youngs_modulus;
  return std::abs((sink(0) - sink(edge)) / exact - 1.0);
}

TEST(Axisymmetric, HertzPressureSinksIntoABlockAsIntoAHalfSpace) {
  // u_z = (1 - nu^2)/E pi p_0/(4 a) (2 a^2 - r^2) under the pressure (Johnson, Contact Mechanics,
  // (3.41a)): centre less edge is pi/4 (1 - nu^2) p_0 a/E; distant boundaries add a constant.
  const double coarse = hertz_patch_error(16), fine = hertz_patch_error(48);
  EXPECT_LT(coarse, 2e-2);
  EXPECT_LT(fine, 1.5e-3);
  EXPECT_LT(fine, 0.3 * coarse);
}

TEST(Axisymmetric, FlexibilityIsSymmetric) {
  const MeshedGrid g(distorted(rectangle(0.0, 2.0, 0.0, 3.0, 6, 5), 0.2));
  for (const int n : {0, 1, 2, 7}) {
    std::vector<HarmonicSupport> held;
    for (int l = 0; l < 5; ++l) add_support(held, g.outwards(0, l), Component::axial);
    held.push_back({g.node(0, 0), Component::radial});
    Eigen::MatrixXd load = Eigen::MatrixXd::Zero(kComponents * g.mesh().size(), 3);
    const auto traction = [](double, double) { return Eigen::Vector3d(-1.0, 0.5, 0.3); };
    add_edge_load(g.mesh(), g.along_axis(1, 5), n, traction, load.col(0));
    add_edge_load(g.mesh(), g.along_axis(4, 5), n, traction, load.col(1));
    add_edge_load(g.mesh(), g.outwards(6, 2), n, traction, load.col(2));
    HarmonicBody body(g.mesh(), kSteel, n, held);
    ASSERT_EQ(body.factorize(n), FactorizationStatus::ok);
    const Eigen::Matrix3d c = load.transpose() * body.solve(load);
    EXPECT_LT((c - c.transpose()).norm(), 1e-12 * c.norm()) << n;
    EXPECT_GT(c.determinant(), 0.0);
  }
}

TEST(Axisymmetric, SpringActsOnItsWeightedSum) {
  // A rigid sideways motion of a free body on one spring: force over stiffness.
  const MeshedGrid g(rectangle(0.0, 1.0, 0.0, 2.0, 2, 2));
  HarmonicSpring spring;
  spring.stiffness = 1e3;
  for (const int column : {0, 2}) {
    spring.terms.push_back({g.node(column, 0), Component::radial, 0.5});
  }
  HarmonicSpring against_rotation;
  against_rotation.stiffness = 1e3;
  against_rotation.terms = {{g.node(0, 0), Component::radial, 1.0}, {g.node(2, 0), Component::radial, -1.0}};
  HarmonicBody body(g.mesh(), kSteel, 1, {}, {spring, against_rotation});
  ASSERT_EQ(body.factorize(1), FactorizationStatus::ok);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(kComponents * g.mesh().size());
  load[row_of(g.node(1, 0), Component::radial)] = 5.0;
  const Eigen::MatrixXd u = body.solve(load);
  EXPECT_NEAR(0.5 * (u(row_of(g.node(0, 0), Component::radial), 0) + u(row_of(g.node(2, 0), Component::radial), 0)),
              5e-3, 2e-8);
}

TEST(MeshedGrid, RefusesCellsThatAreTurnedOver) {
  MeridianGrid g = rectangle(0.0, 1.0, 0.0, 1.0, 2, 2);
  g.point(1, 1) = {2.0, 2.0};
  EXPECT_THROW(MeshedGrid{g}, std::invalid_argument);
}

TEST(MeshedGrid, EmptyCellsHaveNoNodes) {
  MeridianGrid g = rectangle(0.0, 1.0, 0.0, 1.0, 2, 2);
  g.set_filled(1, 1, false);
  const MeshedGrid m(g);
  EXPECT_EQ(m.node(2, 2), -1);
  EXPECT_GE(m.node(1, 2), 0);
  EXPECT_EQ(m.mesh().size(), 8 + 5 + 5);
}

}  // namespace
}  // namespace fe
