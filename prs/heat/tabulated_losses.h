#pragma once

#include "prs/heat/case_losses.h"

namespace prs {

/// Least and greatest of the three coordinates of temperatures in a `LossTable` [K].
struct TemperatureBox {
  OfParts least = OfParts::Zero(), greatest = OfParts::Zero();

  void include(const OfParts& coordinates);
  bool contains(const TemperatureBox& other) const;
  /// The box with a tenth of each width and `margin` [K] added on each side.
  TemperatureBox widened(double margin) const;
};

/// Coordinates of temperatures of the parts: mean of both oils, screw's oil less nut's, rollers
/// less that mean [K]. Along a cycle the two differences change little.
OfParts table_coordinates(const OfParts& temperature);
/// The temperatures that have these coordinates.
OfParts temperatures_of(const OfParts& coordinates);

/// The box around a path of coordinates.
TemperatureBox around(std::span<const OfParts> path);

/// Heat into screw, rollers and nut, power that flows in and power that comes out [W].
using Flows = Eigen::Matrix<double, 5, 1>;

/// Losses over the temperatures of the parts as polynomials: products of one for each coordinate
/// through up to nine of Chebyshev's extreme points, on panels of a box that are halved, the worst
/// one first, until what their last coefficients let expect beyond them, and the difference to
/// losses off the points, are below `Effort::accuracy` of the panel's largest losses.
class LossTable {
 public:
  /// Nothing is lost.
  LossTable() = default;
  /// Losses that are equal at all temperatures.
  explicit LossTable(const Losses& constant);
  using At = std::function<std::optional<Losses>(const OfParts& temperature)>;
  struct Effort {
    double accuracy = 0.0;
    int evaluations = 0;  ///< Number after which no further panel is halved.
  };
  /// `by_rollers`: whether the losses depend on the parts' temperatures other than by the oils'.
  /// The difference from `rough`, a table of nearly the same losses, takes fewer points. Absent where
  /// `at` has no losses.
  static std::optional<LossTable> over(const TemperatureBox& box, const At& at, bool by_rollers, const Effort& effort,
                                       LossTable rough);
  /// The difference from `rough` along a path alone, over a coordinate that only rises or only falls on it: fewer
  /// points still. Beside the path the difference is that on it. Absent where no coordinate does so, or `at` has no
  /// losses.
  static std::optional<LossTable> along(std::span<const OfParts> path, const At& at, const Effort& effort,
                                        LossTable rough);

  using ByTemperature = Eigen::Matrix<double, 5, 3>;
  struct Value {
    Flows value = Flows::Zero();
    ByTemperature by_temperature = ByTemperature::Zero();  ///< d/d(screw, rollers, nut) [W/K]
  };
  Value at(const OfParts& temperature, bool with_slopes = true) const;
  Flows value_at(const OfParts& temperature) const { return at(temperature, false).value; }

  /// Largest difference from losses at a temperature, over the largest of these.
  double distance(const OfParts& temperature, const Losses& losses) const;
  /// Largest error of all panels, measured as `Effort::accuracy`.
  double error() const { return error_; }

 private:
  using Points = std::array<int, 3>;
  struct Panel {
    TemperatureBox box;
    Points points{1, 1, 1};
    /// Coefficients of Chebyshev's polynomials, the last coordinate fastest.
    std::vector<Flows> coefficients;
    std::array<double, 3> last{};  ///< Left out along each coordinate, over the largest losses.
    double error = 0.0;

    OfParts unit(const OfParts& coordinates) const;
    /// Adds values and, along these coordinates, slopes.
    void add(const OfParts& coordinates, const std::array<bool, 3>& with_slopes, Value& sum) const;
    void transform(const std::vector<Flows>& values, double largest);
    /// The coordinate to halve along; none where the panel is good or too narrow.
    std::optional<int> worst(double accuracy) const;
  };
  /// A panel, or the box of one and where it was halved.
  struct Node {
    Panel panel;
    int along = -1;
    double halved_at = 0.0;
    std::size_t below = 0;  ///< The half below, followed by that above.
  };
  using Layer = std::vector<Node>;

  /// Temperatures at coordinates.
  using Place = std::function<OfParts(const OfParts& coordinates)>;
  static std::optional<LossTable> halved(const TemperatureBox& box, const Place& place, const At& at,
                                         const Points& fewest, const Effort& effort, LossTable rough);
  std::optional<Panel> fit(const TemperatureBox& box, const Place& place, const At& exact, const Points& fewest,
                           double accuracy, int& evaluations) const;
  static const Panel& panel_at(const Layer& layer, const OfParts& coordinates);

  /// Layers, whose values add up; beyond the borders of its first box a layer's are those at the border.
  std::vector<Layer> layers_;
  double error_ = 0.0;
};

}  // namespace prs
