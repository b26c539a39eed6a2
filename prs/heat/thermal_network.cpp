#include "prs/heat/thermal_network.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "prs/model/quantity_text.h"

namespace prs {
namespace {

constexpr double kCoolest = 50.0;  // Temperature below which no oil's line is evaluated [K].
constexpr int kMostRounds = 50;
constexpr double kDifference = 0.05;  // Difference of temperatures for derivatives [K].

double largest(const OfParts& v) { return v.lpNorm<Eigen::Infinity>(); }
bool is_sound(const OfParts& t) { return t.allFinite() && t.minCoeff() > kCoolest && t.maxCoeff() < kHottest; }

/// The estimate, scaled to the last exact heat, and a slope that makes it go through the exact heats before (Broyden):
/// the estimate does not feel how temperatures change the loads.
class ScaledEstimate {
 public:
  using OfOil = std::function<std::optional<OfParts>(const PerInterface<double>& oil)>;

  ScaledEstimate(const ThermalNetwork& network, const OfOil& of_oil) : network_(network), of_oil_(of_oil) {}

  void scale_to(const OfParts& temperature, const OfParts& exact) {
    ratio_.setOnes();
    offset_.setZero();
    const std::optional<OfParts> at = of_oil_(oil_temperatures(temperature));
    for (int i = 0; i < 3; ++i) {
      if (at && (*at)[i] > 0.0)
        ratio_[i] = exact[i] / (*at)[i];
      else
        ratio_[i] = 0.0, offset_[i] = exact[i];
    }
    const OfParts before = std::exchange(at_, temperature), heat_before = std::exchange(exact_, exact);
    if (!std::exchange(is_scaled_, true) || before == temperature) return;
    const OfParts step = before - temperature;
    if (const std::optional<OfParts> there = heat(before))
      slope_ += (heat_before - *there) * step.transpose() / step.squaredNorm();
  }

  void forget_slope() { slope_.setZero(); }

  std::optional<OfParts> heat(const OfParts& t) const {
    std::optional<OfParts> q = of(oil_temperatures(t));
    if (q) *q += slope_ * (t - at_);
    return q;
  }

  /// Heat minus heat flow out [W].
  std::optional<OfParts> surplus(const OfParts& t) const {
    std::optional<OfParts> q = heat(t);
    if (q) *q -= network_.conductance * (t.array() - network_.ambient).matrix();
    return q;
  }

  /// Whether the total heat is below (sign < 0) or above (sign > 0) the heat flow out, at this share of the distance
  /// from ambient to the steady state; false if it is unknown.
  bool crosses(double share, const OfParts& steady, double sign) const {
    const OfParts rise = (steady.array() - network_.ambient).matrix();
    const OfParts t = (network_.ambient + (share * rise).array()).matrix();
    if (!is_sound(t)) return false;
    const std::optional<OfParts> q = heat(t);
    return q && sign * (q->sum() / (network_.conductance * rise).sum() - share) > 0.0;
  }
  bool crosses_at_any(std::initializer_list<double> shares, const OfParts& steady, double sign) const {
    return std::ranges::any_of(shares, [&](double s) { return crosses(s, steady, sign); });
  }
  /// Whether the parts would stop warming before they reach this state, or do not stay there.
  bool has_cooler_state(const OfParts& steady) const {
    return crosses_at_any({0.3, 0.6, 0.85}, steady, -1.0) || crosses(1.05, steady, 1.0);
  }
  bool has_hotter_state(const OfParts& steady) const {
    return crosses_at_any({1.3, 2.0, 3.5, 6.0, 10.0, 18.0, 30.0}, steady, 1.0);
  }

