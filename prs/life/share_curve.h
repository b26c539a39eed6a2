#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace prs {

/// Thread loads of one direction over the axial load F, as shares l or, where both flanks carry at
/// F = 0 too, as loads. A million loads need only some tens of
/// equilibria: between them the shares are interpolated, with an error that is controlled.
///
/// The value of a thread at one interface is its share l = N F_thread/(F/rollers), 1 where N
/// threads share equally; l and l^3 are polynomials of degree 8 in F^(1/3) (in which Hertz contacts
/// leave equal shares) on panels that are halved until both hit equilibria between the nodes within
/// a tolerance of the largest. Threads that open leave a kink, on which panels pile up.
class ShareCurve {
 public:
  static constexpr std::size_t kNodes = 9;
  static constexpr double kTolerance = 1e-8;

  /// Shares of all threads in equilibrium under an axial force > 0 [N], screw before nut; absent
  /// where the solve fails.
  using Solve = std::function<std::optional<std::vector<double>>(double force)>;

  struct Accuracy {
    double tolerance = kTolerance;
    /// What the shares between two forces [N] weigh: their error times this is held to the
    /// tolerance, and to `kWorstError` at least. 1 where it is not given.
    std::function<double(double from, double to)> weight = {};
  };
  static constexpr double kWorstError = 1e-2;

  /// Solves on [`least`, `greatest`] [N], 0 <= least <= greatest. Loads below count with the shares
  /// at `least`.
  ShareCurve(const Solve& solve, double least, double greatest, Accuracy accuracy);
  ShareCurve(const Solve& solve, double least, double greatest)
      : ShareCurve(solve, least, greatest, Accuracy{}) {}

  /// Solves at these forces alone [N], of which there must be one; a load between them counts with
  /// the shares at the next smaller one.
  ShareCurve(const Solve& solve, std::vector<double> forces);

  /// Where no equilibrium was found; the curve must then not be used.
  std::optional<double> failed_at() const { return failed_at_; }
  int solves() const { return solves_; }
  /// Largest error found of l and l^3 over their largest value, weighted, on the final panels.
  double error() const { return error_; }

  std::size_t node_count() const { return nodes_.size(); }
  const std::vector<double>& shares(std::size_t node) const { return nodes_[node]; }

  /// A load between the nodes: what is interpolated is sum_j weights[j] value(first + j).
  struct Place {
    std::size_t first = 0;
    std::array<double, kNodes> weights{};
  };
  Place place(double force) const;

  /// Interpolated shares at a load.
  void shares_at(double force, std::span<double> shares) const;

 private:
  struct Panel {
    double from, to;  ///< F^(1/3)
  };
  void refine(const Solve& solve, Panel panel, int depth);
  std::optional<std::vector<double>> solve_at(const Solve& solve, double x);

  Accuracy accuracy_;
  std::map<double, std::vector<double>> shared_;  ///< At ends and middles of panels, by F^(1/3).
  std::vector<Panel> panels_;
  std::vector<std::vector<double>> nodes_;  ///< kNodes a panel.
  std::optional<double> failed_at_;
  int solves_ = 0;
  double error_ = 0.0;
};

}  // namespace prs
