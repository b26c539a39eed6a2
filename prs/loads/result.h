#pragma once

#include "fe/newton.h"
#include "prs/heat/result/heat_result.h"
#include "prs/sector/ring_guide.h"
#include "prs/slip/result/running_loads.h"
#include "prs/slip/result/slip_result.h"
#include "prs/threads/contacts.h"

namespace prs {

/// Distribution of the load of an interface over the rollers of a full mechanism.
struct RollerShares {
  std::vector<double> share;         ///< Share of the axial load, one per roller; missing ones 0.
  double largest_normal_load = 0.0;  ///< [N]
  int largest_roller = 0;            ///< Roller with the largest load, from 1.
  int largest_thread = 0;
  double overload_factor = 0.0;  ///< Largest load over that of the same screw under symmetric load.
  int unloaded_threads = 0;      ///< Number of unloaded threads of the present rollers.
  int missing = 0;               ///< Number of missing rollers.
};

struct FullLoads;

/// Share of a thread if there is no load.
inline constexpr double kNoShare = std::numeric_limits<double>::quiet_NaN();

/// Per-thread results of one interface of one roller, starting with thread 1 next to the loaded end of the screw. For a
/// full mechanism roller after roller. SI units.
struct InterfaceLoads {
  int threads_per_roller = 0;  ///< Threads per roller of a full mechanism; 0: one roller represents all.
  std::optional<RollerShares> rollers;
  std::optional<double> hertz_constant;  ///< Constant used in the solve [N/m^1.5].
  double normal_angle = 0.0;             ///< Angle used in the solve [rad].
  std::vector<double> axial_load;        ///< Sum of normal load and friction along the axis [N].
  std::vector<double> normal_load;       ///< Normal load; at rest axial / cos psi [N].
  std::vector<double> load_rate;         ///< l_v = axial load / (force/rollers), Abevi (3) [-]
  std::vector<double> approach;          ///< delta [m]
  std::vector<double> semi_major;        ///< Semi-axes; empty if the geometry gives no contact.
  std::vector<double> semi_minor;
  std::vector<double> peak_pressure;         ///< [Pa]
  std::vector<double> max_shear_stress;      ///< Largest value below the surface [Pa].
  std::vector<double> max_shear_depth;       ///< Depth of this value, for the case depth [m].
  std::vector<double> max_von_mises_stress;  ///< Largest value below the surface [Pa].
  std::vector<double> max_von_mises_depth;   ///< Depth of this value [m].
  // Friction of a running screw.
  std::optional<FrictionForces> friction;
  std::optional<double> running_over_static;  ///< Largest normal load over that at rest.
};

/// Threads of one flank of a roller.
struct FlankThreads {
  std::vector<double> normal_load;  ///< [N]
  std::vector<double> axial_load;   ///< Sum of normal load and friction along the axis [N].
  std::vector<double> power;        ///< Friction power, with slip [W].
};

/// The flank that the load does not name, under preload: of the same threads or of the other nut.
struct OtherFlank {
  PerInterface<FlankThreads> threads;
  /// R_near and R_far at rest, > 0 outwards [N]: of the roller under both flanks, or of one roller of each nut, first
  /// that of the named flank.
  std::vector<std::array<double, 2>> guide_force;
  double rollers = 1.0;
  bool of_second_roller = false;  ///< Whether it belongs to a double nut, whose nuts have rollers of their own.
};

/// Result of one load case. With `share: equal` nothing is solved: status, displacement and stiffness are absent.
struct LoadCaseResult {
  // Defined in the .cpp file, like those of Conditions.
  LoadCaseResult();
  LoadCaseResult(const LoadCaseResult&);
  LoadCaseResult(LoadCaseResult&&) noexcept;
  LoadCaseResult& operator=(const LoadCaseResult&);
  LoadCaseResult& operator=(LoadCaseResult&&) noexcept;
  ~LoadCaseResult();

  LoadCase load_case;
  ModelOptions::Loads loads = ModelOptions::Loads::at_rest;
  std::optional<fe::NewtonSummary> solve;
  std::optional<double> axial_displacement;             ///< Displacement [m], > 0 in the direction of the load.
  std::optional<double> axial_stiffness;                ///< Secant, force / displacement [N/m].
  std::optional<double> tangent_stiffness;              ///< dF/du at the load [N/m].
  std::optional<PerInterface<InterfaceLoads>> threads;  ///< Thread loads; absent if not converged.
  std::vector<GuideLoads> guides;                       ///< Guides of each roller solved, if they have a clearance.
  std::optional<OtherFlank> other_flank;                ///< Present with preload.
  std::shared_ptr<const FullLoads> full;                ///< Loads of the full mechanism, see full_result.h.
  std::optional<RunningLoads> running;                  ///< Present if the loads are those of the running screw.
  std::optional<SlipResult> slip;                       ///< Present if requested and the loads are known.
  std::optional<HeatResult> heat;                       ///< Present with `heat`: the slip is at these temperatures.
  std::vector<Warning> warnings;

  bool converged() const { return (!solve || solve->converged()) && (!running || running->converged()); }
};

/// All results that `analyze` computes from a case.
struct Result {
  Result();
  Result(const Result&);
  Result(Result&&) noexcept;
  Result& operator=(const Result&);
  Result& operator=(Result&&) noexcept;
  ~Result();

  Contacts contacts;
  ModelOptions model;
  std::vector<LoadCaseResult> load_cases;
  std::optional<HeatCycle> heat_cycle;  ///< Present if the case has a duty.
  std::vector<Warning> warnings;
};

/// Library, version and kind of the sparse factorization for a load case: `CHOLMOD 3.0.14, simplicial LDL'`. Absent if
/// none was made.
std::optional<std::string> factorization(const LoadCaseResult& result);

}  // namespace prs
