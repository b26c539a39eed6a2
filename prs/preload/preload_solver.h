#pragma once

#include "fe/newton.h"
#include "prs/preload/preload_sector.h"

namespace prs {

/// Loads of one side; zero where it has opened.
struct SideLoads {
  PerInterface<double> axial_load;                ///< [N]
  PerInterface<double> max_normal_load;           ///< On one thread of one roller [N].
  PerInterface<std::vector<double>> normal_load;  ///< On each thread of a roller [N].
};

/// Equilibrium under one external load.
struct PreloadPoint {
  double axial_force = 0.0;  ///< > 0 in tension [N].
  fe::NewtonSummary solve;
  /// Loaded section against the section that holds the load, less its place without external load
  /// [m]; > 0 in tension.
  double axial_displacement = 0.0;
  std::optional<double> tangent_stiffness;  ///< dF/du [N/m]; absent where the screw is loose.
  /// tension less compression is the external load, at each interface.
  PerDirection<SideLoads> sides;
};

/// Equilibria of a mechanism whose sides push against each other, its first nut held at one
/// section. A side that has opened takes no part: beyond its opening the load is carried as without
/// preload.
class PreloadSolver {
 public:
  explicit PreloadSolver(PreloadSector sector);
  PreloadSolver(PreloadSolver&&) noexcept;
  ~PreloadSolver();

  /// Equilibrium without external load.
  const PreloadPoint& at_rest() const { return rest_; }

  /// Equilibrium under an external load [N], > 0 in tension. Does not depend on earlier loads.
  PreloadPoint solve(double axial_force);

  /// Equilibrium under further loads [N, N m] besides the external one, from the last solve on, the
  /// same sides at work.
  PreloadPoint go_on(double axial_force, const std::vector<fe::NodalLoad>& further);

  const PreloadSector& sector() const { return sector_; }

  /// Magnitude of the smallest external load of a sense at which the last contact of the other side
  /// opens [N]. Absent without preload, where the side stays closed up to 1000 times the preload (a
  /// roller that bends more and more reaches the flanks behind it), and where a solve fails.
  std::optional<double> opening_force(Direction sense);

 private:
  class Branch;
  Branch& both();
  Branch& branch(Direction carrying);
  double force_scale(double axial_force) const;
  /// What the state of a branch says.
  void set_point(Branch& at_work, PreloadPoint& point);

  PreloadSector sector_;
  bool preloaded_;
  std::unique_ptr<Branch> both_;
  PerDirection<std::unique_ptr<Branch>> one_;
  PerDirection<std::optional<double>> opening_;
  fe::State rest_state_;
  PreloadPoint rest_;
  Branch* last_ = nullptr;  ///< Of the last solve.
  fe::State last_state_;
};

/// The fit that a preload asks for. The interference of a single nut is shared between screw and
/// nut so that the rollers float: without external load their guides take no radial force.
Fit find_fit(const PreloadSector& sector, const Preload& preload);

/// The same fit once the parts have expanded: the rollers of a single nut float anew.
Fit at_temperature(const PreloadSector& expanded, const Fit& fit);

/// Interference of a fit, as defined for `Preload::interference` [m].
double interference(const PreloadSector& sector, const Fit& fit);

}  // namespace prs
