#include "modules/estimation/statistics.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/prime.hpp>
#include <cmath>
#include <numbers>

namespace modules::fit {

Robust robust(const Loss& loss, double r) {
  const double k = loss.scale, s = r * r;
  switch (loss.kind) {
    case Loss::Kind::huber:
      if (s > k * k) return {2.0 * k * std::abs(r) - k * k, k / std::abs(r), std::copysign(k, r), 0.0};
      break;
    case Loss::Kind::cauchy: {
      const double weight = 1.0 / (1.0 + s / (k * k));
      return {k * k * std::log1p(s / (k * k)), weight, weight * r, (1.0 - s / (k * k)) * weight * weight};
    }
    case Loss::Kind::squares:
      break;
  }
  return {s, 1.0, r, 1.0};
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

double normal_probability(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

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
  runs.p_value = normal_probability((static_cast<double>(runs.count) - runs.expected) / std::sqrt(variance));
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

namespace {

/// Spectrum of the columns that are long enough.
Spectrum without_short(const VectorXd& length) {
  Spectrum spectrum{.length = length, .columns = {}, .ratios = {}, .vectors = {}};
  for (Index j = 0; j < length.size(); ++j)
    if (length[j] >= Spectrum::kNoEffect) spectrum.columns.push_back(j);
  return spectrum;
}

using Decomposition = Eigen::JacobiSVD<MatrixXd, Eigen::NoQRPreconditioner>;

}  // namespace

Spectrum spectrum_of(const MatrixXd& normal) {
  Spectrum spectrum = without_short(normal.diagonal().cwiseMax(0.0).cwiseSqrt());
  const auto n = static_cast<Index>(spectrum.columns.size());
  if (n == 0) return spectrum;
  MatrixXd scaled = normal(spectrum.columns, spectrum.columns);
  for (Index i = 0; i < n; ++i)
    for (Index k = 0; k < n; ++k)
      scaled(i, k) /= spectrum.length[spectrum.columns[static_cast<std::size_t>(i)]] *
                      spectrum.length[spectrum.columns[static_cast<std::size_t>(k)]];
  const Decomposition eigen(scaled, Eigen::ComputeFullV);  // Symmetric, without negative eigenvalues.
  spectrum.ratios = (eigen.singularValues() / eigen.singularValues()[0]).cwiseSqrt();
  spectrum.vectors = eigen.matrixV();
  return spectrum;
}

Spectrum exact_spectrum(const MatrixXd& rows) {
  Spectrum spectrum = without_short(rows.colwise().norm().transpose());
  const auto n = static_cast<Index>(spectrum.columns.size());
  if (n == 0) return spectrum;
  MatrixXd scaled = rows(Eigen::all, spectrum.columns);
  for (Index k = 0; k < n; ++k) scaled.col(k).normalize();
  MatrixXd square = MatrixXd::Zero(n, n);
  if (scaled.rows() > n)
    square.triangularView<Eigen::Upper>() = Eigen::HouseholderQR<MatrixXd>(scaled).matrixQR().topRows(n);
  else
    square.topRows(scaled.rows()) = scaled;
  const Decomposition svd(square, Eigen::ComputeFullV);
  spectrum.ratios = svd.singularValues() / svd.singularValues()[0];
  spectrum.vectors = svd.matrixV();
  return spectrum;
}

MatrixXd inverse(const MatrixXd& normal, const std::vector<Index>& free) {
  MatrixXd result = MatrixXd::Zero(normal.rows(), normal.cols());
  if (free.empty()) return result;
  const Spectrum spectrum = spectrum_of(normal(free, free));
  const auto n = static_cast<Index>(spectrum.columns.size());
  if (n == 0) return result;
  MatrixXd scaled = MatrixXd::Zero(n, n);
  // The largest eigenvalue follows from the trace, which is n.
  const double largest = static_cast<double>(n) / spectrum.ratios.squaredNorm();
  for (Index k = 0; k < n; ++k)
    if (spectrum.is_identifiable(k))
      scaled += spectrum.vectors.col(k) * spectrum.vectors.col(k).transpose() /
                (largest * spectrum.ratios[k] * spectrum.ratios[k]);
  for (Index i = 0; i < n; ++i)
    for (Index k = 0; k < n; ++k) {
      const Index row = spectrum.columns[static_cast<std::size_t>(i)];
      const Index column = spectrum.columns[static_cast<std::size_t>(k)];
      result(free[static_cast<std::size_t>(row)], free[static_cast<std::size_t>(column)]) =
          scaled(i, k) / (spectrum.length[row] * spectrum.length[column]);
    }
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
