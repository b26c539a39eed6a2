#include "modules/drive/small_vibration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace prs {
namespace {

/// A square matrix of at most `most` rows. The bound avoids the compilation of Eigen's code for large matrices, which
/// would take most of the time.
template <typename Number, int most>
using AtMost = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;

/// Matrices of M q'' + D q' + A q about the working point; q = (x, phi, phi_M) without held ones.
struct SmallVibration {
  AtMost<double, 3> mass, damping, stiffness;
};

/// Half width of the difference that gives dT_f/dF [N]. Below its first node the table, over the root of the force, has
/// no slope of its own.
double force_step(const PrsCurves& curves, double force) {
  double first = HUGE_VAL;
  for (std::size_t k = 0; k < curves.forces; ++k)
    if (curves.root_force[k] != 0.0) first = std::min(first, curves.root_force[k] * curves.root_force[k]);
  return curves.forces > 0 && std::abs(force) < first ? first : 1e-4 * std::max(std::abs(force), 1.0);
}

SmallVibration vibration_of(const PrsDrive& d, const WorkingPoint& f, double k) {
  const double r = d.curves.lead / (2.0 * std::numbers::pi), beta = d.material_damping;
  const bool held = f.speed == 0.0, by_speed = d.by == PRS_BY_SPEED;
  SmallVibration all{Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero()};
  double g = r, b = 0.0;
  if (!held) {
    const double speed = f.speed, force = f.force, step = force_step(d.curves, force), share = 1e-3;
    const int sigma = speed < 0.0 ? -1 : 1;
    const auto friction = [&](double at_force, double at_speed) {
      return prs_friction_torque(&d.curves, at_force, at_speed, sigma);
    };
    g += (friction(force + step, speed) - friction(force - step, speed)) / (2.0 * step);
    b = (friction(force, speed * (1.0 + share)) - friction(force, speed * (1.0 - share))) / (2.0 * share * speed);
  }
  Eigen::Matrix3d screw, coupling = Eigen::Matrix3d::Zero();
  screw << 1.0, -r, 0.0, -g, g * r, 0.0, 0.0, 0.0, 0.0;
  if (d.coupled != 0) coupling << 0.0, 0.0, 0.0, 0.0, 1.0, -1.0, 0.0, -1.0, 1.0;
  all.mass.diagonal() << prs_mass_at(&d, f.position), d.screw_inertia, d.motor_inertia;
  all.damping = beta * k * screw + d.coupling_damping * coupling;
  all.damping.diagonal() += Eigen::Vector3d(d.load_damping, b, d.motor_damping);
  all.stiffness = k * screw + d.coupling_stiffness * coupling;
  if (d.linkage.arm > 0.0) {  // Force of a constant torque over the changing arm of the lever.
    const PrsLever lever = prs_lever_at(&d, f.position);
    all.stiffness(0, 0) -= f.force * lever.bend / (lever.ratio * lever.ratio);
  }
  int free = 3;
  if (d.coupled == 0) {
    free = by_speed ? 1 : 2;
    all.mass(1, 1) += d.motor_inertia;
    all.damping(1, 1) += d.motor_damping;
  } else if (by_speed) {
    free = 2;
  }
  if (held) free = 1;
  for (auto* m : {&all.mass, &all.damping, &all.stiffness}) *m = m->topLeftCorner(free, free).eval();
  return all;
}

std::vector<Resonance> resonances_of(const SmallVibration& v) {
  const Eigen::Index n = v.mass.rows();
  AtMost<double, 6> first = AtMost<double, 6>::Zero(2 * n, 2 * n);
  first.topRightCorner(n, n).setIdentity();
  for (Eigen::Index k = 0; k < n; ++k) {
    first.row(n + k).head(n) = -v.stiffness.row(k) / v.mass(k, k);
    first.row(n + k).tail(n) = -v.damping.row(k) / v.mass(k, k);
  }
  // Scale that makes rates and displacements of similar size.
  const double w = std::sqrt(std::max(first.bottomLeftCorner(n, n).norm(), 1e-300));
  first.topRightCorner(n, n) *= w;
  first.bottomLeftCorner(n, n) /= w;
  std::vector<Resonance> found;
  const Eigen::EigenSolver<AtMost<double, 6>> solver(first, false);
  // Rounding gives the two rates of a free rigid motion, which are zero, some 1e-8 w.
  for (const std::complex<double> lambda : solver.eigenvalues())
    if (lambda.imag() > 1e-6 * std::abs(lambda) && std::abs(lambda) > 1e-6 * w)
      found.push_back({std::abs(lambda) / (2.0 * std::numbers::pi), -lambda.real() / std::abs(lambda)});
  std::ranges::sort(found, {}, &Resonance::frequency);
  return found;
}

}  // namespace

FrequencyResponse small_vibration(const PrsDrive& d, const WorkingPoint& point, std::vector<double> frequency) {
  double c = 0.0, slope = 0.0, u = 0.0;
  FrequencyResponse r{point.of_torque};
  prs_shaft_compliance(&d, point.position, &c, &slope);
  prs_series_force(&d.curves, prs_static_deflection(&d, point.force, point.position), c, &u, &r.tangent_stiffness);
  if (!(r.tangent_stiffness > 0.0)) return r;
  const SmallVibration v = vibration_of(d, point, r.tangent_stiffness);
  r.resonances = resonances_of(v);
  r.frequency = std::move(frequency);
  const Eigen::Index n = v.mass.rows();
  Eigen::VectorXcd input = Eigen::VectorXcd::Zero(n);
  input(r.of_torque ? n - 1 : 0) = 1.0;
  for (const double f : r.frequency) {
    const std::complex<double> iw(0.0, 2.0 * std::numbers::pi * f);
    const AtMost<std::complex<double>, 3> dynamic = v.stiffness + iw * iw * v.mass + iw * v.damping;
    const Eigen::VectorXcd x = dynamic.partialPivLu().solve(input);
    if (r.of_torque) {
      r.motor_speed.push_back(std::abs(iw * x(n - 1)));
      r.motor_speed_phase.push_back(std::arg(iw * x(n - 1)));
      r.position.push_back(std::abs(x(0)));
      r.position_phase.push_back(std::arg(x(0)));
    } else {
      r.compliance.push_back(std::abs(x(0)));
      r.phase.push_back(std::arg(x(0)));
      r.stiffness.push_back(1.0 / std::abs(x(0)));
    }
  }
  return r;
}

}  // namespace prs
