#include "prs/heat/loss_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prs {
namespace {

constexpr int kMostPoints = 13;        // Along a coordinate.
constexpr int kMostEvaluations = 700;  // For a table.

/// T_0 .. T_{n-1} at x, or their derivatives too.
using Basis = std::array<double, kMostPoints>;

void chebyshev(double x, int n, Basis& value) {
  value[0] = 1.0;
  if (n > 1) value[1] = x;
  for (int k = 2; k < n; ++k)
    value[static_cast<std::size_t>(k)] =
        2.0 * x * value[static_cast<std::size_t>(k - 1)] - value[static_cast<std::size_t>(k - 2)];
}

void derivatives(double x, int n, const Basis& value, Basis& slope) {
  slope[0] = 0.0;
  if (n > 1) slope[1] = 1.0;
  for (std::size_t k = 2; k < static_cast<std::size_t>(n); ++k)
    slope[k] = 2.0 * value[k - 1] + 2.0 * x * slope[k - 1] - slope[k - 2];
}

/// Point j of n on [-1, 1], where T_n is zero.
double node(int j, int n) { return std::cos(std::numbers::pi * (j + 0.5) / n); }

/// The temperatures of the parts that have these coordinates.
OfParts temperatures(const OfParts& c) {
  const double screw_oil = c[0] + 0.5 * c[1], nut_oil = c[0] - 0.5 * c[1], rollers = c[0] + c[2];
  return {2.0 * screw_oil - rollers, rollers, 2.0 * nut_oil - rollers};
}

/// d(table_coordinates)/d(temperature)
Eigen::Matrix3d coordinates_by_parts() {
  Eigen::Matrix3d m;
  m << 0.25, 0.5, 0.25, 0.5, 0.0, -0.5, -0.25, 0.5, -0.25;
  return m;
}

}  // namespace

void TemperatureBox::include(const OfParts& c) {
  least = least.cwiseMin(c);
  greatest = greatest.cwiseMax(c);
}

bool TemperatureBox::contains(const TemperatureBox& o) const {
  return (least.array() <= o.least.array()).all() && (greatest.array() >= o.greatest.array()).all();
}

TemperatureBox TemperatureBox::widened(double margin) const {
  const OfParts by = (0.1 * (greatest - least).array() + margin).matrix();
  return {least - by, greatest + by};
}

OfParts table_coordinates(const OfParts& t) { return coordinates_by_parts() * t; }

LossTable::LossTable(const Losses& constant) {
  coefficients_.front() << constant.heat, constant.input;
}

std::optional<LossTable> LossTable::over(const TemperatureBox& box, const At& at, bool by_rollers) {
  LossTable table;
  table.box_ = box;
  std::array<int, 3> points{3, 3, by_rollers ? 3 : 1};
  while (true) {
    if (!table.fit(at, points)) return std::nullopt;
    const auto worst = std::max_element(table.last_.begin(), table.last_.end());
    table.error_ = *worst;
    if (*worst <= kTableAccuracy) return table;
    std::array<int, 3> more = points;
    for (std::size_t d = 0; d < 3; ++d)
      if (table.last_[d] > kTableAccuracy && points[d] > 1) more[d] += 2;
    if (std::ranges::max(more) > kMostPoints ||
        table.evaluations_ + more[0] * more[1] * more[2] > kMostEvaluations)
      return table;
    points = more;
  }
}

