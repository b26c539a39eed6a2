#include "prs/heat/tabulated_losses.h"

namespace prs {
namespace {

constexpr int kMostPoints = 9;       // Most points along a coordinate: 3, 5, 9, each within the next.
constexpr int kMostOfAPanel = 250;   // Most points of a panel; beyond, it is halved.
constexpr double kNarrowest = 0.02;  // Least width of a panel [K].
/// Places at which a panel is checked, between its points on [-1, 1].
constexpr double kChecks[][3] = {{0.55, -0.19, -0.83}, {-0.85, 0.53, 0.21}};

/// T_0 .. T_{n-1} at x, or their derivatives.
using Basis = std::array<double, kMostPoints>;

void chebyshev(double x, int n, Basis& value, Basis& slope) {
  value = {1.0, x};
  slope = {0.0, 1.0};
  for (std::size_t k = 2; k < static_cast<std::size_t>(n); ++k) {
    value[k] = 2.0 * x * value[k - 1] - value[k - 2];
    slope[k] = 2.0 * value[k - 1] + 2.0 * x * slope[k - 1] - slope[k - 2];
  }
}

/// Extreme point j of T_{n-1} on [-1, 1]; the middle where n = 1.
double extreme_point(int j, int n) { return n == 1 ? 0.0 : std::cos(std::numbers::pi * j / (n - 1)); }

/// Index of extreme point j of n among `kMostPoints`.
int on_finest(int j, int n) { return n == 1 ? (kMostPoints - 1) / 2 : j * ((kMostPoints - 1) / (n - 1)); }

/// Weight of the value at point j of n in coefficient k.
double coefficient_weight(int j, int k, int n) {
  if (n == 1) return 1.0;
  const auto end = [n](int i) { return i == 0 || i == n - 1 ? 0.5 : 1.0; };
  return end(j) * end(k) * 2.0 / (n - 1) * std::cos(std::numbers::pi * j * k / (n - 1));
}

/// Estimate of what n coefficients of these sizes leave out: the larger of the last one, which may vanish by parity,
/// and the last but one times its ratio to the one two before it.
double left_out(const Basis& size, std::size_t n) {
  const double before = n > 4 ? size[n - 4] : 0.0;
  const double falls = before > size[n - 2] ? size[n - 2] / before : 1.0;
  return std::max(size[n - 1], falls * size[n - 2]);
}

Flows flows_of(const Losses& losses) {
  Flows f;
  f << losses.heat, losses.input, losses.output;
  return f;
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

TemperatureBox around(std::span<const OfParts> path) {
  TemperatureBox box{path.front(), path.front()};
  for (const OfParts& c : path) box.include(c);
  return box;
}

OfParts table_coordinates(const OfParts& t) { return coordinates_by_parts() * t; }

OfParts temperatures_of(const OfParts& c) {
  const double screw_oil = c[0] + 0.5 * c[1], nut_oil = c[0] - 0.5 * c[1], rollers = c[0] + c[2];
  return {2.0 * screw_oil - rollers, rollers, 2.0 * nut_oil - rollers};
}

LossTable::LossTable(const Losses& constant) {
  Panel all;
  all.coefficients = {flows_of(constant)};
  layers_ = {{Node{std::move(all)}}};
}

std::optional<LossTable> LossTable::over(const TemperatureBox& box, const At& at, bool by_rollers, const Effort& effort,
                                         LossTable rough) {
  return halved(box, temperatures_of, at, {3, 3, by_rollers ? 3 : 1}, effort, std::move(rough));
}

std::optional<LossTable> LossTable::along(std::span<const OfParts> path, const At& at, const Effort& effort,
                                          LossTable rough) {
  const TemperatureBox box = around(path);
  std::optional<int> by;  // The coordinate that changes most among those that only rise or only fall.
  for (int d = 0; d < 3; ++d) {
    const auto of = [d](const OfParts& c) { return c[d]; };
    const bool is_monotone = std::ranges::is_sorted(path, {}, of) || std::ranges::is_sorted(path, std::greater{}, of);
    const auto width = [&](int of_one) { return box.greatest[of_one] - box.least[of_one]; };
    if (is_monotone && (!by || width(d) > width(*by))) by = d;
  }
  if (!by) return std::nullopt;
  std::vector<OfParts> rising(path.begin(), path.end());
  if (rising.front()[*by] > rising.back()[*by]) std::ranges::reverse(rising);
  const auto on_path = [&](const OfParts& c) {
    const auto next = std::ranges::lower_bound(rising, c[*by], {}, [&](const OfParts& p) { return p[*by]; });
    if (next == rising.begin() || next == rising.end())
      return temperatures_of(next == rising.end() ? rising.back() : rising.front());
    const OfParts &to = *next, &from = *std::prev(next);
    return temperatures_of(from + (c[*by] - from[*by]) / (to[*by] - from[*by]) * (to - from));
  };
  Points fewest{1, 1, 1};
  fewest[static_cast<std::size_t>(*by)] = 3;
  return halved(box, on_path, at, fewest, effort, std::move(rough));
}

std::optional<LossTable> LossTable::halved(const TemperatureBox& box, const Place& place, const At& at,
                                           const Points& fewest, const Effort& effort, LossTable rough) {
  int evaluations = 0;
  const auto panel_on = [&](const TemperatureBox& here) {
    return rough.fit(here, place, at, fewest, effort.accuracy, evaluations);
  };
  std::optional<Panel> whole = panel_on(box);
  if (!whole) return std::nullopt;
  Layer layer{Node{std::move(*whole)}};
  while (evaluations < effort.evaluations) {
    std::optional<std::size_t> next;
    for (std::size_t i = 0; i < layer.size(); ++i)
      if (layer[i].along < 0 && layer[i].panel.worst(effort.accuracy) &&
          (!next || layer[i].panel.error > layer[*next].panel.error))
        next = i;
    if (!next) break;
    const int along = *layer[*next].panel.worst(effort.accuracy);
    TemperatureBox below = layer[*next].panel.box, above = below;
    const double middle = 0.5 * (below.least[along] + below.greatest[along]);
    below.greatest[along] = above.least[along] = middle;
    std::optional<Panel> lower = panel_on(below), upper = panel_on(above);
    if (!lower || !upper) return std::nullopt;
    Panel halved_panel;
    halved_panel.box = layer[*next].panel.box;
    layer[*next] = {std::move(halved_panel), along, middle, layer.size()};
    layer.push_back({std::move(*lower)});
    layer.push_back({std::move(*upper)});
  }
  LossTable table = std::move(rough);
  table.error_ = 0.0;
  for (const Node& node : layer) table.error_ = std::max(table.error_, node.panel.error);
  table.layers_.push_back(std::move(layer));
  return table;
}

std::optional<LossTable::Panel> LossTable::fit(const TemperatureBox& box, const Place& place, const At& exact,
                                               const Points& fewest, double accuracy, int& evaluations) const {
  Panel panel;
  panel.box = box;
  const OfParts middle = 0.5 * (box.least + box.greatest);
  const OfParts half = 0.5 * (box.greatest - box.least);
  double largest = 0.0;
  const auto left_at = [&](const OfParts& unit) -> std::optional<Flows> {
    const OfParts t = place(middle + half.cwiseProduct(unit));
    const std::optional<Losses> losses = exact(t);
    ++evaluations;
    if (!losses) return std::nullopt;
    const Flows flows = flows_of(*losses);
    largest = std::max(largest, flows.lpNorm<Eigen::Infinity>());
    return flows - value_at(t);
  };
  std::map<std::array<int, 3>, Flows> known;
  Points n = fewest;
  while (true) {
    panel.points = n;
    std::vector<Flows> values;
    for (int i = 0; i < n[0]; ++i)
      for (int j = 0; j < n[1]; ++j)
        for (int k = 0; k < n[2]; ++k) {
          const auto [found, is_new] =
              known.try_emplace({on_finest(i, n[0]), on_finest(j, n[1]), on_finest(k, n[2])}, Flows::Zero());
          if (is_new) {
            const std::optional<Flows> left =
                left_at({extreme_point(i, n[0]), extreme_point(j, n[1]), extreme_point(k, n[2])});
            if (!left) return std::nullopt;
            found->second = *left;
          }
          values.push_back(found->second);
        }
    panel.transform(values, largest);
    panel.error = std::ranges::max(panel.last);
    if (panel.error <= accuracy) break;
    // More points where they lack, the worst coordinate first.
    std::array<std::size_t, 3> order{0, 1, 2};
    std::ranges::sort(order, std::greater{}, [&](std::size_t d) { return panel.last[d]; });
    for (const std::size_t d : order) {
      const int more = 2 * n[d] - 1;
      if (panel.last[d] > accuracy && more <= kMostPoints && n[0] * n[1] * n[2] / n[d] * more <= kMostOfAPanel)
        n[d] = more;
    }
    if (n == panel.points) return panel;
  }
  for (const auto& check : kChecks) {
    OfParts unit;
    for (int d = 0; d < 3; ++d) unit[d] = fewest[static_cast<std::size_t>(d)] > 1 ? check[d] : 0.0;
    const std::optional<Flows> left = left_at(unit);
    if (!left) return std::nullopt;
    Value fitted;
    panel.add(middle + half.cwiseProduct(unit), {}, fitted);
    const Flows off = *left - fitted.value;
    if (largest > 0.0) panel.error = std::max(panel.error, off.lpNorm<Eigen::Infinity>() / largest);
  }
  return panel;
}

void LossTable::Panel::transform(const std::vector<Flows>& values, double largest) {
  const auto& n = points;
  coefficients.clear();
  last = {};
  std::array<Basis, 3> size{};
  for (int p = 0; p < n[0]; ++p)
    for (int q = 0; q < n[1]; ++q)
      for (int r = 0; r < n[2]; ++r) {
        Flows sum = Flows::Zero();
        std::size_t at = 0;
        for (int i = 0; i < n[0]; ++i)
          for (int j = 0; j < n[1]; ++j) {
            const double ij = coefficient_weight(i, p, n[0]) * coefficient_weight(j, q, n[1]);
            for (int k = 0; k < n[2]; ++k) sum += ij * coefficient_weight(k, r, n[2]) * values[at++];
          }
        coefficients.push_back(sum);
        const std::size_t number[] = {static_cast<std::size_t>(p), static_cast<std::size_t>(q),
                                      static_cast<std::size_t>(r)};
        for (std::size_t d = 0; d < 3; ++d)
          size[d][number[d]] = std::max(size[d][number[d]], sum.lpNorm<Eigen::Infinity>());
      }
  if (largest <= 0.0) return;
  for (std::size_t d = 0; d < 3; ++d)
    if (n[d] > 1) last[d] = left_out(size[d], static_cast<std::size_t>(n[d])) / largest;
}

std::optional<int> LossTable::Panel::worst(double accuracy) const {
  if (error <= accuracy) return std::nullopt;
  std::optional<int> found;
  for (int d = 0; d < 3; ++d) {
    const auto at = static_cast<std::size_t>(d);
    if (points[at] > 1 && box.greatest[d] - box.least[d] > kNarrowest &&
        (!found || last[at] > last[static_cast<std::size_t>(*found)]))
      found = d;
  }
  return found;
}

OfParts LossTable::Panel::unit(const OfParts& c) const {
  const OfParts half = 0.5 * (box.greatest - box.least);
  OfParts x = c - 0.5 * (box.least + box.greatest);
  for (int d = 0; d < 3; ++d) x[d] = half[d] > 0.0 ? x[d] / half[d] : 0.0;
  return x;
}

void LossTable::Panel::add(const OfParts& c, const std::array<bool, 3>& with_slopes, Value& sum) const {
  const bool any = with_slopes[0] || with_slopes[1] || with_slopes[2];
  const OfParts x = unit(c);
  std::array<Basis, 3> b, s;
  for (std::size_t d = 0; d < 3; ++d) chebyshev(x[static_cast<int>(d)], points[d], b[d], s[d]);
  ByTemperature slope = ByTemperature::Zero();
  std::size_t at = 0;
  for (std::size_t p = 0; p < static_cast<std::size_t>(points[0]); ++p)
    for (std::size_t q = 0; q < static_cast<std::size_t>(points[1]); ++q) {
      Flows along = Flows::Zero(), slope_along = Flows::Zero();
      for (std::size_t r = 0; r < static_cast<std::size_t>(points[2]); ++r) {
        const Flows& f = coefficients[at++];
        along += b[2][r] * f;
        if (any) slope_along += s[2][r] * f;
      }
      sum.value += b[0][p] * b[1][q] * along;
      if (!any) continue;
      slope.col(0) += s[0][p] * b[1][q] * along;
      slope.col(1) += b[0][p] * s[1][q] * along;
      slope.col(2) += b[0][p] * b[1][q] * slope_along;
    }
  const OfParts half = 0.5 * (box.greatest - box.least);
  for (int d = 0; d < 3; ++d)
    if (with_slopes[static_cast<std::size_t>(d)] && half[d] > 0.0)
      sum.by_temperature += slope.col(d) / half[d] * coordinates_by_parts().row(d);
}

const LossTable::Panel& LossTable::panel_at(const Layer& layer, const OfParts& c) {
  const Node* node = &layer.front();
  while (node->along >= 0) node = &layer[node->below + (c[node->along] > node->halved_at ? 1 : 0)];
  return node->panel;
}

LossTable::Value LossTable::at(const OfParts& t, bool with_slopes) const {
  const OfParts there = table_coordinates(t);
  Value sum;
  for (const Layer& layer : layers_) {
    const TemperatureBox& box = layer.front().panel.box;
    const OfParts c = there.cwiseMax(box.least).cwiseMin(box.greatest);
    std::array<bool, 3> slopes{};
    for (int d = 0; d < 3; ++d) slopes[static_cast<std::size_t>(d)] = with_slopes && c[d] == there[d];
    panel_at(layer, c).add(c, slopes, sum);
  }
  return sum;
}

double LossTable::distance(const OfParts& t, const Losses& losses) const {
  const Flows exact = flows_of(losses);
  const double largest = exact.lpNorm<Eigen::Infinity>();
  return largest > 0.0 ? (exact - value_at(t)).lpNorm<Eigen::Infinity>() / largest : 0.0;
}

}  // namespace prs
