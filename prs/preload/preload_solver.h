#pragma once

#include "prs/sector/sector.h"

namespace prs {

/// The contacts that carry one sense of the external load. Those of the other sense oppose them.
struct Side {
  PerInterface<std::vector<int>> springs;  ///< Indices in the model's springs, thread 1 first.
  std::vector<int> roller_nodes;           ///< Nodes of the rollers they touch, with ends.
};

/// By how much the undeformed parts overlap; play where < 0.
struct Fit {
  PerInterface<double> radial;  ///< Single nut: roller into the grooves of each body [m].
  double axial = 0.0;           ///< Double nut: spacer beyond the place between the nuts [m].
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
  std::vector<int> screw_nodes;  ///< Loaded section and contacts.
  PerDirection<Side> sides;
  PerInterface<ContactLaw> laws;
  Fit fit;
  /// What expansion adds to the interference since the fit was made [m].
  double expansion = 0.0;
  int rollers = 1;
  double roller_radius = 0.0;
  /// The sectors of one flank each that this one is made of, and where their nodes are here.
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

/// Whose play is taken out: of parts at the reference temperature, which then expand, or of parts
/// as warm as they are.
enum class Play { of_cold_parts, of_warm_parts };

/// Builds the sector without play and without preload: the closest thread of each interface touches
/// on both sides of parts at the reference temperature. Temperatures come afterwards, play is not
/// taken out again: with a = alpha dT x and rho = alpha dT r, x from one origin and r the pitch
/// radii, they add
///
///     screw  g_T = -s cos(psi)(a_S - a_R) - sin(psi)(rho_S + rho_R),
///     nut    g_T = -s cos(psi)(a_R - a_N) - sin(psi)(rho_R - rho_N).
///
/// The first nut is held at `section` [m] as under a load of that sense. The second
/// nut is like the first, without its flanges. The case must have passed `check_case`.
PreloadSector build_preload_sector(const PreloadParts& parts, Direction sense, double section,
                                   Play play = Play::of_cold_parts);

/// The sector without play or preload with the gaps of a fit:
///
///     single nut   g - radial sin(psi) at every contact of an interface,
///     double nut   g - axial cos(psi) at the second nut's roller-nut contacts.
PreloadSector fitted(PreloadSector sector, const Fit& fit);

/// Pushes on the rollers as loads, see `push_loads` of a sector. A single nut has one roller: its
/// centrifugal force stands in one of them.
std::vector<fe::NodalLoad> push_loads(const PreloadSector& sector, const PerDirection<RollerPush>& push);

/// The sector once the other side has opened and takes no part: its contacts are without stiffness,
/// rollers that only it touches are held where they are.
PreloadSector one_sided(PreloadSector sector, Direction carrying);

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
  /// Guides with a clearance: those of the rollers, or of the tension and of the compression nut's.
  std::vector<GuideLoads> guides;
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
  Branch* last_ = nullptr;  ///< Branch of the last solve.
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