bool LossTable::fit(const At& at, const std::array<int, 3>& n) {
  points_ = n;
  const auto index = [&](int i, int j, int k) {
    return static_cast<std::size_t>((i * n[1] + j) * n[2] + k);
  };
  coefficients_.assign(index(n[0] - 1, n[1] - 1, n[2] - 1) + 1, Eigen::Vector4d::Zero());
  const OfParts middle = 0.5 * (box_.least + box_.greatest);
  const OfParts half = 0.5 * (box_.greatest - box_.least);
  std::array<Basis, 3> basis{};
  for (int i = 0; i < n[0]; ++i)
    for (int j = 0; j < n[1]; ++j)
      for (int k = 0; k < n[2]; ++k) {
        const OfParts x(node(i, n[0]), node(j, n[1]), node(k, n[2]));
        const std::optional<Losses> losses = at(temperatures(middle + half.cwiseProduct(x)));
        ++evaluations_;
        if (!losses) return false;
        Eigen::Vector4d value;
        value << losses->heat, losses->input;
        for (int d = 0; d < 3; ++d)
          chebyshev(x[d], n[static_cast<std::size_t>(d)], basis[static_cast<std::size_t>(d)]);
        for (int p = 0; p < n[0]; ++p)
          for (int q = 0; q < n[1]; ++q)
            for (int r = 0; r < n[2]; ++r) {
              const double weight = basis[0][static_cast<std::size_t>(p)] * (p > 0 ? 2.0 : 1.0) *
                                    basis[1][static_cast<std::size_t>(q)] * (q > 0 ? 2.0 : 1.0) *
                                    basis[2][static_cast<std::size_t>(r)] * (r > 0 ? 2.0 : 1.0) /
                                    (n[0] * n[1] * n[2]);
              coefficients_[index(p, q, r)] += weight * value;
            }
      }
  double largest = 0.0;
  for (const Eigen::Vector4d& c : coefficients_)
    largest = std::max(largest, c.lpNorm<Eigen::Infinity>());
  last_ = {};
  for (int p = 0; p < n[0]; ++p)
    for (int q = 0; q < n[1]; ++q)
      for (int r = 0; r < n[2]; ++r) {
        const double size = coefficients_[index(p, q, r)].lpNorm<Eigen::Infinity>();
        const int at_end[] = {p, q, r};
        for (std::size_t d = 0; d < 3; ++d)
          if (n[d] > 1 && at_end[d] == n[d] - 1 && largest > 0.0)
            last_[d] = std::max(last_[d], size / largest);
      }
  return true;
}

OfParts LossTable::unit_coordinates(const OfParts& t) const {
  const OfParts half = 0.5 * (box_.greatest - box_.least);
  OfParts x = table_coordinates(t) - 0.5 * (box_.least + box_.greatest);
  for (int d = 0; d < 3; ++d) x[d] = half[d] > 0.0 ? x[d] / half[d] : 0.0;
  return x;
}

Eigen::Vector4d LossTable::value_at(const OfParts& t) const {
  if (coefficients_.size() == 1) return coefficients_.front();
  const OfParts x = unit_coordinates(t);
  std::array<Basis, 3> b;
  for (std::size_t d = 0; d < 3; ++d) chebyshev(x[static_cast<int>(d)], points_[d], b[d]);
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  std::size_t at = 0;
  for (int p = 0; p < points_[0]; ++p)
    for (int q = 0; q < points_[1]; ++q) {
      const double pq = b[0][static_cast<std::size_t>(p)] * b[1][static_cast<std::size_t>(q)];
      for (int r = 0; r < points_[2]; ++r)
        sum += pq * b[2][static_cast<std::size_t>(r)] * coefficients_[at++];
    }
  return sum;
}

LossTable::Value LossTable::at(const OfParts& t) const {
  Value v{coefficients_.front(), Eigen::Matrix<double, 4, 3>::Zero()};
  if (coefficients_.size() == 1) return v;
  const OfParts x = unit_coordinates(t);
  std::array<Basis, 3> b, s;
  for (std::size_t d = 0; d < 3; ++d) {
    chebyshev(x[static_cast<int>(d)], points_[d], b[d]);
    derivatives(x[static_cast<int>(d)], points_[d], b[d], s[d]);
  }
  v.value.setZero();
  Eigen::Matrix<double, 4, 3> slope = Eigen::Matrix<double, 4, 3>::Zero();
  std::size_t at = 0;
  for (std::size_t p = 0; p < static_cast<std::size_t>(points_[0]); ++p)
    for (std::size_t q = 0; q < static_cast<std::size_t>(points_[1]); ++q)
      for (std::size_t r = 0; r < static_cast<std::size_t>(points_[2]); ++r) {
        const Eigen::Vector4d& c = coefficients_[at++];
        v.value += b[0][p] * b[1][q] * b[2][r] * c;
        slope.col(0) += s[0][p] * b[1][q] * b[2][r] * c;
        slope.col(1) += b[0][p] * s[1][q] * b[2][r] * c;
        slope.col(2) += b[0][p] * b[1][q] * s[2][r] * c;
      }
  const OfParts half = 0.5 * (box_.greatest - box_.least);
  for (int d = 0; d < 3; ++d)
    if (half[d] > 0.0) slope.col(d) /= half[d];
  v.by_temperature = slope * coordinates_by_parts();
  return v;
}

}  // namespace prs
