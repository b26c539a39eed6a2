#include "modules/estimation/statistics.h"

#include <ceres/loss_function.h>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/prime.hpp>
#include <cmath>
#include <memory>
#include <numbers>

namespace modules::fit {

Robust robust(const Loss& loss, const ArrayXd& r) {
  std::unique_ptr<ceres::LossFunction> rho = std::make_unique<ceres::TrivialLoss>();
  if (loss.kind == Loss::Kind::huber) rho = std::make_unique<ceres::HuberLoss>(loss.scale);
  if (loss.kind == Loss::Kind::cauchy) rho = std::make_unique<ceres::CauchyLoss>(loss.scale);
  Eigen::Array3Xd by_s(3, r.size());
  for (Index i = 0; i < r.size(); ++i) rho->Evaluate(r[i] * r[i], by_s.col(i).data());
  const ArrayXd weight = by_s.row(1);
  return {r, by_s.row(0), weight, weight * r, weight + 2.0 * r.square() * by_s.row(2).transpose()};
}

double consistency(const Loss& loss) {
  const double k = loss.scale;
  switch (loss.kind) {
    case Loss::Kind::huber:
      return std::erf(k / std::numbers::sqrt2);
    case Loss::Kind::cauchy: {
      // exp(x^2) erfc(x) for large x by its asymptotic series.
      const double x = k / std::numbers::sqrt2;
      if (x > 20.0) return 1.0 - 3.0 / (k * k);
      return k * k * (1.0 - k * std::sqrt(0.5 * std::numbers::pi) * std::exp(x * x) * std::erfc(x));
    }
    case Loss::Kind::squares:
      break;
  }
  return 1.0;
}

double chi_square_beyond(double x, double degrees) {
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees), x));
}

double quantile(double level, std::optional<double> degrees) {
  const double p = 0.5 * (1.0 + level);
  if (!degrees || *degrees > 1e9) return boost::math::quantile(boost::math::normal(), p);
  return boost::math::quantile(boost::math::students_t(std::max(*degrees, 0.1)), p);
}

std::optional<Runs> runs_of(std::span<const double> residuals) {
  Runs runs;
  double positive = 0.0, negative = 0.0, last = 0.0;
  for (const double r : residuals) {
    if (r == 0.0) continue;
    (r > 0.0 ? positive : negative) += 1.0;
    if (last == 0.0 || (r > 0.0) != (last > 0.0)) ++runs.count;
    last = r;
  }
  const double n = positive + negative;
  if (positive == 0.0 || negative == 0.0 || n < 3.0) return std::nullopt;
  runs.expected = 1.0 + 2.0 * positive * negative / n;
  const double variance = (runs.expected - 1.0) * (runs.expected - 2.0) / (n - 1.0);
  if (!(variance > 0.0)) return std::nullopt;
  runs.p_value =
      boost::math::cdf(boost::math::normal(runs.expected, std::sqrt(variance)), static_cast<double>(runs.count));
  return runs;
}

double halton(std::size_t k, std::size_t j) {
  const auto base = static_cast<double>(boost::math::prime(static_cast<unsigned>(j)));
  double result = 0.0, digit = 1.0;
  for (auto rest = static_cast<double>(k); rest > 0.0; rest = std::floor(rest / base)) {
    digit /= base;
    result += digit * std::fmod(rest, base);
  }
  return result;
}

Spectrum spectrum_of(const MatrixXd& rows) {
  Spectrum spectrum{.length = rows.colwise().norm(), .columns = {}, .ratios = {}, .vectors = {}};
  for (Index j = 0; j < rows.cols(); ++j)
    if (spectrum.length[j] >= Spectrum::kNoEffect) spectrum.columns.push_back(j);
  if (spectrum.columns.empty()) return spectrum;
  const MatrixXd scaled =
      rows(Eigen::all, spectrum.columns) * spectrum.length(spectrum.columns).cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<MatrixXd> svd(scaled, Eigen::ComputeThinV);
  spectrum.ratios = svd.singularValues() / svd.singularValues()[0];
  spectrum.vectors = svd.matrixV();
  return spectrum;
}

MatrixXd inverse(const MatrixXd& normal, const std::vector<Index>& free) {
  MatrixXd result = MatrixXd::Zero(normal.rows(), normal.cols());
  const VectorXd length = normal.diagonal().cwiseMax(0.0).cwiseSqrt();
  std::vector<Index> columns;
  for (const Index j : free)
    if (length[j] >= Spectrum::kNoEffect) columns.push_back(j);
  if (columns.empty()) return result;
  const VectorXd unit = length(columns).cwiseInverse();
  // Symmetric, and no eigenvalue is negative.
  const Eigen::JacobiSVD<MatrixXd> svd(unit.asDiagonal() * normal(columns, columns) * unit.asDiagonal(),
                                       Eigen::ComputeFullV);
  const VectorXd& eigenvalues = svd.singularValues();
  const double least = eigenvalues[0] * Spectrum::kLeastRatio * Spectrum::kLeastRatio;
  const MatrixXd vectors = unit.asDiagonal() * svd.matrixV();
  result(columns, columns) =
      vectors * (eigenvalues.array() >= least).select(eigenvalues.cwiseInverse(), 0.0).matrix().asDiagonal() *
      vectors.transpose();
  return result;
}

Estimate Covariance::of(const VectorXd& g, double value, double level) const {
  Estimate e{.value = value};
  e.deviation = std::sqrt(std::max(0.0, g.dot(full * g)));
  const double whole = g.dot(first * g);
  const VectorXd gained = inverse * g;
  double sum = 0.0;
  for (const Weighed& c : *curves) {
    if (!c.has_own_spread || !(c.redundancy > 0.0)) continue;
    const double v = c.b * gained.dot(c.information * gained);
    sum += v * v / c.redundancy;
  }
  if (sum > 0.0 && whole > 0.0) e.degrees_of_freedom = whole * whole / sum;
  const double t = quantile(level, e.degrees_of_freedom);
  e.low = value - t * e.deviation;
  e.high = value + t * e.deviation;
  return e;
}

Covariance covariance_of(const std::vector<Weighed>& curves, const MatrixXd& prior, const MatrixXd& inverse) {
  MatrixXd middle = prior, weights = MatrixXd::Zero(prior.rows(), prior.cols());
  for (const Weighed& c : curves) {
    middle += c.b * c.information;
    if (!c.is_estimated || !(c.redundancy > 0.0)) continue;
    const MatrixXd d = c.a * c.information;
    weights += 4.0 / c.redundancy * c.b / c.a * (d - d * inverse * d);
  }
  Covariance result{.first = inverse * middle * inverse, .full = {}, .inverse = inverse, .curves = &curves};
  result.full = result.first + inverse * weights * inverse;
  return result;
}

}  // namespace modules::fit
