#include "modules/drive/friction_fit.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "modules/drive/drive.h"

namespace prs {
namespace {

constexpr int kSteps = 10;

/// Least squares with coefficients >= 0: the best of all choices of columns.
Eigen::Vector3d fitted_above_zero(const Eigen::MatrixXd& columns, const Eigen::VectorXd& y) {
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  double least = y.squaredNorm();
  for (unsigned choice = 1; choice < 8; ++choice) {
    std::vector<Eigen::Index> chosen;
    for (Eigen::Index k = 0; k < 3; ++k)
      if ((choice >> k & 1U) != 0) chosen.push_back(k);
    const Eigen::MatrixXd part = columns(Eigen::all, chosen);
    const Eigen::VectorXd found = part.colPivHouseholderQr().solve(y);
    const double rest = (part * found - y).squaredNorm();
    if (!(found.minCoeff() >= 0.0) || !(rest < least * (1.0 - 1e-12))) continue;
    least = rest;
    best.setZero();
    best(chosen) = found;
  }
  return best;
}

}  // namespace

FrictionFit fit_friction(const PrsCurves& curves, double largest_force, double speed) {
  const double r = curves.lead / (2.0 * std::numbers::pi);
  FrictionFit fit;
  Eigen::MatrixXd columns(2 * kSteps * (2 * kSteps + 1), 3);
  Eigen::VectorXd y(columns.rows());
  Eigen::Index row = 0;
  for (int i = -kSteps; i <= kSteps; ++i)
    for (int k = 1; k <= kSteps; ++k)
      for (const int sigma : {1, -1}) {
        const double force = largest_force * i / kSteps, turning = speed * k / kSteps;
        columns.row(row) << 1.0, std::abs(force), std::abs(turning * r);
        y(row++) = std::abs(prs_friction_torque(&curves, force, turning, sigma) / r);
      }
  // Scales that give columns of similar size.
  const Eigen::Vector3d size(1.0, largest_force, std::abs(speed * r));
  for (Eigen::Index k = 0; k < 3; ++k) columns.col(k) /= size(k);
  const Eigen::Vector3d p = fitted_above_zero(columns, y);
  const Eigen::VectorXd error = columns * p - y;
  fit.largest_error = error.cwiseAbs().maxCoeff();
  fit.rms_error = std::sqrt(error.squaredNorm() / static_cast<double>(error.size()));
  fit.no_load = p(0);
  fit.per_load = p(1) / size(1);
  fit.per_speed = p(2) / size(2);
  double screw = 0.0, load = 0.0;
  for (int i = 1; i <= kSteps; ++i) {
    const double force = largest_force * i / kSteps;
    const auto share = [&](int sigma) {
      return std::abs(prs_friction_torque(&curves, force, speed, sigma) / (force * r));
    };
    const int driving = r < 0.0 ? -1 : 1;
    screw += 1.0 / (1.0 + share(driving)) / kSteps;
    load += (1.0 - share(-driving)) / kSteps;
  }
  if (screw > 0.0) fit.screw_drives = screw;
  if (load > 0.0) fit.load_drives = load;
  return fit;
}

}  // namespace prs