  /// d(surplus)/dT [W/K], forward differences; `at` is the surplus at t.
  std::optional<Eigen::Matrix3d> derivative(const OfParts& t, const OfParts& at) const {
    const OfParts q = at + network_.conductance * (t.array() - network_.ambient).matrix() - slope_ * (t - at_);
    Eigen::Matrix<double, 3, 2> by_oil;
    for (const Interface i : kInterfaces) {
      PerInterface<double> oil = oil_temperatures(t);
      oil[i] += kDifference;
      const std::optional<OfParts> moved = of(oil);
      if (!moved) return std::nullopt;
      by_oil.col(static_cast<int>(i)) = (*moved - q) / kDifference;
    }
    Eigen::Matrix<double, 2, 3> oil_by_parts;
    oil_by_parts << 0.5, 0.5, 0.0, 0.0, 0.5, 0.5;
    return by_oil * oil_by_parts + slope_ - network_.conductance;
  }

 private:
  /// The estimate of these oils, scaled.
  std::optional<OfParts> of(const PerInterface<double>& oil) const {
    std::optional<OfParts> q = of_oil_(oil);
    if (q) *q = q->cwiseProduct(ratio_) + offset_;
    return q;
  }

  const ThermalNetwork& network_;
  const OfOil& of_oil_;
  OfParts ratio_ = OfParts::Ones(), offset_ = OfParts::Zero();
  OfParts at_ = OfParts::Zero(), exact_ = OfParts::Zero();  ///< Last exact heat, and its temperatures.
  bool is_scaled_ = false;
  Eigen::Matrix3d slope_ = Eigen::Matrix3d::Zero();  ///< [W/K]
};

/// Newton's method from t, where the surplus is known; Broyden's update keeps the derivative.
std::optional<OfParts> newton(const ScaledEstimate& estimate, OfParts t, OfParts surplus,
                              std::optional<Eigen::Matrix3d>& derivative, double tolerance) {
  double before = 0.0;
  for (int i = 0; i < 25; ++i) {
    if (!derivative) derivative = estimate.derivative(t, surplus);
    if (!derivative) return std::nullopt;
    const OfParts step = -derivative->partialPivLu().solve(surplus);
    t += step;
    if (!is_sound(t)) return std::nullopt;
    const double size = largest(step);
    if (size <= tolerance) return t;
    const std::optional<OfParts> next = estimate.surplus(t);
    if (!next) return std::nullopt;
    surplus = *next;
    *derivative += surplus * step.transpose() / step.squaredNorm();
    if (i > 0 && size > 0.3 * before) derivative.reset();
    before = size;
  }
  return std::nullopt;
}

/// Follows the warming parts from t, all with time constants of one, by linearly implicit Euler steps that grow; none
/// if they pass `kHottest` or their heat is not known.
std::optional<OfParts> follow(const ScaledEstimate& estimate, const ThermalNetwork& network, OfParts t) {
  constexpr double kMostRise = 5.0;  // Largest rise in a step [K].
  const Eigen::Matrix3d capacity = network.conductance.diagonal().asDiagonal();
  double h = 0.1;
  for (int i = 0; i < 2000; ++i) {
    const std::optional<OfParts> surplus = estimate.surplus(t);
    if (!surplus) return std::nullopt;
    const std::optional<Eigen::Matrix3d> derivative = estimate.derivative(t, *surplus);
    if (!derivative) return std::nullopt;
    const OfParts step = (capacity / h - *derivative).partialPivLu().solve(*surplus);
    if (!step.allFinite() || largest(step) > kMostRise) {
      h *= 0.25;
      continue;
    }
    t += step;
    if (!is_sound(t)) return std::nullopt;
    if (h > 1e6 && largest(step) < 1e-6) return t;
    h *= 2.0;
  }
  return std::nullopt;
}

/// Reason why no steady state is found: the steepest change of heat between two states that were tried.
std::string not_settled(const std::vector<std::pair<OfParts, OfParts>>& tried) {
  double steepest = 0.0, apart = 0.0;
  std::array<double, 2> heat{};
  for (const auto& [t, q] : tried)
    for (const auto& [other, q_other] : tried)
      if (const double d = largest(t - other), rise = q.sum() - q_other.sum(); d > 0.0 && rise > steepest * d)
        steepest = rise / d, apart = d, heat = {q.sum(), q_other.sum()};
  return fmt::format(
      "{} states were tried, and none gives off the heat that it takes up; of two of them, {:.2g} K apart, one takes "
      "up {:.4g} W, the other {:.4g} W",
      tried.size(), apart, heat[0], heat[1]);
}

std::string runaway(const OfParts& heat, double ambient) {
  return fmt::format(
      "the parts heat up beyond {0}: at any lower temperature they take up more heat than they give off; "
      "at {0} they take up {1:.4g} W, which need {2:.3g} W/K to the surroundings; give them more "
      "conductance, less load or less speed",
      celsius(kHottest), heat.sum(), heat.sum() / (kHottest - ambient));
}

}  // namespace

OfParts of_parts(const PerPart<double>& v) { return {v.screw, v.roller, v.nut}; }
PerPart<double> per_part(const OfParts& v) { return {v[0], v[1], v[2]}; }

OfParts ThermalNetwork::steady(const OfParts& heat) const {
  return (conductance.ldlt().solve(heat).array() + ambient).matrix();
}

ThermalNetwork thermal_network(const Heat& heat) {
  const Heat::Conductance& c = heat.conductance;
  ThermalNetwork n;
  n.ambient = heat.ambient;
  n.conductance << c.screw_ambient + c.screw_rollers, -c.screw_rollers, 0.0,  //
      -c.screw_rollers, c.rollers_ambient + c.screw_rollers + c.rollers_nut, -c.rollers_nut, 0.0, -c.rollers_nut,
      c.nut_ambient + c.rollers_nut;
  return n;
}

OfParts heat_of(const PowerBySource& p) {
  return {0.5 * p.screw + p.carrier_screw, 0.5 * (p.screw + p.nut) + p.carrier_roller, 0.5 * p.nut + p.carrier_nut};
}

PerInterface<double> oil_temperatures(const OfParts& t) { return {0.5 * (t[0] + t[1]), 0.5 * (t[1] + t[2])}; }

SteadyHeat find_steady_heat(const ThermalNetwork& network, const HeatSource& source,
                            const std::optional<OfParts>& start, double tolerance) {
  const OfParts ambient = OfParts::Constant(network.ambient);
  ScaledEstimate fine(network, source.estimate), rough(network, source.rough_estimate);
  SteadyHeat found;
  std::optional<Eigen::Matrix3d> derivative;
  OfParts t = start.value_or(ambient);
  std::vector<std::pair<OfParts, OfParts>> tried;  // Temperatures and exact heat.
  for (int round = 0; round < kMostRounds; ++round) {
    ++found.evaluations;
    const std::optional<OfParts> heat = source.exact(t);
    if (!heat)
      return ended(found, HeatStatus::no_steady_state,
                   fmt::format("{} with the screw at {}, the rollers at {}, the nut at {}", source.failure(),
                               celsius(t[0]), celsius(t[1]), celsius(t[2])));
    tried.emplace_back(t, *heat);
    found.heat = *heat;
    found.temperature = network.steady(*heat);
    const double change = largest(found.temperature - t);
    if (change <= tolerance)
      return is_sound(found.temperature) ? ended(found, HeatStatus::converged, {})
                                         : ended(found, HeatStatus::no_steady_state, runaway(*heat, network.ambient));
    fine.scale_to(t, *heat);
    const OfParts surplus = network.conductance * (found.temperature - t);
    const double of_estimate = round == 0 ? 1e-2 * change : 0.1 * tolerance;
    std::optional<OfParts> next = newton(fine, t, surplus, derivative, of_estimate);
    const bool choose = source.may_grow && round == 0;
    if (choose) rough.scale_to(t, *heat);
    if (next && choose && rough.has_cooler_state(*next)) next.reset();
    if (!next) {
      const OfParts from = round == 0 ? start.value_or(ambient) : t;
      next = follow(fine, network, from);
      if (!next) {  // A slope between distant states may mislead.
        fine.forget_slope();
        next = follow(fine, network, from);
      }
      derivative.reset();
      if (!next) return ended(found, HeatStatus::no_steady_state, runaway(*heat, network.ambient));
    }
    if (choose) found.others = rough.has_hotter_state(*next);
    t = *next;
  }
  return ended(found, HeatStatus::iteration_limit, not_settled(tried));
}

}  // namespace prs
