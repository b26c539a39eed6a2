#pragma once

#include "prs/sector/sector.h"

namespace prs {

/// Contacts that carry one sense of the external load. Those of the other sense oppose them.
struct Side {
  PerInterface<std::vector<int>> springs;  ///< Indices in the model's springs, thread 1 first.
  std::vector<int> roller_nodes;           ///< Nodes, with ends, of the rollers that they touch.
};

/// Overlap of the undeformed parts; play if < 0.
struct Fit {
  PerInterface<double> radial;  ///< Single nut: roller into the grooves of each body [m].
  double axial = 0.0;           ///< Double nut: excess length of the spacer over the gap between the nuts [m].
};

/// One roller of each set with its share of screw and nut, contacts of both senses of the load
/// among them. Axes, loads and sections are those of `Sector`.
///
///     single nut   tension and compression flanks of one roller, in one nut
///     double nut   first nut compression, second nut tension; the spacer between them pushes them
///                  apart and stretches the screw; the first nut is held
struct PreloadSector {
  Preload::Arrangement arrangement = Preload::Arrangement::single_nut;
  fe::Model model;
  int loaded_node = 0;
  std::vector<int> screw_nodes;  ///< Nodes of loaded section and contacts.
  PerDirection<Side> sides;
  PerInterface<ContactLaw> laws;
  Fit fit;
  /// Interference added by expansion since the fit was made [m].
  double expansion = 0.0;
  int rollers = 1;
  double roller_radius = 0.0;
  /// Sectors of one flank each from which this one is built, and their nodes here.
  struct Flank {
    std::shared_ptr<const Sector> sector;
    std::vector<int> node;
  };
  PerDirection<Flank> flanks;

  bool rollers_are_shared() const { return arrangement == Preload::Arrangement::single_nut; }
};

/// Inputs from which both arrangements are built.
struct PreloadParts {
  const Mechanism& mechanism;
  const Structure& structure;
  const Materials& materials;
  const ModelOptions& options;
  const PerInterface<ContactLaw>& laws;
  const Deviations& deviations;
  const Preload& preload;
};

/// Parts whose play is removed: at the reference temperature, before they expand, or at their actual temperature.
enum class Play { of_cold_parts, of_warm_parts };

/// Builds the sector without play and without preload: the closest thread of each interface touches on both sides of
/// parts at the reference temperature. Temperatures come afterwards, play is not removed again: with a = alpha dT x and
/// rho = alpha dT r, x from one origin and r the pitch radii, they add
///
///     screw  g_T = -s cos(psi)(a_S - a_R) - sin(psi)(rho_S + rho_R),
///     nut    g_T = -s cos(psi)(a_R - a_N) - sin(psi)(rho_R - rho_N).
///
/// The first nut is held at `section` [m] as under a load of that sense. The second nut is like the first, without its
/// flanges. The case must have passed `check_case`.
PreloadSector build_preload_sector(const PreloadParts& parts, Direction sense, double section,
                                   Play play = Play::of_cold_parts);

/// The sector without play or preload with the gaps of a fit:
///
///     single nut   g - radial sin(psi) at every contact of an interface,
///     double nut   g - axial cos(psi) at the second nut's roller-nut contacts.
PreloadSector fitted(PreloadSector sector, const Fit& fit);

/// Pushes on the rollers as loads, see `push_loads` of a sector. A single nut has one roller: its centrifugal force
/// belongs to one of the pushes.
std::vector<fe::NodalLoad> push_loads(const PreloadSector& sector, const PerDirection<RollerPush>& push);

/// The sector after the other side has opened: its contacts have no stiffness, rollers that only it touches are held in
/// place.
PreloadSector one_sided(PreloadSector sector, Direction carrying);

/// Loads of one side; zero if it has opened.
struct SideLoads {
  PerInterface<double> axial_load;                ///< [N]
  PerInterface<double> max_normal_load;           ///< Largest load on one thread of one roller [N].
  PerInterface<std::vector<double>> normal_load;  ///< Load on each thread of a roller [N].
};

/// Equilibrium under one external load.
struct PreloadPoint {
  double axial_force = 0.0;  ///< > 0 in tension [N].
  fe::NewtonSummary solve;
  /// Displacement of the loaded section against the supported one, less that without external load [m]; > 0 in tension.
  double axial_displacement = 0.0;
  std::optional<double> tangent_stiffness;  ///< dF/du [N/m]; absent if the screw is loose.
  /// Loads of both sides: tension less compression is the external load, at each interface.
  PerDirection<SideLoads> sides;
  /// Guides with a clearance: of the rollers, or of the tension and of the compression nut's.
  std::vector<GuideLoads> guides;
};

/// Equilibria of a mechanism whose sides push against each other, its first nut held at one section. A side that has
/// opened carries nothing; the other side then carries the load as without preload.
class PreloadSolver {
 public:
  explicit PreloadSolver(PreloadSector sector);
  PreloadSolver(PreloadSolver&&) noexcept;
  ~PreloadSolver();

  /// Equilibrium without external load.
  const PreloadPoint& at_rest() const { return rest_; }

  /// Equilibrium under an external load [N], > 0 in tension. Independent of earlier loads.
  PreloadPoint solve(double axial_force);

  /// Equilibrium under further loads [N, N m] besides the external one, from the last solve on, with the same loaded
  /// sides.
  PreloadPoint go_on(double axial_force, const std::vector<fe::NodalLoad>& further);

  const PreloadSector& sector() const { return sector_; }

  /// Magnitude of the smallest external load of a sense at which the last contact of the other side opens [N]. Absent
  /// without preload, if the side stays closed up to 1000 times the preload (a roller that bends more and more reaches
  /// the flanks behind it), and if a solve fails.
  std::optional<double> opening_force(Direction sense);

 private:
  class Branch;
  Branch& both();
  Branch& branch(Direction carrying);
  double force_scale(double axial_force) const;
  /// Sets a point from the state of a branch.
  void set_point(Branch& at_work, PreloadPoint& point);

  PreloadSector sector_;
  bool preloaded_;
  std::unique_ptr<Branch> both_;
  PerDirection<std::unique_ptr<Branch>> one_;
  PerDirection<std::optional<double>> opening_;
  fe::State rest_state_;
  PreloadPoint rest_;
  Branch* last_ = nullptr;  ///< Branch of the last solve.
  fe::State last_state_;
};

/// Fit for a preload. The interference of a single nut is shared between screw and nut so that the rollers float:
/// without external load their guides take no radial force.
Fit find_fit(const PreloadSector& sector, const Preload& preload);

/// The fit after expansion of the parts: the rollers of a single nut float again.
Fit at_temperature(const PreloadSector& expanded, const Fit& fit);

/// Interference of a fit, as defined for `Preload::interference` [m].
double interference(const PreloadSector& sector, const Fit& fit);

}  // namespace prs
