#pragma once

#include "prs/configurations/configurations.h"
#include "prs/heat/result/heat_result.h"
#include "prs/losses/motor_demand.h"
#include "prs/record/record.h"
#include "prs/size/requirement.h"
#include "prs/slip/result/slip_result.h"

/// Choice of a screw and a motor: every candidate is a case, whose thread loads, losses and masses are compared with
/// the criteria of a requirement (docs/size.md).
namespace prs {

/// A candidate screw: a row of a catalogue or a design. SI units.
struct CandidateData {
  std::string name;
  std::string list;        ///< Source list: of a maker, a file, or the rules of `prs new`.
  bool is_row = false;     ///< Whether it is a row of a catalogue.
  std::size_t number = 0;  ///< Number of the row or the design, from 1.
  ScrewData screw;
  std::optional<double> dynamic_capacity, static_capacity;  ///< C_a, C_0 of the row [N].
  std::optional<double> row_efficiency, row_back_driving_efficiency;
  std::optional<double> row_drag_torque, axial_play, grease_volume;  ///< Printed values [N m], [m], [m^3].

  /// Dimensions that neither row nor design states and that follow the rules of `prs new`.
  std::vector<std::string> assumed() const;
};

/// Rows of the standard screws in validation/standard_screws, which are part of the program.
std::string_view standard_screws();

/// Rows of the catalogue, then designs, numbered with starts fastest, then lead, diameter, type, each with a unique
/// name. Warns of unknown columns. Throws InputError.
std::vector<CandidateData> candidates_of(const SizeInput& in, std::vector<Warning>& warnings);

/// Temperatures rounded to the digits of a written case [K].
PerPart<double> as_written(const PerPart<double>& temperature);

/// A segment of the motion as a step of the motor's duty.
MotorDuty::Step motor_step(const MotionSegment& s);

/// A candidate as a case: a load case for each moving segment under force, then `back-driving`.
struct SizedCase {
  CompleteScrew screw;
  Case c;
  double shaft_length = 0.0;
  double drag_torque = 0.0;  ///< Torque against the motion of the requirement and the row [N m].
  /// Load case of each shown segment.
  std::vector<std::optional<std::size_t>> load_case_of;

  std::size_t back_driving() const { return c.load_cases.size() - 1; }
};

/// The block `heat` with the cycle as its duty: for a class the time in which its mean force does the work of its
/// samples.
Heat heat_of_cycle(const SizeInput& in, const SizedCase& sized, const Heat::Conductance& conductance);

/// Case of a candidate. The nut of an inverted screw without a stated length is as long as the rollers' threads travel.
/// Throws CaseError if `prs new` refuses the screw, or a nut is too short for the stroke.
SizedCase sized_case(const SizeInput& in, const CandidateData& candidate);

enum class CriterionStatus : std::uint8_t { pass, fail, not_computed, not_applicable };
std::string_view name(CriterionStatus status);

/// A value and its limit, both in `unit`.
struct SizeCriterion {
  std::string_view name, unit = {};
  std::optional<double> value = {}, limit = {};
  std::optional<double> margin = {};  ///< Margin, above 1 if it passes.
  CriterionStatus status = CriterionStatus::pass;
  std::string reason = {};

  bool holds() const { return status == CriterionStatus::pass || status == CriterionStatus::not_applicable; }
};

/// A segment of the motion for one candidate. SI units.
struct SizedSegment {
  std::string_view name;  ///< Name, held by the cycle of the result.
  std::optional<double> efficiency;
  std::optional<DrivenBy> driven_by;
  std::optional<double> power_loss;    ///< [W]
  std::optional<double> torque;        ///< Torque at the turning part, in the sense of motion [N m].
  std::optional<double> motor_torque;  ///< [N m]
};

/// A life in three measures. SI units.
struct SizedLife {
  std::optional<double> revolutions;
  std::optional<double> hours;   ///< Clock time, rests included [h].
  std::optional<double> travel;  ///< [m]
};

/// A candidate compared with the requirement. SI units; undefined values are absent.
struct SizedCandidate : CandidateData {
  int rank = 0;           ///< Rank over all, from 1.
  std::size_t order = 0;  ///< Index among all, in the order of the sources.
  int starts = 0;
  double nut_diameter = 0.0, nut_length = 0.0;
  bool passes = false, pareto = false;
  std::string_view limited_by;  ///< Empty if no criterion has a margin.
  std::vector<Warning> warnings;

