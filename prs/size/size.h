#pragma once

#include "prs/configurations/configurations.h"
#include "prs/record/record.h"
#include "prs/size/requirement.h"
#include "prs/slip/result/slip_result.h"

/// Which screw, and which motor: every candidate as a case of its own, with the loads of its
/// threads, its losses and its masses, against the criteria of a requirement (docs/size.md).
namespace prs {

/// A screw to choose from: a row of a catalogue or a design. SI units.
struct CandidateData {
  std::string name;
  std::string list;        ///< List that it comes from: of a maker, a file, or the rules of `prs new`.
  bool is_row = false;     ///< Whether it is a row of a catalogue.
  std::size_t number = 0;  ///< Number of the row or the design, from 1.
  ScrewData screw;
  std::optional<double> dynamic_capacity, static_capacity;  ///< C_a, C_0 of the row [N].
  std::optional<double> row_efficiency, row_back_driving_efficiency;

  /// Dimensions that neither row nor design states, so that they follow the rules of `prs new`.
  std::vector<std::string> assumed() const;
};

/// Rows of the standard screws in validation/standard_screws, which are part of the program.
std::string_view standard_screws();

/// Rows of the catalogue, then designs, numbered with starts fastest, then lead, diameter, type, each with a name of
/// its own. Unknown columns are warned of. Throws InputError.
std::vector<CandidateData> candidates_of(const SizeInput& in, std::vector<Warning>& warnings);

/// Temperatures to the digits that a written case has [K].
PerPart<double> as_written(const PerPart<double>& temperature);

/// A segment of the motion as the motor has it.
MotorDuty::Step motor_step(const MotionSegment& s);

/// A candidate as a case: a load case for each moving segment under force, then `back-driving`.
struct SizedCase {
  CompleteScrew screw;
  Case c;
  double shaft_length = 0.0;
  /// Load case of each segment that is shown.
  std::vector<std::optional<std::size_t>> load_case_of;

  std::size_t back_driving() const { return c.load_cases.size() - 1; }
};

/// The nut of an inverted screw without a length of its own is made as long as the rollers' threads
/// travel. Throws CaseError where `prs new` refuses the screw, or a nut is too short for the
/// stroke.
SizedCase sized_case(const SizeInput& in, const CandidateData& candidate);

enum class CriterionStatus : std::uint8_t { pass, fail, not_computed, not_applicable };
std::string_view name(CriterionStatus status);

/// A value against its limit, both in `unit`.
struct SizeCriterion {
  std::string_view name, unit = {};
  std::optional<double> value = {}, limit = {};
  std::optional<double> margin = {};  ///< Above 1 it passes.
  CriterionStatus status = CriterionStatus::pass;
  std::string reason = {};

  bool holds() const { return status == CriterionStatus::pass || status == CriterionStatus::not_applicable; }
};

/// A segment of the motion on one candidate. SI units.
struct SizedSegment {
  std::string_view name;  ///< Held by the cycle of the result.
  std::optional<double> efficiency;
  std::optional<DrivenBy> driven_by;
  std::optional<double> power_loss;    ///< [W]
  std::optional<double> torque;        ///< At the part that turns, in the sense of motion [N m].
  std::optional<double> motor_torque;  ///< [N m]
};

/// A life in its three measures. SI units.
struct SizedLife {
  std::optional<double> revolutions;
  std::optional<double> hours;   ///< Clock time, rests included [h].
  std::optional<double> travel;  ///< [m]
};

/// A screw against the requirement. SI units; what it does not define is absent.
struct SizedCandidate : CandidateData {
  int rank = 0;           ///< From 1, over all.
  std::size_t order = 0;  ///< Among all, in the order of the sources.
  int starts = 0;
  double nut_diameter = 0.0, nut_length = 0.0;
  bool passes = false, pareto = false;
  std::string_view limited_by;  ///< Empty where no criterion has a margin.
  std::vector<Warning> warnings;

