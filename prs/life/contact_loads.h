#pragma once

#include <functional>
#include <map>
#include <set>

#include "prs/slip/slip_equilibrium.h"
#include "prs/threads/contacts.h"

namespace prs {

/// Thread loads of one direction over the axial load F, as shares l or, if both flanks carry at F = 0 too, as loads. A
/// million loads need only some tens of equilibria: between them the shares are interpolated, with an error that is
/// controlled.
///
/// The value of a thread at one interface is its share l = N F_thread/(F/rollers), 1 if N threads share equally; l and
/// l^3 are polynomials of degree 8 in F^(1/3) (in which Hertz contacts deviate from equal shares) on panels that are
/// halved until both agree with equilibria between the nodes within a tolerance of the largest. Threads that open cause
/// a kink, at which panels become narrow.
class ShareCurve {
 public:
  static constexpr std::size_t kNodes = 9;
  static constexpr double kTolerance = 1e-8;

  /// Shares of all threads in equilibrium under an axial force > 0 [N], screw before nut; absent if the solve fails.
  using Solve = std::function<std::optional<std::vector<double>>(double force)>;

  struct Accuracy {
    double tolerance = kTolerance;
    /// Weight of the shares between two forces [N]: their error times the weight must be within the tolerance, and the
    /// error within `kWorstError`. 1 if not given.
    std::function<double(double from, double to)> weight = {};
  };
  static constexpr double kWorstError = 1e-2;

  /// Solves on [`least`, `greatest`] [N], 0 <= least <= greatest. Smaller loads get the shares at `least`.
  ShareCurve(const Solve& solve, double least, double greatest, Accuracy accuracy);
  ShareCurve(const Solve& solve, double least, double greatest) : ShareCurve(solve, least, greatest, Accuracy{}) {}

  /// Solves at these forces only [N], at least one; a load between them gets the shares at the next smaller one.
  ShareCurve(const Solve& solve, const std::set<double>& forces);

  /// Force at which no equilibrium was found; the curve must then not be used.
  std::optional<double> failed_at() const { return failed_at_; }
  int solves() const { return solves_; }
  /// Largest error found of l and l^3 over their largest value, weighted, on the final panels.
  double error() const { return error_; }

  std::size_t node_count() const { return nodes_.size(); }
  const std::vector<double>& shares(std::size_t node) const { return nodes_[node]; }

  /// Place of a load between the nodes: the interpolated value is sum_j weights[j] value(first + j).
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
  std::map<double, std::vector<double>> shared_;  ///< Values at ends and middles of panels, by F^(1/3).
  std::vector<Panel> panels_;
  std::vector<std::vector<double>> nodes_;  ///< Values at nodes, kNodes per panel.
  std::optional<double> failed_at_;
  int solves_ = 0;
  double error_ = 0.0;
};

/// Contacts with a life of their own, in the order of a list of their loads. For each flank the list has the threads of
/// the screw, those of the nut and, for a full mechanism, those of each roller at the screw and at the nut. With
/// preload the total load of the flank follows.
struct RatedContacts {
  std::size_t threads = 0;   ///< Threads per roller.
  std::size_t rollers = 0;   ///< Rollers of a full mechanism; 0: one roller represents all.
  bool both_flanks = false;  ///< Whether tension and compression flanks are loaded under each load: preload.

  std::size_t of_flank() const { return 2 * threads * (1 + rollers) + (both_flanks ? 1 : 0); }
  std::size_t count() const { return (both_flanks ? 2 : 1) * of_flank(); }
  /// Index at which the flanks of a direction begin.
  std::size_t flank(Direction d) const { return both_flanks && d == Direction::compression ? of_flank() : 0; }
  /// Indices at which an interface begins on a flank: threads of screw or nut, and of the rollers.
  std::size_t body(Interface i) const { return i == Interface::screw ? 0 : threads; }
  std::size_t roller(Interface i) const { return threads * (i == Interface::screw ? 2 : 2 + rollers); }
  /// Index of a flank's total load, with preload.
  std::size_t side() const { return 2 * threads * (1 + rollers); }
};

/// Largest axial loads of the threads of an interface [N].
using LargestLoads = PerInterface<std::vector<double>>;

/// Loads of a mechanism under one axial force.
struct ContactLoads {
  /// For each rated contact the load of the mechanism at which all contacts would carry as much as it does; as a share
  /// of the force, with preload in N. A thread of screw or nut meets all rollers in turn and has the cubic mean of
  /// their loads, over a turn of the carrier; a thread of a roller has its own.
  std::vector<double> rated;
  /// Largest axial load of each thread over all rollers and positions of the carrier [N].
  PerDirection<LargestLoads> largest;
  /// Angle of the carrier at the largest load of an interface [rad]; full mechanism only.
  PerInterface<double> carrier_angle;
};

/// Loads under a force > 0 of one sense, with preload >= 0 [N]; none without equilibrium.
using ContactSolver = std::function<std::optional<ContactLoads>(double force)>;
using LargestSolver = std::function<std::optional<LargestLoads>(double force)>;

/// Model rated by `life`: a case, its threads and their contact laws.
struct LifeModel {
  const Conditions& c;
  const Contacts& contacts;
  PerInterface<ContactLaw> laws;
  std::optional<Oils> oils = {};  ///< Oils that replace the lubricant at the temperature of the file.

  /// Whether fatigue is computed from loads of the running screw.
  bool running() const { return life_takes_running_loads(c); }
  bool solved() const { return c.life->share == LoadCase::Share::solved; }
  bool preloaded() const { return c.preload.has_value(); }
  bool full() const { return solved() && c.model.all_rollers(); }
  /// Whether threads carry load, and may reach a limit, without any axial force, for other reasons than preload.
  bool is_loaded_across() const;
  RatedContacts rated() const;
  /// Axial load of a thread with equal shares per axial force.
  double equal_share() const;
};

/// Largest loads of the flanks of a direction under a force of its sense; for a full mechanism at the carrier angle of
/// `at`.
LargestSolver largest_solver(const LifeModel& model, Direction d, const ContactSolver& solver, const ContactLoads& at);

/// Reason why all rollers have no equilibrium under a force of this sense, at the first carrier angle without one;
/// empty if the model only reports that it did not converge.
std::string why_not_held(const LifeModel& model, Direction d, double force);

/// A solver for each wanted sense of the load, at rest. Throws CaseError if the preload has no fit.
PerDirection<ContactSolver> contact_solvers(const LifeModel& model, const PerDirection<bool>& wanted);

/// A load case of `life` of one sense, before its force is set, driven by the screw or the load at the magnitude of
/// `operation.speed`.
LoadCase driven_load_case(const Conditions& c, double lead, Direction d, DrivenBy driven_by);

/// Loads of the running screw under a force > 0 of one sense, with preload >= 0, driven by the screw or the load at the
/// magnitude of `operation.speed`. Fatigue and pressure follow the normal loads N: a thread counts with N cos(psi),
/// shares of which no longer sum to n_t.
ContactSolver running_loads_solver(const LifeModel& model, Direction d, DrivenBy driven_by);

}  // namespace prs
