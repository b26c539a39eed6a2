#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "prs/heat/case_losses.h"

namespace prs {

/// Least and greatest of the three coordinates of temperatures in a `LossTable` [K].
struct TemperatureBox {
  OfParts least = OfParts::Zero(), greatest = OfParts::Zero();

  void include(const OfParts& coordinates);
  bool contains(const TemperatureBox& other) const;
  /// By a tenth of each width and by `margin` [K] to each side.
  TemperatureBox widened(double margin) const;
};

/// Coordinates of temperatures of the parts: mean of both oils, screw's oil less nut's, rollers
/// less that mean [K]. Along a cycle the two differences change little.
OfParts table_coordinates(const OfParts& temperature);

/// Losses over the temperatures of the parts as polynomials: interpolated at Chebyshev's points of
/// a box, a product of one for each coordinate, with as many points along each as it takes until
/// their last coefficients are below `kTableAccuracy` of the largest.
class LossTable {
 public:
  /// Nothing is lost.
  LossTable() = default;
  /// The same at all temperatures.
  explicit LossTable(const Losses& constant);
  using At = std::function<std::optional<Losses>(const OfParts& temperature)>;
  /// `by_rollers`: whether the losses depend on the parts' temperatures other than by the oils'.
  /// None where `at` has none.
  static std::optional<LossTable> over(const TemperatureBox& box, const At& at, bool by_rollers);

  struct Value {
    Eigen::Vector4d value;  ///< Heat into screw, rollers, nut; power that flows in.
    Eigen::Matrix<double, 4, 3> by_temperature;  ///< d/d(screw, rollers, nut) [W/K]
  };
  Value at(const OfParts& temperature) const;
  Eigen::Vector4d value_at(const OfParts& temperature) const;

  int evaluations() const { return evaluations_; }
  /// Size of the last coefficients over the largest one.
  double error() const { return error_; }

 private:
  bool fit(const At& at, const std::array<int, 3>& points);
  OfParts unit_coordinates(const OfParts& temperature) const;

  TemperatureBox box_;
  std::array<int, 3> points_{1, 1, 1};
  /// Coefficients of Chebyshev's polynomials, the last coordinate fastest.
  std::vector<Eigen::Vector4d> coefficients_{Eigen::Vector4d::Zero()};
  std::array<double, 3> last_{};  ///< Of each coordinate: last coefficients over the largest.
  int evaluations_ = 0;
  double error_ = 0.0;
};

inline constexpr double kTableAccuracy = 1e-7;

}  // namespace prs