  std::optional<double> weight, shaft_length;
  Requirement::Basis life_basis = Requirement::Basis::threads;
  /// C_a and C_0 in the formulas of catalogues, printed or else computed [N]; none for basis `threads`.
  std::optional<double> rated_dynamic_capacity, rated_static_capacity;
  SizedLife life;
  std::optional<double> static_safety;
  struct ByThreads {
    SizedLife life;
    std::optional<double> static_safety, capacity;
  };
  ByThreads by_threads;
  /// Bearing of the turning part; life of it and the screw together.
  SizedLife bearing_life, life_with_bearings;
  std::optional<double> bearing_load, bearing_static_safety;
  std::optional<double> buckling_load, buckling_safety, critical_speed, largest_speed;
  std::optional<double> speed_times_diameter, stiffness, efficiency, back_driving_efficiency;
  std::optional<bool> self_locking;
  std::optional<PerPart<double>> temperature;  ///< Mean of the cycle or the mission [K].
  /// Mission of the requirement; the course of temperatures is kept for the candidate with a curve alone.
  std::optional<HeatCycle> mission;
  bool is_steady = true;  ///< False: the losses leave no steady temperatures, and nothing that depends on them.
  /// Temperatures of the parts for the thread loads [K]; none: the reference temperature.
  std::optional<PerPart<double>> parts_at;
  Heat::Conductance conductance;  ///< Given conductances, else by the rule of `prs new`.
  std::optional<double> power_lost, inertia;
  std::optional<double> motor_rms_torque, motor_peak_torque, motor_largest_speed, motor_peak_power;
  std::optional<double> inertia_ratio, regenerated_mean, regenerated_peak, holding_torque;
  std::optional<ElectricDemand> electric;
  std::optional<double> reflected_mass;      ///< Mass of what turns, at the nut [kg].
  std::optional<double> back_driving_force;  ///< Force at which a load begins to drive a motor without current [N].
  std::optional<double> preload_force;       ///< [N]
  std::optional<double> no_load_torque;      ///< Torque of the preload without load, at the mean speed [N m].
  bool brake_needed = false;
  std::optional<double> relubrication;  ///< [s]

  std::vector<SizedSegment> segments;
  std::vector<SizeCriterion> criteria;

  /// Failed criteria, and the smallest margin among them; a missing one counts as 0.
  std::vector<std::string> missed() const;
  /// Origin of the capacities of its life: maker | computed | threads.
  std::string_view basis() const;
  double least_missed_margin() const;
  std::optional<double> hottest_part() const;  ///< Peak of a mission, else the largest mean [K].
};

/// A row or a combination that `prs new` refuses.
struct InvalidCandidate : CandidateData {
  std::string reason;
};

/// Limit that would have to change for a candidate to pass, and its required value.
struct Relaxation {
  std::string_view criterion, unit = {};
  int rank = 0;
  double limit = 0.0, needed = 0.0, margin = 0.0;
};

/// Forces that a candidate carries continuously at a speed, with the screw driving [N].
struct SizeCurve {
  int rank = 0;
  std::vector<double> speed, efficiency;  ///< Speed [m/s]; efficiency of the screw.
  /// Continuous forces by their limits; those of the mean load with the pauses and changes of the cycle as
  /// `.._in_cycle`; `envelope` and `envelope_in_cycle`, the smallest of them.
  ByKey<std::vector<double>> force;
  struct Required {
    std::string segment;
    double speed = 0.0, force = 0.0;    ///< Largest speed [m/s], axial force [N].
    std::optional<DrivenBy> driven_by;  ///< None at rest.
  };
  std::vector<Required> required;  ///< Segments under force.
};

struct SizeResult {
  SizeInput input;
  std::vector<SizedCandidate> candidates;  ///< Candidates by rank.
  std::vector<InvalidCandidate> invalid;
  std::optional<Relaxation> relax;  ///< Present if no candidate passes.
  std::optional<SizeCurve> curve;
  std::vector<Warning> warnings;

  std::size_t passing() const;
};

struct SizeOptions {
  std::size_t curve_of = 1;  ///< Rank of the candidate with a curve.
  std::size_t threads = 0;   ///< Number of threads; 0: one per processor.
  std::function<void(std::size_t done, std::size_t all)> progress = {};
};

/// All candidates, the best first. Throws InputError if none can be made.
SizeResult size_screws(const SizeInput& in, const SizeOptions& options = {});

/// A candidate as a complete, commented case, for which `life`, `slip`, `solve` and `measures` give the numbers of the
/// list.
std::string written_candidate(const SizeInput& in, const SizedCandidate& candidate);

}  // namespace prs
