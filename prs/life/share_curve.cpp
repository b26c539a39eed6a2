#include "prs/life/share_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prs {
namespace {

constexpr std::size_t kNodes = ShareCurve::kNodes;
/// Panels get no narrower: a kink costs that many halvings.
constexpr int kMostHalvings = 22;
/// Where a panel is checked, between its nodes on [-1, 1].
constexpr double kChecks[] = {-0.96, -0.55, 0.19, 0.75};

/// Chebyshev points of the second kind on [-1, 1], ends included.
std::array<double, kNodes> chebyshev_points() {
  std::array<double, kNodes> points{};
  for (std::size_t j = 0; j < kNodes; ++j)
    points[j] = 2 * j + 1 == kNodes
                    ? 0.0
                    : -std::cos(std::numbers::pi * static_cast<double>(j) / (kNodes - 1));
  return points;
}

/// Lagrange polynomials of these points at t, by the barycentric formula (Berrut & Trefethen 2004).
std::array<double, kNodes> lagrange(double t) {
  static const std::array<double, kNodes> kPoints = chebyshev_points();
  std::array<double, kNodes> l{};
  double sum = 0.0;
  for (std::size_t j = 0; j < kNodes; ++j) {
    const double distance = t - kPoints[j];
    if (distance == 0.0) {
      l.fill(0.0);
      l[j] = 1.0;
      return l;
    }
    const double end = j == 0 || j == kNodes - 1 ? 0.5 : 1.0;
    l[j] = (j % 2 == 0 ? end : -end) / distance;
    sum += l[j];
  }
  for (double& value : l) value /= sum;
  return l;
}

double cube(double x) { return x * x * x; }

/// Error of the interpolated shares and of their cubes against those solved, relative to the
/// largest.
double interpolation_error(std::span<const std::vector<double>> nodes, double t,
                           std::span<const double> solved) {
  const std::array<double, kNodes> weights = lagrange(t);
  double largest = 0.0, of_shares = 0.0, of_cubes = 0.0;
  for (std::size_t k = 0; k < solved.size(); ++k) {
    double share = 0.0, cubed = 0.0;
    for (std::size_t j = 0; j < kNodes; ++j) {
      share += weights[j] * nodes[j][k];
      cubed += weights[j] * cube(nodes[j][k]);
    }
    largest = std::max(largest, solved[k]);
    of_shares = std::max(of_shares, std::abs(share - solved[k]));
    of_cubes = std::max(of_cubes, std::abs(cubed - cube(solved[k])));
  }
  return std::max(of_shares / largest, of_cubes / cube(largest));
}

}  // namespace

ShareCurve::ShareCurve(const Solve& solve, double least, double greatest, Accuracy accuracy)
    : accuracy_(std::move(accuracy)) {
  const Panel all{std::cbrt(least), std::cbrt(greatest)};
  if (least < greatest) {
    refine(solve, all, 0);
  } else if (const auto shares = solve_at(solve, all.from)) {
    panels_.push_back(all);
    nodes_.assign(kNodes, *shares);
  }
  shared_.clear();
}

ShareCurve::ShareCurve(const Solve& solve, std::vector<double> forces) {
  std::ranges::sort(forces);
  forces.erase(std::unique(forces.begin(), forces.end()), forces.end());
  for (const double force : forces) {
    const double x = std::cbrt(force);
    const auto shares = solve_at(solve, x);
    if (!shares) return;
    panels_.push_back({x, x});
    nodes_.insert(nodes_.end(), kNodes, *shares);
  }
}

std::optional<std::vector<double>> ShareCurve::solve_at(const Solve& solve, double x) {
  ++solves_;
  std::optional<std::vector<double>> shares = solve(cube(x));
  if (!shares) failed_at_ = cube(x);
  return shares;
}

void ShareCurve::refine(const Solve& solve, Panel panel, int depth) {
  const double middle = 0.5 * (panel.from + panel.to);
  const auto at = [&](double t) {
    return t == -1.0  ? panel.from
           : t == 1.0 ? panel.to
                      : middle + 0.5 * t * (panel.to - panel.from);
  };
  std::vector<std::vector<double>> nodes;
  for (const double t : chebyshev_points()) {
    const double x = at(t);
    const auto known = shared_.find(x);
    std::optional<std::vector<double>> shares =
        known != shared_.end() ? std::optional(known->second) : solve_at(solve, x);
    if (!shares) return;
    if (x == panel.from || x == middle || x == panel.to) shared_.emplace(x, *shares);
    nodes.push_back(std::move(*shares));
  }
  const double weight = accuracy_.weight
                            ? std::max(accuracy_.weight(cube(panel.from), cube(panel.to)),
                                       accuracy_.tolerance / kWorstError)
                            : 1.0;
  double error = 0.0;
  for (const double t : kChecks) {
    const std::optional<std::vector<double>> shares = solve_at(solve, at(t));
    if (!shares) return;
    error = std::max(error, weight * interpolation_error(nodes, t, *shares));
    if (error > accuracy_.tolerance) break;
  }
  if (error > accuracy_.tolerance && depth < kMostHalvings) {
    refine(solve, {panel.from, middle}, depth + 1);
    if (!failed_at_) refine(solve, {middle, panel.to}, depth + 1);
    return;
  }
  error_ = std::max(error_, error);
  panels_.push_back(panel);
  std::ranges::move(nodes, std::back_inserter(nodes_));
}

ShareCurve::Place ShareCurve::place(double force) const {
  const double x = std::clamp(std::cbrt(force), panels_.front().from, panels_.back().to);
  const auto next = std::upper_bound(panels_.begin() + 1, panels_.end(), x,
                                     [](double value, const Panel& p) { return value < p.from; });
  const auto k = static_cast<std::size_t>(next - panels_.begin()) - 1;
  const Panel& panel = panels_[k];
  const double width = panel.to - panel.from;
  const double t = width > 0.0 ? (x - panel.from) / width * 2.0 - 1.0 : 0.0;
  return {k * kNodes, lagrange(t)};
}

void ShareCurve::shares_at(double force, std::span<double> shares) const {
  const Place p = place(force);
  std::ranges::fill(shares, 0.0);
  for (std::size_t j = 0; j < kNodes; ++j)
    for (std::size_t k = 0; k < shares.size(); ++k)
      shares[k] += p.weights[j] * nodes_[p.first + j][k];
}

}  // namespace prs