  std::optional<double> weight, shaft_length;
  Requirement::Basis life_basis = Requirement::Basis::threads;
  /// C_a and C_0 in the formulas of catalogues, printed or else computed [N]; none by threads.
  std::optional<double> rated_dynamic_capacity, rated_static_capacity;
  SizedLife life;
  std::optional<double> static_safety;
  struct ByThreads {
    SizedLife life;
    std::optional<double> static_safety, capacity;
  };
  ByThreads by_threads;
  std::optional<double> buckling_load, buckling_safety, critical_speed, largest_speed;
  std::optional<double> speed_times_diameter, stiffness, efficiency, back_driving_efficiency;
  std::optional<bool> self_locking;
  std::optional<PerPart<double>> temperature;  ///< [K]
  /// Temperatures of the parts under which threads were loaded [K]; none: the reference temperature.
  std::optional<PerPart<double>> parts_at;
  Heat::Conductance conductance;  ///< As given, else by the rule of `prs new`.
  std::optional<double> power_lost, inertia;
  std::optional<double> motor_rms_torque, motor_peak_torque, motor_largest_speed, motor_peak_power;
  std::optional<double> inertia_ratio, regenerated_mean, regenerated_peak, holding_torque;
  bool brake_needed = false;
  std::optional<double> relubrication;  ///< [s]

  std::vector<SizedSegment> segments;
  std::vector<SizeCriterion> criteria;

  /// Criteria that do not hold, and the least margin among them; none counts as 0.
  std::vector<std::string> missed() const;
  /// maker | computed | threads: where the capacities of its life come from.
  std::string_view basis() const;
  double least_missed_margin() const;
  std::optional<double> hottest_part() const;  ///< [K]
};

/// A row or a combination that `prs new` refuses.
struct InvalidCandidate : CandidateData {
  std::string reason;
};

/// What a limit would have to be so that a candidate passes.
struct Relaxation {
  std::string_view criterion;
  int rank = 0;
  double limit = 0.0, needed = 0.0, margin = 0.0;
};

/// Forces that a candidate carries on and on at a speed, the screw driving [N].
struct SizeCurve {
  int rank = 0;
  std::vector<double> speed, efficiency;  ///< [m/s]; of the screw.
  /// Forces by what limits them running on and on; those of the mean load with the rests and changes of the cycle as
  /// `.._in_cycle`; `envelope` and `envelope_in_cycle`, the least of them.
  ByKey<std::vector<double>> force;
  struct Required {
    std::string segment;
    double speed = 0.0, force = 0.0;    ///< Largest speed [m/s], axial force [N].
    std::optional<DrivenBy> driven_by;  ///< None at rest.
  };
  std::vector<Required> required;  ///< Segments under force.
};

/// A candidate against the requirement, unranked. Throws CaseError where `prs new` refuses it.
SizedCandidate evaluated(const SizeInput& in, const CandidateData& data);

/// Forces over speed of an evaluated candidate; none without mean load.
std::optional<SizeCurve> force_over_speed(const SizeInput& in, const SizedCandidate& candidate);

struct SizeResult {
  SizeInput input;
  std::vector<SizedCandidate> candidates;  ///< By rank.
  std::vector<InvalidCandidate> invalid;
  std::optional<Relaxation> relax;  ///< Present if nothing passes.
  std::optional<SizeCurve> curve;
  std::vector<Warning> warnings;

  std::size_t passing() const;
};

struct SizeOptions {
  std::size_t curve_of = 1;  ///< Rank.
  std::size_t threads = 0;   ///< 0: one per processor.
  std::function<void(std::size_t done, std::size_t all)> progress = {};
};

/// All candidates, the best first. Throws InputError where none can be made.
SizeResult size_screws(const SizeInput& in, const SizeOptions& options = {});

/// A candidate as a complete, commented case, on which `life`, `slip`, `solve` and `measures` give
/// the numbers of the list.
std::string written_candidate(const SizeInput& in, const SizedCandidate& candidate);

}  // namespace prs
