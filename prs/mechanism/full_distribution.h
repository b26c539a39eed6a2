#pragma once

#include "prs/mechanism/full_model.h"
#include "prs/sector/sector.h"

namespace prs {

/// Displacement and stiffness of the loaded section of the screw, in the order x, y, z, theta_y,
/// theta_z.
struct ScrewEnd {
  Eigen::Matrix<double, 5, 1> displacement;  ///< The misalignment of the nut included [m, rad].
  std::vector<int> freedoms;                 ///< Those that no bearing holds there.
  /// Their displacements per load and the inverse, at the load; empty where a motion is free.
  Eigen::MatrixXd compliance, stiffness;
  std::string left_out;  ///< Why they are.
};

/// Force and moment of a support on the part that it holds.
struct SupportForce {
  double position = 0.0;                            ///< x [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< [N]
  Lateral moment;                                   ///< About y and z there [N m].
};

struct RingForce {
  double position = 0.0;        ///< x where force and moment act [m].
  Lateral force;                ///< Force of the ring on the rollers [N].
  Lateral moment;               ///< The same about y and z there [N m].
  std::vector<double> rollers;  ///< On each roller, outwards; missing ones 0 [N].
};

/// The same screw under the axial force alone: all rollers, nominal parts, aligned.
struct SymmetricLoads {
  double axial_displacement = 0.0;           ///< [m]
  std::optional<double> tangent_stiffness;   ///< [N/m]
  PerInterface<double> largest_normal_load;  ///< [N]
};

/// How a load spreads over all rollers. SI units.
struct FullDistribution {
  fe::NewtonSummary solve;
  std::string reason;  ///< Reason why a load has no equilibrium: which motion, or how much is left.
  int freedoms = 0;
  PerInterface<RollerThreads> normal_load;  ///< N [N]
  PerInterface<RollerThreads> approach;     ///< Hertz approach delta [m]
  double axial_displacement = 0.0;          ///< Displacement of the loaded section, > 0 along the load [m].
  std::optional<double> tangent_stiffness;  ///< dF/du, see `axial_compliance` [N/m]
  ScrewEnd screw_end;
  PerInterface<double> largest_opening;  ///< Largest opening of an open contact, along its normal [m].
  std::vector<int> idle_rollers;         ///< Numbers from 0 of those that carry no load.
  SupportForce nut;
  std::array<RingForce, 2> rings;  ///< Near and far.
  std::vector<GuideLoads> guides;  ///< Guides of each roller where they have a clearance; zero of missing rollers.
  std::vector<SupportForce> bearings;
};

/// du_x/dF of the loaded section [m/N] while the force stays where it acts, so that its moments
/// grow with it: C_xx + e_z C_x,theta_y - e_y C_x,theta_z, without a freedom that a bearing holds
/// there.
double axial_compliance(const ScrewEnd& end, const Lateral& eccentricity);

struct FullStructure;
/// The outcome where motions are free; nothing where none is.
std::optional<FullDistribution> mechanism(const FullModel& model, const FullStructure& structure);

/// Equilibrium by Newton's method from the state of linear contacts with the secant stiffness of
/// equal shares. Two outcomes are none of the solver's: `mechanism`, a motion that nothing resists,
/// and `no_equilibrium`, a load that flanks that only push cannot hold. The stiffness of the
/// screw's end belongs to Detail::complete.
FullDistribution solve(const FullModel& model, Detail detail = Detail::complete);

/// Start of the iteration for one model after the other.
enum class FullStart {
  linear,     ///< As if each were the first: no answer depends on those before.
  neighbour,  ///< The nearest of the last states: fewer iterations to the same loads, within the
              ///< tolerance of Newton's method.
  onwards     ///< What the last states, all under one load, go on to.
};

/// `solve` for one model after the other: those that differ in numbers only share the numbering,
/// the pattern and its symbolic factorization.
class FullSolver {
 public:
  explicit FullSolver(FullStart start = FullStart::linear);
  ~FullSolver();
  FullSolver(FullSolver&&) noexcept;
  FullSolver& operator=(FullSolver&&) noexcept;

  FullDistribution solve(const FullModel& model, Detail detail = Detail::complete);

 private:
  struct Parts;
  FullStart start_;
  std::unique_ptr<Parts> parts_;
};

/// By one sector.
SymmetricLoads symmetric_loads(const FullModel& model);
/// From the loads of a sector whose nut is held rigidly.
SymmetricLoads symmetric_loads(const FullModel& model, const LoadDistribution& sector);

/// What a turn of the carrier does to the threads of each roller.
struct OrbitLoads {
  std::vector<double> first_roller;  ///< Its largest N at each position [N].
  RollerThreads equivalent;          ///< (mean N^exponent)^(1/exponent) [N]
  RollerThreads peak;                ///< Largest N of each contact [N].
  double largest_equivalent = 0.0;   ///< [N]
  double largest = 0.0;              ///< N, of any position [N].
  double least = 0.0;                ///< [N]
  double carrier_angle = 0.0;        ///< At the largest load [rad].
  int roller = 0, thread = 0;        ///< Roller and thread of the largest load, from 1.
};

struct Orbit {
  /// The first position without equilibrium; nothing else is then known.
  struct Failure {
    double carrier_angle = 0.0;  ///< [rad]
    std::string why;             ///< What the solver says, in words.
  };
  std::optional<Failure> failure;
  bool converged() const { return !failure; }

  int steps = 0;      ///< Positions for each spacing of the rollers.
  int positions = 0;  ///< Positions of the whole turn.
  double exponent = 0.0;
  std::vector<double> carrier_angle;  ///< Angle at each position [rad].
  PerInterface<OrbitLoads> loads;
  std::vector<double> axial_displacement;  ///< At the positions that differ [m].
  double axial_error = 0.0;                ///< Peak to peak [m].
};

/// Which positions of the carrier have loads of their own.
struct OrbitSymmetry {
  bool alike = false;  ///< All rollers are: one spacing is solved, the rest is a permutation.
  bool round = false;  ///< Nothing but the rollers has an azimuth: one position is solved.
};

/// The carrier at carrier_angle + 2 pi m/(steps N), m < steps N. `model` makes the mechanism at a
/// carrier angle.
Orbit orbit(const std::function<FullModel(double)>& model,
            const std::function<FullDistribution(const FullModel&)>& solver, const SpatialLoad::Orbit& wanted,
            double carrier_angle, OrbitSymmetry symmetry);

}  // namespace prs
