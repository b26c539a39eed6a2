#pragma once

#include "prs/mechanism/full_model.h"
#include "prs/sector/sector.h"

namespace prs {

/// Displacement and stiffness of the loaded section of the screw, in the order x, y, z, theta_y,
/// theta_z.
struct ScrewEnd {
  Eigen::Matrix<double, 5, 1> displacement;  ///< Displacement, including the misalignment of the nut [m, rad].
  std::vector<int> freedoms;                 ///< Freedoms that no bearing holds there.
  /// Displacements of these freedoms per load, and the inverse, at the load; empty if a motion is free.
  Eigen::MatrixXd compliance, stiffness;
  std::string left_out;  ///< Reason why they are empty.
};

/// Force and moment of a support on the part that it holds.
struct SupportForce {
  double position = 0.0;                            ///< x [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< [N]
  Lateral moment;                                   ///< Moment about y and z at `position` [N m].
};

struct RingForce {
  double position = 0.0;        ///< x of the point of action [m].
  Lateral force;                ///< Force of the ring on the rollers [N].
  Lateral moment;               ///< Moment on the rollers about y and z there [N m].
  std::vector<double> rollers;  ///< Force on each roller, outwards; 0 for missing ones [N].
};

/// Loads of the screw under the axial force alone: all rollers, nominal parts, aligned.
struct SymmetricLoads {
  double axial_displacement = 0.0;           ///< [m]
  std::optional<double> tangent_stiffness;   ///< [N/m]
  PerInterface<double> largest_normal_load;  ///< [N]
};

/// Distribution of a load over all rollers. SI units.
struct FullDistribution {
  fe::NewtonSummary solve;
  std::string reason;  ///< Reason why a load has no equilibrium: the free motion, or the remaining force.
  int freedoms = 0;
  PerInterface<RollerThreads> normal_load;  ///< N [N]
  PerInterface<RollerThreads> approach;     ///< Hertz approach delta [m]
  double axial_displacement = 0.0;          ///< Displacement of the loaded section, > 0 along the load [m].
  std::optional<double> tangent_stiffness;  ///< dF/du, see `axial_compliance` [N/m].
  ScrewEnd screw_end;
  PerInterface<double> largest_opening;  ///< Largest opening of an open contact, along its normal [m].
  std::vector<int> idle_rollers;         ///< Numbers, from 0, of rollers that carry no load.
  SupportForce nut;
  std::array<RingForce, 2> rings;  ///< Near and far ring.
  std::vector<GuideLoads> guides;  ///< Guides of each roller if they have a clearance; zero for missing rollers.
  std::vector<SupportForce> bearings;
};

/// du_x/dF of the loaded section [m/N] with a fixed point of action, so that the moments grow with the force: C_xx +
/// e_z C_x,theta_y - e_y C_x,theta_z, without a freedom that a bearing holds there.
double axial_compliance(const ScrewEnd& end, const Lateral& eccentricity);

struct FullStructure;
/// The outcome if motions are free; none if no motion is.
std::optional<FullDistribution> mechanism(const FullModel& model, const FullStructure& structure);

/// Equilibrium by Newton's method from the state of linear contacts with the secant stiffness of equal shares. Two
/// outcomes are not failures of the solver: `mechanism`, a motion that nothing resists, and `no_equilibrium`, a load
/// that pushing flanks cannot hold. The stiffness of the screw's end requires Detail::complete.
FullDistribution solve(const FullModel& model, Detail detail = Detail::complete);

/// Start of the iteration for one model after the other.
enum class FullStart {
  linear,     ///< Start of a first model: no result depends on previous ones.
  neighbour,  ///< Nearest of the last states: fewer iterations to the same loads, within the tolerance of Newton's
              ///< method.
  onwards     ///< Extrapolation of the last states, all under one load.
};

/// `solve` for one model after the other: models that differ in numbers only share the numbering, the pattern and its
/// symbolic factorization.
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

/// Symmetric loads computed on one sector.
SymmetricLoads symmetric_loads(const FullModel& model);
/// Symmetric loads from those of a sector whose nut is held rigidly.
SymmetricLoads symmetric_loads(const FullModel& model, const LoadDistribution& sector);

/// Effect of a turn of the carrier on the threads of each roller.
struct OrbitLoads {
  std::vector<double> first_roller;  ///< Largest N of the first roller at each position [N].
  RollerThreads equivalent;          ///< (mean N^exponent)^(1/exponent) [N]
  RollerThreads peak;                ///< Largest N of each contact [N].
  double largest_equivalent = 0.0;   ///< [N]
  double largest = 0.0;              ///< Largest N of all positions [N].
  double least = 0.0;                ///< [N]
  double carrier_angle = 0.0;        ///< Carrier angle of the largest load [rad].
  int roller = 0, thread = 0;        ///< Roller and thread of the largest load, from 1.
};

struct Orbit {
  /// First position without equilibrium; all other members are then undefined.
  struct Failure {
    double carrier_angle = 0.0;  ///< [rad]
    std::string why;             ///< Reason given by the solver.
  };
  std::optional<Failure> failure;
  bool converged() const { return !failure; }

  int steps = 0;      ///< Positions per spacing of the rollers.
  int positions = 0;  ///< Positions of the whole turn.
  double exponent = 0.0;
  std::vector<double> carrier_angle;  ///< Angle at each position [rad].
  PerInterface<OrbitLoads> loads;
  std::vector<double> axial_displacement;  ///< Displacement at the positions of a different load [m].
  double axial_error = 0.0;                ///< Peak-to-peak value [m].
};

/// Symmetry that reduces the carrier positions to solve.
struct OrbitSymmetry {
  bool alike = false;  ///< Whether all rollers are equal: one spacing is solved, the rest is a permutation.
  bool round = false;  ///< Whether nothing but the rollers depends on the azimuth: one position is solved.
};

/// Loads with the carrier at carrier_angle + 2 pi m/(steps N), m < steps N. `model` makes the mechanism at a carrier
/// angle.
Orbit orbit(const std::function<FullModel(double)>& model,
            const std::function<FullDistribution(const FullModel&)>& solver, const SpatialLoad::Orbit& wanted,
            double carrier_angle, OrbitSymmetry symmetry);

}  // namespace prs
