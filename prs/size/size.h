#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prs/loads/slip_result.h"
#include "prs/model/warning.h"
#include "prs/size/candidates.h"
#include "prs/size/requirement.h"

/// Which screw, and which motor: every candidate as a case of its own, with the loads of its
/// threads, its losses and its masses, against the criteria of a requirement (docs/size.md).
namespace prs {

enum class CriterionStatus : std::uint8_t { pass, fail, not_computed, not_applicable };
std::string_view name(CriterionStatus status);

/// A value against its limit, both in `unit`.
struct SizeCriterion {
  std::string_view name;
  std::string_view unit = {};
  std::optional<double> value = {}, limit = {};
  std::optional<double> margin = {};  ///< Above 1 it passes.
  CriterionStatus status = CriterionStatus::pass;
  std::string reason = {};

  bool holds() const {
    return status == CriterionStatus::pass || status == CriterionStatus::not_applicable;
  }
};

/// A segment of the motion on one candidate. SI units.
struct SizedSegment {
  std::string_view name;  ///< Held by the cycle of the result.
  std::optional<double> efficiency;
  std::optional<DrivenBy> driven_by;
  std::optional<double> power_loss;  ///< [W]
  std::optional<double> torque;      ///< At the part that turns, in the sense of the motion [N m].
  std::optional<double> motor_torque;  ///< [N m]
};

/// A life in its three measures. SI units.
struct SizedLife {
  std::optional<double> revolutions;
  std::optional<double> hours;   ///< Clock time, rests included [h].
  std::optional<double> travel;  ///< [m]
};

/// A screw against the requirement. SI units; what it does not define is absent.
struct SizedCandidate {
  int rank = 0;  ///< From 1, over all.
  std::string name;
  bool is_row = false;
  std::size_t number = 0, order = 0;  ///< In its source; among all.
  Mechanism::Type type = Mechanism::Type::standard;
  double screw_diameter = 0.0, lead = 0.0;
  int starts = 0;
  double nut_diameter = 0.0, nut_length = 0.0;
  bool passes = false, pareto = false;
  std::string_view limited_by;  ///< Empty where no criterion has a margin.
  std::vector<std::string> warnings;

  std::optional<double> weight, shaft_length;
  Requirement::Basis life_basis = Requirement::Basis::threads;
  SizedLife life, thread_life;
  std::optional<double> static_safety, thread_static_safety, thread_capacity;
  std::optional<double> dynamic_capacity, static_capacity;  ///< Of the row.
  std::optional<double> buckling_load, buckling_safety, critical_speed, largest_speed;
  std::optional<double> speed_times_diameter, stiffness, efficiency, back_driving_efficiency;
  std::optional<bool> self_locking;
  std::optional<PerPart<double>> temperature;  ///< [K]
  std::optional<Heat::Conductance> conductance;
  std::optional<double> power_lost, inertia;
  std::optional<double> motor_rms_torque, motor_peak_torque, motor_largest_speed, motor_peak_power;
  std::optional<double> inertia_ratio, regenerated_mean, regenerated_peak, holding_torque;
  bool brake_needed = false;
  std::optional<double> relubrication;  ///< [s]

  std::vector<SizedSegment> segments;
  std::vector<SizeCriterion> criteria;

  /// Criteria that do not hold, and the least margin among them; none counts as 0.
  std::size_t missed() const;
  double least_missed_margin() const;
};

/// A row or a combination that `prs new` refuses.
struct InvalidCandidate {
  std::string name;
  bool is_row = false;
  std::size_t number = 0;
  std::string reason;
};

/// What a limit would have to be so that a candidate passes.
struct Relaxation {
  std::string_view criterion;
  int rank = 0;
  double limit = 0.0, needed = 0.0, margin = 0.0;
};

/// Forces that a candidate carries on and on at a speed, the screw driving [N]; series without an
/// entry are empty.
struct SizeCurve {
  int rank = 0;
  std::vector<double> speed, efficiency;  ///< [m/s]; of the screw.
  std::vector<double> by_static, by_buckling, by_life, by_temperature, by_motor_rated;
  std::vector<double> by_motor_peak, envelope;
};

struct SizeResult {
  SizeInput input;
  std::vector<SizedCandidate> candidates;  ///< By rank.
  std::vector<InvalidCandidate> invalid;
  std::vector<CandidateData> data;  ///< In the order of the sources.
  std::optional<Relaxation> relax;  ///< Where nothing passes.
  std::optional<SizeCurve> curve;
  std::vector<Warning> warnings;

  std::size_t passing() const;
};

/// Calls `prepare(k)` for k = 0 .. count-1, on threads or not, and what it returns in order.
using ForEach = std::function<void(
    std::size_t count, const std::function<std::function<void()>(std::size_t k)>& prepare)>;

struct SizeOptions {
  std::size_t curve_of = 1;  ///< Rank.
  ForEach for_each = [](std::size_t count, const auto& prepare) {
    for (std::size_t k = 0; k < count; ++k) prepare(k)();
  };
  std::function<void(std::size_t done, std::size_t all)> progress = {};
};

/// All candidates, the best first. Throws InputError where none can be made.
SizeResult size_screws(const SizeInput& in, const SizeOptions& options = {});

/// A candidate as a complete, commented case, on which `life`, `slip`, `solve` and `measures` give
/// the numbers of the list.
std::string written_candidate(const SizeResult& result, std::size_t rank);

}  // namespace prs
