#include "prs/sector/load_distribution.h"

namespace prs {

using fe::Dof;

SectorSolver::SectorSolver(Sector sector)
    : sector_(std::move(sector)),
      equations_(sector_.model),
      solver_(equations_),
      unit_load_(equations_.load_vector({{sector_.loaded_node, Dof::u, sector_.sense}})),
      rate_(equations_.size()) {}

Eigen::VectorXd SectorSolver::equal_shares(double axial_force) const {
  const double thread_load = axial_force / (sector_.rollers * sector_.contacts());
  // Axial shift of the pushing body against the pushed one.
  const auto shift = [&](Interface i) {
    const double cosine = sector_.cosine[i];
    const double approach = std::pow(thread_load / (cosine * sector_.hertz_constant[i]), 2.0 / 3.0);
    const double widest = *std::max_element(sector_.gaps[i].begin(), sector_.gaps[i].end());
    return sector_.sense * (approach + widest) / cosine;
  };
  const double roller = shift(Interface::nut);
  const double screw = roller + shift(Interface::screw);

  Eigen::VectorXd q = Eigen::VectorXd::Zero(equations_.size());
  const auto set = [&](const std::vector<int>& nodes, double u) {
    for (const int node : nodes) q[equations_.number(node, Dof::u)] = u;
  };
  set({sector_.loaded_node}, screw);
  set(sector_.screw_nodes, screw);
  set(sector_.roller_nodes, roller);
  set(sector_.roller_end_nodes, roller);
  return q;
}

fe::NewtonOptions SectorSolver::newton_options(double axial_force) const {
  fe::NewtonOptions options;
  options.force_scale = axial_force / sector_.rollers;
  options.length_scale = sector_.roller_radius;
  return options;
}

void add_offset_energy(fe::NewtonSummary& summary, double compliance, double force) {
  const double energy = -0.5 * compliance * force * force;
  summary.energy += energy;
  for (fe::NewtonIteration& iteration : summary.history) iteration.energy += energy;
}

LoadDistribution SectorSolver::solve(double axial_force) {
  const double sector_force = axial_force / sector_.rollers;
  state_ = equal_shares(axial_force);
  fe::NewtonSummary summary =
      solver_.solve(sector_force * unit_load_, newton_options(axial_force), state_);
  add_offset_energy(summary, sector_.offset_compliance, sector_force);
  LoadDistribution result = at(state_, axial_force);
  result.solve = std::move(summary);
  return result;
}

fe::NewtonSummary SectorSolver::go_on(double axial_force, const std::vector<fe::NodalLoad>& further,
                                      bool is_trial) {
  constexpr int kMostOfTrial = 30;
  const double sector_force = axial_force / sector_.rollers;
  fe::NewtonOptions options = newton_options(axial_force);
  std::function<bool()> held;
  if (is_trial) {
    options.max_iterations = kMostOfTrial;
    held = [] { return false; };
  }
  fe::NewtonSummary summary = solver_.solve(
      sector_force * unit_load_ + equations_.load_vector(further), options, state_, held);
  add_offset_energy(summary, sector_.offset_compliance, sector_force);
  return summary;
}

LoadDistribution SectorSolver::at(const fe::State& state, double axial_force) {
  LoadDistribution result;
  for (const Interface i : kInterfaces)
    for (int k = 0; k < sector_.contacts(); ++k) {
      const int spring = sector_.spring(i, k);
      result.normal_load[i].push_back(equations_.response(state, spring).force);
      result.approach[i].push_back(equations_.law_approach(state, spring));
    }
  result.axial_displacement = unit_load_.dot(state.head) + unit_load_.dot(state.tail) +
                              sector_.offset_compliance * axial_force / sector_.rollers;
  if (solver_.solve_tangent(state, unit_load_, rate_)) {
    const double flexibility = unit_load_.dot(rate_) + sector_.offset_compliance;
    if (flexibility > 0.0) result.tangent_stiffness = sector_.rollers / flexibility;
  }
  return result;
}

bool SectorSolver::state_rate(const Eigen::VectorXd& residual_rate, Eigen::VectorXd& rate) {
  return solver_.solve_tangent(state_, -residual_rate, rate);
}

}  // namespace prs
