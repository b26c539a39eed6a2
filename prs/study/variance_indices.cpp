#include "prs/study/variance_indices.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <functional>

namespace prs {
namespace {

constexpr std::size_t kMostBatches = 32;
constexpr double kUpperQuantile = 0.975;
constexpr double kConstant = 1e-12;  // Deviations from the largest value that are rounding.

}  // namespace

void VarianceIndices::Sums::add(const Sums& other, double sign) {
  samples += sign * other.samples;
  a += sign * other.a;
  b += sign * other.b;
  aa += sign * other.aa;
  bb += sign * other.bb;
  for (std::size_t i = 0; i < d.size(); ++i) {
    d[i] += sign * other.d[i];
    bd[i] += sign * other.bd[i];
    dd[i] += sign * other.dd[i];
  }
}

double VarianceIndices::Sums::variance() const {
  const double mean = (a + b) / (2.0 * samples);
  return (aa + bb) / (2.0 * samples) - mean * mean;
}

double VarianceIndices::Sums::first(std::size_t factor) const {
  return (bd[factor] - b * d[factor] / samples) / (samples * variance());
}

double VarianceIndices::Sums::total(std::size_t factor) const {
  return dd[factor] / (2.0 * samples * variance());
}

VarianceIndices::Sums VarianceIndices::empty() const {
  const std::vector<double> zeros(factors_);
  return {.d = zeros, .bd = zeros, .dd = zeros};
}

VarianceIndices::VarianceIndices(std::size_t factors, std::size_t samples)
    : factors_(factors), samples_(samples) {
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
  for (std::size_t i = 0; i < factors_; ++i) {
    const double d = values[i + 2] - values[0];
    sums.d[i] += d;
    sums.bd[i] += b * d;
    sums.dd[i] += d * d;
  }
}

Estimate VarianceIndices::estimate(const Sums& all, double (Sums::*index)(std::size_t) const,
                                   std::size_t factor) const {
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
  return {(all.*index)(factor),
          boost::math::quantile(distribution, kUpperQuantile) * standard_error};
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
  for (std::size_t i = 0; i < factors_; ++i)
    result.factors.push_back({i, estimate(all, &Sums::first, i), estimate(all, &Sums::total, i)});
  std::ranges::stable_sort(result.factors, std::greater{},
                           [](const FactorIndices& f) { return f.total.value; });
  return result;
}

}  // namespace prs
