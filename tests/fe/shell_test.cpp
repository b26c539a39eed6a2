#include "fe/shell.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "fe/cholesky.h"
#include "fe/equations.h"
#include "fe/newton.h"
#include "support/count.h"
#include "support/finite_difference.h"
#include "support/sanitized.h"
#include "support/tangent.h"

namespace fe {
namespace {

using std::numbers::pi;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kModulus = 209e9, kPoisson = 0.3;

using ShellRigidity = ShellRigidityOf<double>;

ShellMatrix stiffness_matrix(const ShellRigidity& shell, double length) {
  return to_matrix(shell_blocks(shell, length));
}

ShellRigidity tube(double inner, double outer, double reference, double poisson = kPoisson) {
  return tube_rigidity(inner, outer, reference, kModulus, poisson, kModulus / (2.0 * (1.0 + kPoisson)));
}

ShellRigidity random_tube(std::mt19937_64& random) {
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const double inner = uniform(1e-3, 50e-3), outer = inner * uniform(1.02, 3.0);
  return tube(inner, outer, uniform(inner, 1.5 * outer - 0.5 * inner), uniform(0.0, 0.45));
}

/// Integral of f over [a, b] by Simpson's rule.
template <class F>
double integral(F f, double a, double b, int cells) {
  const double h = (b - a) / cells;
  double sum = 0.0;
  for (int i = 0; i < cells; ++i) sum += f(a + i * h) + 4.0 * f(a + (i + 0.5) * h) + f(a + (i + 1) * h);
  return sum * h / 6.0;
}

/// A chain of equal or unequal shells along one line of nodes.
Model chain(const std::vector<ShellMatrix>& shells) {
  Model m;
  m.add_node();
  for (const ShellMatrix& k : shells) {
    const int next = m.add_node();
    m.shells.push_back({next - 1, next, k});
  }
  return m;
}

Eigen::MatrixXd dense_stiffness(const Model& m) {
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(3 * m.nodes, 3 * m.nodes);
  for (const ShellElement& e : m.shells) k.block<6, 6>(3 * e.first, 3 * e.first) += nodal_stiffness(e.stiffness);
  return k;
}

TEST(Shell, RigiditiesAreTheIntegralsOverTheWall) {
  const double a = 17.5e-3, b = 23e-3, r0 = 24e-3, plane = kModulus / (1.0 - kPoisson * kPoisson);
  const ShellRigidity s = tube(a, b, r0);
  const auto over_wall = [&](auto f) { return plane * 2.0 * pi * integral(f, a, b, 200); };
  const auto z = [&](double r) { return r - r0; };
  EXPECT_NEAR(s.axial / over_wall([&](double r) { return r; }), 1.0, 1e-12);
  EXPECT_NEAR(s.eccentric / over_wall([&](double r) { return z(r) * r; }), 1.0, 1e-12);
  EXPECT_NEAR(s.bending / over_wall([&](double r) { return z(r) * z(r) * r; }), 1.0, 1e-12);
  EXPECT_NEAR(s.hoop / over_wall([&](double r) { return 1.0 / r; }), 1.0, 1e-11);
  EXPECT_NEAR(s.axial_hoop / over_wall([&](double) { return kPoisson; }), 1.0, 1e-12);
  EXPECT_NEAR(s.bending_hoop / over_wall([&](double r) { return kPoisson * z(r); }), 1.0, 1e-12);
  EXPECT_NEAR(s.shear / (kModulus / 2.6 * 5.0 / 6.0 * pi * (b * b - a * a)), 1.0, 1e-12);
}

TEST(Shell, StiffnessIsPositiveDefinite) {
  std::mt19937_64 random(1);
  for (int i = 0; i < test::count(200, 20000); ++i) {
    const double length = std::pow(10.0, std::uniform_real_distribution<double>(-6, 0)(random));
    ShellRigidity shell = random_tube(random);
    shell.radially_rigid = i % 4 == 0;
    const ShellMatrix k = stiffness_matrix(shell, length);
    ASSERT_EQ((k - k.transpose()).norm(), 0.0);
    // Forces and moments in units of the same size.
    const ShellMatrix scaled =
        k.diagonal().cwiseSqrt().cwiseInverse().asDiagonal() * k * k.diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
    ASSERT_EQ(scaled.llt().info(), Eigen::Success) << i << ' ' << length;
  }
}

TEST(Shell, ThreeThirdsMakeAWhole) {
  std::mt19937_64 random(2);
  for (int i = 0; i < test::count(100, 5000); ++i) {
    const ShellRigidity shell = random_tube(random);
    const double length = std::pow(10.0, std::uniform_real_distribution<double>(-4, -1)(random));
    const ShellMatrix third = stiffness_matrix(shell, length / 3.0);
    const Eigen::MatrixXd k = dense_stiffness(chain({third, third, third}));
    const Eigen::Matrix<double, 6, 6> inner = k.block<6, 6>(3, 3);
    Eigen::Matrix<double, 6, 6> coupling, outer = Matrix6::Zero();
    coupling << k.block<6, 3>(3, 0), k.block<6, 3>(3, 9);
    outer.topLeftCorner<3, 3>() = k.topLeftCorner<3, 3>();
    outer.bottomRightCorner<3, 3>() = k.bottomRightCorner<3, 3>();
    outer -= coupling.transpose() * inner.llt().solve(coupling);
    const Matrix6 whole = nodal_stiffness(stiffness_matrix(shell, length));
    const Vector6 size = whole.diagonal().cwiseSqrt();
    const Matrix6 error = size.cwiseInverse().asDiagonal() * (outer - whole) * size.cwiseInverse().asDiagonal();
    ASSERT_LT(error.cwiseAbs().maxCoeff(), 2e-10) << i;
  }
}

TEST(Shell, ConstantStrainNeedsForcesAtTheEndsOnly) {
  const double strain = 1e-4;
  const ShellRigidity s = tube(17.5e-3, 23e-3, 25e-3);
  const double v = -s.axial_hoop / s.hoop * strain;  // H v + C u' = 0
  const double tension = s.axial * strain + s.axial_hoop * v;
  const double moment = -(s.eccentric * strain + s.bending_hoop * v);  // moment of u, about r_0
  std::vector<ShellMatrix> shells;
  Eigen::VectorXd q(15);
  double x = 0.0;
  for (int node = 0; node < 5; ++node) {
    q.segment<3>(3 * node) << strain * x + 7e-6, v, 0.0;
    const double length = 1e-3 * (1 + 3 * node);
    if (node < 4) shells.push_back(stiffness_matrix(s, length));
    x += length;
  }
  const Eigen::VectorXd f = dense_stiffness(chain(shells)) * q;
  EXPECT_LT(f.segment<9>(3).norm(), 1e-10 * tension);
  EXPECT_NEAR(f[12] / tension, 1.0, 1e-10);
  EXPECT_NEAR(f[14] / moment, 1.0, 1e-10);
  EXPECT_NEAR(f[13] / tension, 0.0, 1e-10);
  EXPECT_NEAR(f[0] / -tension, 1.0, 1e-10);
  EXPECT_NEAR(f[2] / -moment, 1.0, 1e-10);
}

TEST(Shell, AThinTubeStretchesLikeABar) {
  const double r = 0.02, h = 1e-4 * r, strain = 1e-3;
  const ShellRigidity s = tube(r - 0.5 * h, r + 0.5 * h, r);
  const double v = -s.axial_hoop / s.hoop * strain;
  EXPECT_NEAR(v / (-kPoisson * r * strain), 1.0, 1e-7);
  EXPECT_NEAR((s.axial * strain + s.axial_hoop * v) / (kModulus * 2.0 * pi * r * h * strain), 1.0, 1e-7);
}

TEST(Shell, AxialMotionIsFreeOfForce) {
  const ShellMatrix k = stiffness_matrix(tube(17.5e-3, 23e-3, 24e-3), 1.7e-3);
  const Equations equations(chain({k, k, k}));
  Eigen::VectorXd q = Eigen::VectorXd::Zero(equations.size());
  for (int node = 0; node < 4; ++node) q[equations.number(node, Dof::u)] = 0.123456789;
  Eigen::VectorXd r(equations.size());
  const double energy = equations.energy_and_residual(q, Eigen::VectorXd::Zero(q.size()), r);
  EXPECT_EQ(r.norm(), 0.0);
  EXPECT_EQ(energy, 0.0);
}

TEST(Shell, AnotherRadiusForUIsAnotherReference) {
  const ShellMatrix moved = to_matrix(about(shell_blocks(tube(17.5e-3, 23e-3, 23e-3), 6e-3), 1.5e-3));
  const ShellMatrix direct = stiffness_matrix(tube(17.5e-3, 23e-3, 24.5e-3), 6e-3);
  const Eigen::Matrix<double, 5, 1> size = direct.diagonal().cwiseSqrt().cwiseInverse();
  EXPECT_LT((size.asDiagonal() * (moved - direct) * size.asDiagonal()).cwiseAbs().maxCoeff(), 1e-11);
}

/// Radial displacement under a unit ring load on an endless shell, from Fourier's integral: of
/// v = V cos(kx), u = U sin(kx), theta = Q sin(kx) the energy is a form in (U, Q, V),
///
///     v(0) = 1/pi int_0^inf [M(k)^-1]_VV dk.
double ring_displacement(const ShellRigidity& s, double wave_number) {
  const auto flexibility = [&](double k) {
    Eigen::Matrix3d m;
    const double uq = -s.eccentric * k * k, uv = s.axial_hoop * k;
    const double qv = -s.bending_hoop * k + s.shear * k;
    m << s.axial * k * k, uq, uv, uq, s.bending * k * k + s.shear, qv, uv, qv, s.hoop + s.shear * k * k;
    return m.ldlt().solve(Eigen::Vector3d::UnitZ()).z();
  };
  const auto turned = [&](double t) {  // k = k_0 tan(t)
    const double c = std::cos(t);
    return flexibility(wave_number * std::tan(t)) * wave_number / (c * c);
  };
  return integral(turned, 1e-6, 0.5 * pi - 1e-6, 20000) / pi;
}

/// Displacement on a long chain of `shells` lengths to both sides.
double ring_displacement_of_chain(const ShellRigidity& s, double length, int shells) {
  const std::vector<ShellMatrix> all(2 * static_cast<std::size_t>(shells), stiffness_matrix(s, length));
  Model m = chain(all);
  m.fixed_supports.push_back({0, Dof::u});
  const Equations equations(m);
  Cholesky cholesky(equations.linear_stiffness());
  EXPECT_EQ(cholesky.factorize(equations.linear_stiffness()), FactorizationStatus::ok);
  Eigen::VectorXd q(equations.size());
  cholesky.solve(equations.load_vector({{shells, Dof::v, 1.0}}), q);
  return q[equations.number(shells, Dof::v)];
}

TEST(Shell, RingLoadOnALongTube) {
  SKIP_UNDER_SANITIZERS();
  for (const double outer : {18e-3, 23e-3, 31e-3})
    for (const double reference : {19e-3, 26e-3}) {
      const ShellRigidity s = tube(17.5e-3, outer, reference);
      const double expected = ring_displacement(s, 200.0);
      for (const double length : {1e-3, 25e-3}) {
        const int shells = static_cast<int>(0.3 / length);
        EXPECT_NEAR(ring_displacement_of_chain(s, length, shells) / expected, 1.0, 1e-5)
            << outer << ' ' << reference << ' ' << length;
      }
    }
}

TEST(Shell, AThinTubeIsABeamOnItsHoopFoundation) {
  // P/(8 b^3 D), b^4 = 3 (1 - nu^2)/(r h)^2 (Timoshenko, Plates and Shells, art. 114); shear adds
  // in proportion to h/r.
  const double r = 0.02;
  for (const double ratio : {1e-2, 1e-3, 1e-4}) {
    const double h = ratio * r, plane = kModulus / (1.0 - kPoisson * kPoisson);
    const double b = std::pow(3.0 * (1.0 - kPoisson * kPoisson), 0.25) / std::sqrt(r * h);
    const double bending = plane * h * h * h / 12.0 * 2.0 * pi * r;
    const double v = ring_displacement_of_chain(tube(r - 0.5 * h, r + 0.5 * h, r), 0.5 / b, 60);
    const double error = v * 8.0 * b * b * b * bending - 1.0;
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, ratio);
  }
}

TEST(Shell, RadiallyRigidWallBendsWithItsShear) {
  // theta = sinh(m x) or cosh(m x), m^2 = V/B, about the wall's centre.
  ShellRigidity s = tube(17.5e-3, 23e-3, 20e-3);
  s = tube(17.5e-3, 23e-3, 20e-3 + s.eccentric / s.axial);
  s.radially_rigid = true;
  const double m = std::sqrt(s.shear / s.bending);
  for (const double length : {1e-4, 3e-3, 40e-3}) {
    const ShellMatrix k = stiffness_matrix(s, length);
    const double half = 0.5 * m * length;
    EXPECT_NEAR(k(2, 2) / (0.5 * s.bending * m / std::tanh(half)), 1.0, 1e-10);
    EXPECT_NEAR(k(4, 4) / (2.0 * s.bending * m * std::tanh(half)), 1.0, 1e-10);
    EXPECT_NEAR(k(0, 0) / (s.axial / length), 1.0, 1e-10);
  }
}

/// A held tube pushed by springs, one of which takes back deflection.
Model tube_with_springs() {
  const ShellRigidity s = tube(17.5e-3, 23e-3, 24e-3);
  Model m = chain(
      {stiffness_matrix(s, 2e-3), stiffness_matrix(s, 5e-3), stiffness_matrix(tube(17.5e-3, 31e-3, 24e-3), 1e-3)});
  m.fixed_supports.push_back({2, Dof::u});
  const double compliance[] = {0.0, 4e-10, -3e-10, -8e-10};
  for (int i = 0; i < 4; ++i) {
    const int node = m.add_node();
    for (const Dof dof : {Dof::u, Dof::v, Dof::theta})
      m.elastic_supports.push_back({node, dof, dof == Dof::theta ? 4e3 : 3e8});
    m.springs.push_back({{node, 0.0, -3e-3}, {i, 0.0, -6.5e-3}, 0.8, 0.6, {1.1e10, -2e-5, compliance[i]}});
  }
  return m;
}

TEST(Shell, ResidualAndTangentAreDerivativesOfTheEnergy) {
  const Equations equations(tube_with_springs());
  const int n = equations.size();
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto direction = [&] {
    Eigen::VectorXd d(n);
    for (int i = 0; i < n; ++i) d[i] = uniform(random) * (equations.kind(i) == Dof::theta ? 1e-3 : 1e-5);
    return d;
  };
  SparseSymmetric tangent = equations.linear_stiffness();
  for (int sample = 0; sample < 20; ++sample) {
    const Eigen::VectorXd q = 0.3 * direction(), d = direction(), f = 1e8 * direction();
    Eigen::VectorXd r(n), unused(n);
    const double h = 1e-3;
    const auto energy = [&](double t) { return equations.energy_and_residual(State(q + t * d), f, unused); };
    equations.energy_and_residual(State(q), f, r);
    EXPECT_NEAR(test::derivative(energy, 0.0, h), r.dot(d), 1e-7 * r.norm() * d.norm());

    test::set_tangent(equations, State(q), tangent);
    Eigen::VectorXd product = Eigen::VectorXd::Zero(n);
    for (int j = 0; j < n; ++j)
      for (int k = tangent.column_start[static_cast<std::size_t>(j)];
           k < tangent.column_start[static_cast<std::size_t>(j) + 1]; ++k) {
        const auto slot = static_cast<std::size_t>(k);
        const int i = tangent.row[slot];
        product[i] += tangent.value[slot] * d[j];
        if (i != j) product[j] += tangent.value[slot] * d[i];
      }
    Eigen::VectorXd plus(n), minus(n);
    equations.energy_and_residual(State(q + h * d), f, plus);
    equations.energy_and_residual(State(q - h * d), f, minus);
    EXPECT_LT(((plus - minus) / (2.0 * h) - product).norm(), 1e-5 * product.norm());
  }
}

TEST(Shell, ResidualBalancesToRounding) {
  const Equations equations(tube_with_springs());
  NewtonSolver solver(equations);
  NewtonOptions options;
  options.force_scale = 1e3;
  options.length_scale = 5e-3;
  const Eigen::VectorXd f = equations.load_vector({{4, Dof::u, 1e3}, {6, Dof::v, 800.0}});
  State q = Eigen::VectorXd(Eigen::VectorXd::Zero(equations.size()));
  const NewtonSummary summary = solver.solve(f, options, q);
  EXPECT_TRUE(summary.converged()) << name(summary.status);
  EXPECT_LT(summary.relative_residual, 1e-13);
}

}  // namespace
}  // namespace fe
