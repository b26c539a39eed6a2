#pragma once

#include "fe/newton.h"
#include "prs/sector/sector_model.h"

namespace prs {

/// A sector's numbers as bars, beams, shells and Hertz springs. x runs along the axis from the loaded end of the screw
/// into the mechanism, y outwards. Loads and the sections of screw and nut are those of the mechanism divided by the
/// number of rollers.
struct Sector : SectorModel {
  fe::Model model;
  /// Screw section that takes the load; the screw's first contact if there is no free length.
  int loaded_node = 0;
  std::vector<int> screw_nodes;  ///< Nodes at the contacts, thread 1 first.
  /// Nodes at the contacts, along x: one per tooth if the contacts lie opposite each other, else two.
  std::vector<int> roller_nodes;
  std::vector<int> nut_nodes;  ///< Nodes at the contacts.
  /// Outer and inner node of the roller's first end, inner and outer node of its last.
  std::vector<int> roller_end_nodes;

  /// Index in `model.springs` of the contact of thread k, 0 <= k < contacts().
  int spring(Interface i, int k) const { return i == Interface::screw ? k : contacts() + k; }
};

Sector build_sector(const SectorModel& model);

/// Guide loads of the roller at a state of a structure in which `node` maps the nodes of the sector.
template <class Node = std::identity>
GuideLoads guide_loads(const Sector& s, const fe::Equations& equations, const fe::State& state, Node node = {}) {
  GuideLoads guides;
  for (std::size_t k = 0; k < 4; ++k) {
    guides.displacement[k] = equations.displacement(state, node(s.roller_end_nodes[k]), fe::Dof::v);
    guides.force[k] = s.ring_guide().force(guides.displacement[k]);
  }
  return guides;
}

/// Whether a length of the roller is one of its plain ends.
inline bool is_head(const Sector& s, const fe::BeamElement& b) {
  return b.first == s.roller_end_nodes.front() || b.second == s.roller_end_nodes.back();
}

/// Builds the sector from the arguments of `sector_model`.
template <class... Parts>
Sector build_sector(const Mechanism& mechanism, const Parts&... parts) {
  return build_sector(sector_model(mechanism, parts...));
}

/// Distribution of one axial load over the threads of one roller. SI units, thread 1 first.
struct LoadDistribution {
  fe::NewtonSummary solve;
  PerInterface<std::vector<double>> normal_load;  ///< N [N]
  PerInterface<std::vector<double>> approach;     ///< Hertz approach delta [m]
  /// Displacement of the loaded section against the thrust section [m], > 0 along the load.
  double axial_displacement = 0.0;
  /// dF/du of the whole mechanism at the load [N/m]; absent if the tangent is singular.
  std::optional<double> tangent_stiffness;
  std::vector<GuideLoads> guides;  ///< Guides of each roller solved, if they have a clearance.
};

/// Solver of the load distribution of one-dimensional bodies. Both agree within 1e-10.
enum class Solver {
  sparse,  ///< Newton's method on the sparse matrix of the sector.
  chain,   ///< Station by station, several times as fast; `sparse` where it does not converge.
};

/// Adds the energy of a spring of this compliance [m/N] between the loaded section and a force [N], for the part of the
/// displacement that the model's freedoms do not contain: -c F^2/2.
void add_offset_energy(fe::NewtonSummary& summary, double compliance, double force);

/// Solves load after load on one sector with a shared symbolic factorization.
class SectorSolver {
 public:
  explicit SectorSolver(Sector sector);
  SectorSolver(const SectorSolver&) = delete;
  SectorSolver& operator=(const SectorSolver&) = delete;

  /// Equilibrium under the axial force on the whole mechanism [N], > 0. Starts from rigid bodies
  /// that share the load equally, so the answer does not depend on earlier loads.
  LoadDistribution solve(double axial_force);

  /// Equilibrium under further loads [N, N m] besides the axial force, from the last state on. `is_trial`: whether the
  /// loads may have no equilibrium, so that the solver gives up early.
  fe::NewtonSummary go_on(double axial_force, const std::vector<fe::NodalLoad>& further, bool is_trial);

  /// Equilibrium under a load that follows the state, see `fe::NewtonSolver::follow`.
  bool follow(double axial_force, const fe::FollowingLoad& load) {
    return solver_.follow(load, newton_options(axial_force), state_);
  }

  /// Loads and displacements of a state under the axial force, in equilibrium or not; `solve` is left empty.
  LoadDistribution at(const fe::State& state, double axial_force);

  /// State at the end of the last solve.
  const fe::State& state() const { return state_; }

  /// dq/dt at the last solve's state for the rate dr/dt of the residual: K x = -rate. Returns false if the tangent K is
  /// singular.
  bool state_rate(const Eigen::VectorXd& residual_rate, Eigen::VectorXd& rate);

  /// State of rigid bodies with equal shares: screw and roller shifted until every thread carries.
  Eigen::VectorXd equal_shares(double axial_force) const;

  const Sector& sector() const { return sector_; }
  const fe::Equations& equations() const { return equations_; }
  /// Load vector of a unit force per sector along the load's direction.
  const Eigen::VectorXd& unit_load() const { return unit_load_; }
  fe::NewtonOptions newton_options(double axial_force) const;

 private:
  Sector sector_;
  fe::Equations equations_;
  fe::NewtonSolver solver_;
  Eigen::VectorXd unit_load_;
  fe::State state_;
  Eigen::VectorXd rate_;
};

}  // namespace prs
