#include "prs/study/sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <tuple>

#include "prs/indices.h"

namespace prs {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index kRowsAtOnce = 128;
constexpr double kDependent = 1e-9;  // Share of a column's length that is independent of other columns.
constexpr double kConstant = 1e-12;  // Relative deviations of a response that are rounding.

/// The factor on its axis; none for words and for constant factors.
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

constexpr std::size_t kMostBatches = 32;
constexpr double kUpperQuantile = 0.975;

}  // namespace

double NormalisedFactor::operator()(double value) const {
  return ((logarithmic ? std::log(std::abs(value)) : value) - centre) / half_range;
}

std::vector<NormalisedFactor> normalised_factors(const Study& study) {
  std::vector<NormalisedFactor> factors;
  if (!is_sampled(study.plan)) return factors;
  for (const auto k : indices(study.factors))
    if (const auto factor = normalised(study.factors[k], k)) factors.push_back(*factor);
  return factors;
}

LinearRegression::LinearRegression(std::size_t factors, std::size_t responses)
    : factors_(static_cast<Index>(factors)),
      responses_(static_cast<Index>(responses)),
      first_(Eigen::VectorXd::Zero(responses_)),
      largest_(Eigen::VectorXd::Zero(responses_)) {
  const Index columns = 1 + factors_ + responses_;
  triangle_ = MatrixXd::Zero(columns, columns);
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

void LinearRegression::reduce(MatrixXd& triangle, MatrixXd pending) {
  for (Index k = 0; k < triangle.cols(); ++k) {
    const double below = pending.col(k).squaredNorm();
    if (below == 0.0) continue;
    // Householder's reflection of column k onto its diagonal entry, along (v, pending.col(k)).
    const double diagonal = triangle(k, k);
    const double reflected = -std::copysign(std::sqrt(diagonal * diagonal + below), diagonal);
    const double v = diagonal - reflected;
    const double scale = 2.0 / (v * v + below);
    triangle(k, k) = reflected;
    for (Index j = k + 1; j < triangle.cols(); ++j) {
      const double s = scale * (v * triangle(k, j) + pending.col(k).dot(pending.col(j)));
      triangle(k, j) -= s * v;
      pending.col(j) -= s * pending.col(k);
    }
  }
}

MatrixXd LinearRegression::triangle() const {
  MatrixXd all = triangle_;
  reduce(all, pending_.topRows(pending_rows_));
  return all;
}

std::optional<std::size_t> LinearRegression::dependent_column() const {
  const MatrixXd r = triangle();
  for (Index k = 1; k <= factors_; ++k)
    if (!(std::abs(r(k, k)) > kDependent * r.col(k).head(k + 1).norm())) return static_cast<std::size_t>(k - 1);
  return std::nullopt;
}

std::vector<std::optional<LinearFit>> LinearRegression::fits() const {
  const Index coefficients = 1 + factors_;
  const MatrixXd r = triangle();
  const auto upper = r.topLeftCorner(coefficients, coefficients).triangularView<Eigen::Upper>();
  const MatrixXd b = upper.solve(r.topRightCorner(coefficients, responses_));
  const Eigen::VectorXd root_of_covariance =
      upper.solve(MatrixXd::Identity(coefficients, coefficients)).rowwise().norm();
  const double rows = static_cast<double>(rows_);
  const double left_over = rows - static_cast<double>(coefficients);

  std::vector<std::optional<LinearFit>> fits(static_cast<std::size_t>(responses_));
  for (Index j = 0; j < responses_; ++j) {
    const auto y = r.col(coefficients + j);
    const double sum_of_squares = y.tail(y.size() - 1).squaredNorm();
    const double residual = y.tail(responses_).squaredNorm();
    const bool overflows = !std::isfinite(sum_of_squares) || !b.col(j).allFinite();
    if (overflows || std::sqrt(sum_of_squares / rows) <= kConstant * largest_(j)) continue;
    LinearFit fit;
    fit.intercept = first_(j) + b(0, j);
    fit.r_squared = 1.0 - residual / sum_of_squares;
    if (left_over > 0.0) fit.adjusted_r_squared = 1.0 - (residual / left_over) / (sum_of_squares / (rows - 1.0));
    const double magnitudes = b.col(j).tail(factors_).lpNorm<1>();
    for (Index i = 1; i < coefficients; ++i) {
      FactorEffect effect{static_cast<std::size_t>(i - 1), b(i, j), std::nullopt,
                          100.0 * std::abs(b(i, j)) / magnitudes};
      if (left_over > 0.0) effect.standard_error = std::sqrt(residual / left_over) * root_of_covariance(i);
      fit.effects.push_back(effect);
    }
    item_at(fits, j) = std::move(fit);
  }
  return fits;
}

ResponseSurfaces response_surfaces(const LinearRegression& regression, const std::vector<NormalisedFactor>& factors,
                                   const Study& study) {
  ResponseSurfaces surfaces{regression.rows()};
  if (regression.rows() <= factors.size()) {
    surfaces.reason = fmt::format("{} designs with all responses do not determine {} coefficients", regression.rows(),
                                  factors.size() + 1);
    return surfaces;
  }
  if (const auto column = regression.dependent_column()) {
    surfaces.reason =
        fmt::format("{} does not vary independently of the others", study.factors[factors[*column].factor].label);
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

void VarianceIndices::Sums::add(const Sums& other, double sign) {
  samples += sign * other.samples;
  a += sign * other.a;
  b += sign * other.b;
  aa += sign * other.aa;
  bb += sign * other.bb;
  d += sign * other.d;
  bd += sign * other.bd;
  dd += sign * other.dd;
}

double VarianceIndices::Sums::variance() const {
  const double mean = (a + b) / (2.0 * samples);
  return (aa + bb) / (2.0 * samples) - mean * mean;
}

double VarianceIndices::Sums::first(Index factor) const {
  return (bd[factor] - b * d[factor] / samples) / (samples * variance());
}

double VarianceIndices::Sums::total(Index factor) const { return dd[factor] / (2.0 * samples * variance()); }

VarianceIndices::Sums VarianceIndices::empty() const {
  const Eigen::ArrayXd zeros = Eigen::ArrayXd::Zero(static_cast<Index>(factors_));
  return {.d = zeros, .bd = zeros, .dd = zeros};
}

VarianceIndices::VarianceIndices(std::size_t factors, std::size_t samples) : factors_(factors), samples_(samples) {
  batches_.assign(std::min(samples, kMostBatches), empty());
}

void VarianceIndices::add(std::span<const double> values) {
  assert(next_ < samples_ && values.size() == factors_ + 2);
  Sums& sums = batches_[next_++ * batches_.size() / samples_];
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) {
    ++left_out_;
    return;
  }
  for (const double value : values) largest_ = std::max(largest_, std::abs(value));
  if (!origin_) origin_ = values[0];
  const double a = values[0] - *origin_, b = values[1] - *origin_;
  sums.samples += 1.0;
  sums.a += a;
  sums.b += b;
  sums.aa += a * a;
  sums.bb += b * b;
  const Eigen::Map<const Eigen::ArrayXd> of_factors(values.data() + 2, sums.d.size());
  const Eigen::ArrayXd d = of_factors - values[0];
  sums.d += d;
  sums.bd += b * d;
  sums.dd += d * d;
}

Estimate VarianceIndices::estimate(const Sums& all, double (Sums::*index)(Index) const, Index factor) const {
  std::vector<double> without_one;
  for (const Sums& batch : batches_) {
    if (batch.samples == 0.0) continue;
    Sums rest = all;
    rest.add(batch, -1.0);
    if (rest.samples == 0.0 || !(rest.variance() > 0.0)) return {(all.*index)(factor), {}};
    without_one.push_back((rest.*index)(factor));
  }
  const double batches = static_cast<double>(without_one.size());
  double mean = 0.0, squares = 0.0;
  for (const double value : without_one) mean += value / batches;
  for (const double value : without_one) squares += (value - mean) * (value - mean);
  const double standard_error = std::sqrt((batches - 1.0) / batches * squares);
  const boost::math::students_t distribution(batches - 1.0);
  return {(all.*index)(factor), boost::math::quantile(distribution, kUpperQuantile) * standard_error};
}

ResponseIndices VarianceIndices::result() const {
  Sums all = empty();
  for (const Sums& batch : batches_) all.add(batch, 1.0);
  ResponseIndices result;
  result.samples = static_cast<std::size_t>(all.samples);
  result.left_out = left_out_;
  if (result.samples == 0) return result;
  result.variance = std::max(0.0, all.variance());
  if (std::sqrt(result.variance) <= kConstant * largest_) return result;
  for (Index i = 0; i < all.d.size(); ++i)
    result.factors.push_back(
        {static_cast<std::size_t>(i), estimate(all, &Sums::first, i), estimate(all, &Sums::total, i)});
  std::ranges::stable_sort(result.factors, std::greater{}, [](const FactorIndices& f) { return f.total.value; });
  return result;
}

namespace {

// Share of the effects on a response from which a factor clearly matters [%].
constexpr double kClearlyFollowed = 10.0;
constexpr std::size_t kMostDrawsSeen = 64;

bool has_numbers(std::span<const double> row) {
  return std::ranges::any_of(row, [](double value) { return std::isfinite(value); });
}

bool same_numbers(std::span<const double> one, std::span<const double> other) {
  return std::ranges::equal(one, other, [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
}

std::uint64_t hash_of(std::span<const double> row) {
  std::uint64_t hash = 0;
  for (const double value : row) {
    const double shown = std::isnan(value) ? kNoResponse : value;
    hash = mixed_bits(hash + kGoldenStep + std::bit_cast<std::uint64_t>(shown));
  }
  return hash;
}

/// Weight of a level; the last level of a factor has minus the sum of the others.
std::uint64_t level_weight(std::size_t level) { return mixed_bits(level + kGoldenStep); }

/// Smallest and largest value of a factor among the first designs; none if all are equal.
std::optional<std::pair<Draw, Draw>> extreme_draws(const Study& study, std::size_t factor) {
  const auto place = [](const Draw& draw) { return std::tuple(draw.level, draw.number); };
  std::vector<Draw> drawn;
  for (std::size_t k = 1; k < std::min(design_count(study), kMostDrawsSeen + 1); ++k)
    drawn.push_back(draws(study, k)[factor]);
  if (drawn.empty()) return std::nullopt;
  const auto [least, largest] = std::ranges::minmax_element(drawn, {}, place);
  if (place(*least) == place(*largest)) return std::nullopt;
  return std::pair(*least, *largest);
}

bool is_clearly_followed(const ResponseSurfaces* surfaces, std::size_t factor) {
  if (!surfaces) return false;
  return std::ranges::any_of(surfaces->fits, [&](const std::optional<LinearFit>& fit) {
    return fit && std::ranges::any_of(fit->effects, [&](const FactorEffect& effect) {
             return effect.factor == factor && effect.contribution_percent >= kClearlyFollowed;
           });
  });
}

}  // namespace

FollowedFactors::FollowedFactors(const Study& study) : study_(study), seen_(study.factors.size()) {
  for (const auto f : indices(seen_)) {
    const std::size_t levels = study.factors[f].levels.size();
    seen_[f].varies = levels != 1;
    for (std::size_t level = 0; level + 1 < levels; ++level) seen_[f].last_weight -= level_weight(level);
  }
}

void FollowedFactors::compare(Seen& seen, std::span<const double> row) const {
  if (!has_numbers(row) && !has_numbers(reference_)) return;
  seen.compared = true;
  seen.followed = seen.followed || !same_numbers(row, reference_);
}

void FollowedFactors::add_to_grid(std::span<const double> row, std::size_t design) {
  const std::uint64_t hash = hash_of(row);
  const std::vector<Draw> drawn = draws(study_, design);
  for (const auto f : indices(seen_)) {
    std::uint64_t line = f;
    for (const auto g : indices(seen_))
      if (g != f) line = mixed_bits(line + kGoldenStep + drawn[g].level);
    const std::size_t level = drawn[f].level;
    const bool last = level + 1 == study_.factors[f].levels.size();
    // Multiplication by odd numbers loses nothing modulo 2^64.
    seen_[f].sum += hash * (line | 1U) * (last ? seen_[f].last_weight : level_weight(level));
    seen_[f].compared = seen_[f].compared || has_numbers(row);
  }
}

void FollowedFactors::add(std::span<const double> row, std::size_t design) {
  const auto keep = [&] { reference_.assign(row.begin(), row.end()); };
  if (study_.plan == Plan::one_at_a_time) {
    if (design == 0) return keep();
    const Design values = prs::design(study_, design);
    Seen& seen = seen_[values.settings.front().factor];
    seen.varies = seen.varies || !is_base(study_, values);
    compare(seen, row);
  } else if (study_.plan == Plan::grid && design > 0) {
    add_to_grid(row, design);
  } else if (study_.plan == Plan::sobol_indices && design > 0) {
    // Both points of a sample, then the first one with a factor of the second.
    const std::vector<std::size_t> blocks = blocks_of(study_);
    const std::size_t k = (design - 1) % (blocks.size() + 2);
    if (k == 0) return keep();
    if (k >= 2) compare(seen_[blocks[k - 2]], row);
  }
}

std::vector<std::size_t> FollowedFactors::idle() const {
  std::vector<std::size_t> idle;
  for (const auto f : indices(seen_))
    if (const Seen& s = seen_[f]; s.varies && s.compared && !s.followed && s.sum == 0) idle.push_back(f);
  return idle;
}

std::vector<std::size_t> idle_drawn_factors(
    const Study& study, const ResponseSurfaces* surfaces,
    const std::function<RowBlock(const std::vector<std::vector<Draw>>&)>& evaluate) {
  std::vector<std::size_t> tried;
  std::vector<std::vector<Draw>> designs;
  for (const auto f : indices(study.factors)) {
    if (is_clearly_followed(surfaces, f)) continue;
    const auto extremes = extreme_draws(study, f);
    if (!extremes) continue;
    tried.push_back(f);
    for (const std::size_t others : {std::size_t{0}, std::size_t{1}})
      for (const Draw& value : {extremes->first, extremes->second}) {
        designs.push_back(draws(study, others));
        designs.back()[f] = value;
      }
  }
  std::vector<std::size_t> idle;
  if (designs.empty()) return idle;
  const RowBlock block = evaluate(designs);
  const std::size_t width = study.responses.size();
  const auto row = [&](std::size_t k) { return std::span(block.responses).subspan(k * width, width); };
  for (const auto i : indices(tried)) {
    bool compared = false, followed = false;
    for (const std::size_t k : {4 * i, 4 * i + 2}) {
      compared = compared || has_numbers(row(k));
      followed = followed || !same_numbers(row(k), row(k + 1));
    }
    if (compared && !followed) idle.push_back(tried[i]);
  }
  return idle;
}

}  // namespace prs
