#include "prs/study/response_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace prs {
namespace {

constexpr Eigen::Index kRowsAtOnce = 128;
constexpr double kDependent = 1e-9;  // Share of a column's length that other columns leave.
constexpr double kConstant = 1e-12;  // Relative deviations of a response that are rounding.

/// The factor on its axis; nothing for words and for what does not vary.
std::optional<NormalisedFactor> normalised(const Factor& factor, std::size_t index) {
  const auto [kind, first, second] = factor.distribution;
  const auto between = [&](double from, double to, bool logarithmic) {
    return NormalisedFactor{index, 0.5 * (from + to), 0.5 * (to - from), logarithmic};
  };
  NormalisedFactor result;
  switch (kind) {
    case Distribution::Kind::uniform:
      result = between(first, second, false);
      break;
    case Distribution::Kind::log_uniform:
      result = between(std::log(std::abs(first)), std::log(std::abs(second)), true);
      break;
    case Distribution::Kind::normal:
      result = {index, first, second, false};
      break;
    case Distribution::Kind::levels: {
      if (factor.levels.empty() || !factor.is_numeric()) return std::nullopt;
      const auto [least, largest] = std::ranges::minmax(factor.levels, {}, &Level::number);
      result = between(*least.number, *largest.number, false);
      break;
    }
  }
  if (result.half_range == 0.0) return std::nullopt;
  return result;
}

}  // namespace

double NormalisedFactor::operator()(double value) const {
  return ((logarithmic ? std::log(std::abs(value)) : value) - centre) / half_range;
}

std::vector<NormalisedFactor> normalised_factors(const Study& study) {
  std::vector<NormalisedFactor> factors;
  if (!is_sampled(study.plan)) return factors;
  for (std::size_t k = 0; k < study.factors.size(); ++k)
    if (const auto factor = normalised(study.factors[k], k)) factors.push_back(*factor);
  return factors;
}

LinearRegression::LinearRegression(std::size_t factors, std::size_t responses)
    : factors_(static_cast<Eigen::Index>(factors)),
      responses_(static_cast<Eigen::Index>(responses)),
      first_(Eigen::VectorXd::Zero(responses_)),
      largest_(Eigen::VectorXd::Zero(responses_)) {
  const Eigen::Index columns = 1 + factors_ + responses_;
  triangle_ = Eigen::MatrixXd::Zero(columns, columns);
  pending_.resize(kRowsAtOnce, columns);
}

void LinearRegression::add(std::span<const double> x, std::span<const double> y) {
  assert(std::ssize(x) == factors_ && std::ssize(y) == responses_);
  const Eigen::Map<const Eigen::VectorXd> factors(x.data(), factors_), values(y.data(), responses_);
  if (rows_++ == 0) first_ = values;
  largest_ = largest_.cwiseMax(values.cwiseAbs());
  if (pending_rows_ == kRowsAtOnce) {
    reduce(triangle_, pending_);
    pending_rows_ = 0;
  }
  auto row = pending_.row(pending_rows_++);
  row(0) = 1.0;
  row.segment(1, factors_) = factors.transpose();
  row.tail(responses_) = (values - first_).transpose();
}

void LinearRegression::reduce(Eigen::MatrixXd& triangle, Eigen::MatrixXd pending) {
  for (Eigen::Index k = 0; k < triangle.cols(); ++k) {
    const double below = pending.col(k).squaredNorm();
    if (below == 0.0) continue;
    // Householder's reflection of column k onto its diagonal entry, along (v, pending.col(k)).
    const double diagonal = triangle(k, k);
    const double reflected = -std::copysign(std::sqrt(diagonal * diagonal + below), diagonal);
    const double v = diagonal - reflected;
    const double scale = 2.0 / (v * v + below);
    triangle(k, k) = reflected;
    for (Eigen::Index j = k + 1; j < triangle.cols(); ++j) {
      const double s = scale * (v * triangle(k, j) + pending.col(k).dot(pending.col(j)));
      triangle(k, j) -= s * v;
      pending.col(j) -= s * pending.col(k);
    }
  }
}

Eigen::MatrixXd LinearRegression::triangle() const {
  Eigen::MatrixXd all = triangle_;
  reduce(all, pending_.topRows(pending_rows_));
  return all;
}

std::optional<std::size_t> LinearRegression::dependent_column() const {
  const Eigen::MatrixXd r = triangle();
  for (Eigen::Index k = 1; k <= factors_; ++k)
    if (!(std::abs(r(k, k)) > kDependent * r.col(k).head(k + 1).norm()))
      return static_cast<std::size_t>(k - 1);
  return std::nullopt;
}

std::vector<std::optional<LinearFit>> LinearRegression::fits() const {
  const Eigen::Index coefficients = 1 + factors_;
  const Eigen::MatrixXd r = triangle();
  const auto upper = r.topLeftCorner(coefficients, coefficients).triangularView<Eigen::Upper>();
  const Eigen::MatrixXd b = upper.solve(r.topRightCorner(coefficients, responses_));
  const Eigen::VectorXd root_of_covariance =
      upper.solve(Eigen::MatrixXd::Identity(coefficients, coefficients)).rowwise().norm();
  const double rows = static_cast<double>(rows_);
  const double left_over = rows - static_cast<double>(coefficients);

  std::vector<std::optional<LinearFit>> fits(static_cast<std::size_t>(responses_));
  for (Eigen::Index j = 0; j < responses_; ++j) {
    const auto y = r.col(coefficients + j);
    const double sum_of_squares = y.tail(y.size() - 1).squaredNorm();
    const double residual = y.tail(responses_).squaredNorm();
    if (std::sqrt(sum_of_squares / rows) <= kConstant * largest_(j)) continue;
    LinearFit fit;
    fit.intercept = first_(j) + b(0, j);
    fit.r_squared = 1.0 - residual / sum_of_squares;
    if (left_over > 0.0)
      fit.adjusted_r_squared = 1.0 - (residual / left_over) / (sum_of_squares / (rows - 1.0));
    const double magnitudes = b.col(j).tail(factors_).lpNorm<1>();
    for (Eigen::Index i = 1; i < coefficients; ++i) {
      FactorEffect effect{static_cast<std::size_t>(i - 1), b(i, j), std::nullopt,
                          100.0 * std::abs(b(i, j)) / magnitudes};
      if (left_over > 0.0)
        effect.standard_error = std::sqrt(residual / left_over) * root_of_covariance(i);
      fit.effects.push_back(effect);
    }
    fits[static_cast<std::size_t>(j)] = std::move(fit);
  }
  return fits;
}

ResponseSurfaces response_surfaces(const LinearRegression& regression,
                                   const std::vector<NormalisedFactor>& factors,
                                   const Study& study) {
  ResponseSurfaces surfaces{regression.rows()};
  if (regression.rows() <= factors.size()) {
    surfaces.reason = fmt::format("{} designs with all responses do not determine {} coefficients",
                                  regression.rows(), factors.size() + 1);
    return surfaces;
  }
  if (const auto column = regression.dependent_column()) {
    surfaces.reason = fmt::format("{} does not vary independently of the others",
                                  study.factors[factors[*column].factor].label);
    return surfaces;
  }
  surfaces.fits = regression.fits();
  for (std::optional<LinearFit>& fit : surfaces.fits) {
    if (!fit) continue;
    for (FactorEffect& effect : fit->effects) effect.factor = factors[effect.factor].factor;
    std::ranges::stable_sort(fit->effects, std::greater{}, &FactorEffect::contribution_percent);
  }
  return surfaces;
}

}  // namespace prs
