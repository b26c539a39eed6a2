#include "prs/size/evaluation.h"

#include "prs/heat/duty_cycle.h"
#include "prs/indices.h"
#include "prs/life/analyze_life.h"
#include "prs/losses/motor_demand.h"
#include "prs/measures/measures.h"
#include "prs/preload/preloaded_mechanism.h"
#include "prs/slip/slip.h"

namespace prs {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kPasses = 1.0 - 1e-9;  ///< Smallest passing margin, up to rounding.
constexpr double kInchPerSecond = 0.0254;
constexpr double kHour = 3600.0, kKelvin = 273.15;
constexpr double kOilsMean = 20.0;      ///< Smallest difference of the oil's temperature that is noted [K].
constexpr double kGreaseEnds = 393.15;  ///< Temperature beyond which grease and seals do not last [K].
constexpr double kLongCycle = 600.0;    ///< Shortest cycle whose mean may hide a peak of temperature [s].
constexpr double kRegularLoad = 0.9;    ///< Share of C_a beyond which makers allow loads only occasionally.
constexpr double kMostPreload = 0.5;    ///< Share of C_a beyond which a preload is reported.
constexpr double kShortStroke = 1.5;    ///< Short stroke, as a share of the nut's length.
constexpr std::size_t kCurvePoints = 40;

/// Losses of one load case.
struct Branch : SizedSegment {
  std::optional<OfParts> heat;  ///< Heat of the parts [W]; not for a catalogue's efficiencies.
};

Branch branch_by_slip(const LoadCaseResult& r, double lead) {
  const SlipResult& slip = *r.slip;
  Branch b;
  b.driven_by = slip.driven_by;
  if (r.load_case.axial_force > 0.0) b.efficiency = slip.efficiency;
  b.power_loss = slip.power.total();
  b.heat = heat_of(slip.power);
  b.torque = screw_torque(r, lead);
  return b;
}

Branch branch_by_catalogue(const CandidateData& row, const LoadCase& load, DrivenBy driven_by, double lead) {
  const double input = load.axial_force * std::abs(*load.speed) * lead / kTurn;
  const bool drives = driven_by == DrivenBy::screw;
  Branch b;
  b.driven_by = driven_by;
  b.efficiency = drives ? row.row_efficiency : row.row_back_driving_efficiency;
  if (!b.efficiency) return b;
  b.power_loss = input * (drives ? 1.0 / *b.efficiency - 1.0 : 1.0 - *b.efficiency);
  b.torque = screw_torque(load.axial_force, lead, driven_by, *b.efficiency);
  return b;
}

bool slips(const LoadCaseResult& r) { return r.converged() && r.slip && r.slip->converged(); }

Heat::Conductance conductance_of(const SizeInput& in, const SizedCase& sized) {
  CompleteScrew screw = sized.screw;
  screw.load = in.cycle.driving_force();
  const Heat::Conductance rule = estimated_conductance(screw, sized.shaft_length);
  const Requirement::Conductance given = in.values.heat ? in.values.heat->conductance : Requirement::Conductance{};
  return {given.screw_ambient.value_or(rule.screw_ambient), given.nut_ambient.value_or(rule.nut_ambient),
          given.rollers_ambient.value_or(rule.rollers_ambient), given.screw_rollers.value_or(rule.screw_rollers),
          given.rollers_nut.value_or(rule.rollers_nut)};
}

ThermalNetwork network_of(const Requirement& r, const SizedCandidate& c) {
  return thermal_network({.ambient = r.heat->ambient, .conductance = c.conductance});
}

/// Evaluation of one candidate in steps, each with the results of those before it.
class Evaluation {
 public:
  Evaluation(const SizeInput& in, const CandidateData& data)
      : in_(in), r_(in.values), cycle_(in.cycle), sized_(sized_case(in, data)) {
    static_cast<CandidateData&>(c_) = data;
    c_.life_basis = *r_.life.basis;
    contacts_ = checked_contacts(sized_.c, Detail::numbers);
    lead_ = std::abs(contacts_.threads.screw.lead);
  }

  SizedCandidate take() {
    const CompleteScrew& s = sized_.screw;
    c_.starts = s.c.mechanism.starts.screw;
    c_.nut_diameter = s.c.structure->nut.outer_diameter;
    c_.nut_length = s.c.structure->nut.length;
    c_.conductance = conductance_of(in_, sized_);
    find_measures();
    if (r_.has_mission()) run_mission();
    find_losses();
    if ((!by_maker() || sized_.c.preload) && !r_.has_mission()) warm_parts();
    find_no_load_torque();
    find_lives();
    if (c_.is_steady) find_stiffness();
    find_torques();
    find_relubrication();
    judge();
    warn();
    return std::move(c_);
  }

 private:
  void find_measures() {
    measures_ = measures_of(sized_.c, contacts_);
    c_.shaft_length = sized_.shaft_length;
    if (measures_.weight && measures_.screw_weight_per_length)
      c_.weight = *measures_.weight + *measures_.screw_weight_per_length * sized_.shaft_length;
    c_.inertia = measures_.equivalent_inertia;
    c_.buckling_load = measures_.buckling_load;
    if (c_.buckling_load && cycle_.largest_compression > 0.0)
      c_.buckling_safety = *c_.buckling_load / cycle_.largest_compression;
    if (!cycle_.moves()) return;
    c_.critical_speed = measures_.critical_speed;
    c_.largest_speed = kTurn * cycle_.largest_speed / lead_;
    c_.speed_times_diameter = cycle_.largest_speed / lead_ * c_.screw.screw_diameter;
  }

  SizedLife life_of(double revolutions) const {
    return {revolutions, revolutions * lead_ / cycle_.travel * cycle_.duration / kHour, revolutions * lead_};
  }

  void find_lives() {
    const LifeResult life = analyze_life(sized_.c, contacts_, {}, oils_);
    c_.by_threads.capacity = life.dynamic_capacity;
    rating_ = life.rated_over_l10();
    if (life.converged() && c_.is_steady && has_temperatures()) {
      c_.by_threads.static_safety = life.static_safety();
      // Under preload travel without load is in the spectrum too.
      const double of_spectrum = r_.preload ? cycle_.travel : cycle_.loaded_travel;
      if (cycle_.mean_load) c_.by_threads.life = life_of(life.system_life * rating_ * cycle_.travel / of_spectrum);
    }
    c_.life = c_.by_threads.life;
    c_.static_safety = c_.by_threads.static_safety;
    if (by_maker()) take_makers_life(life);
    find_bearing(life);
  }

  void take_makers_life(const LifeResult& life) {
    c_.rated_dynamic_capacity = c_.dynamic_capacity.value_or(life.dynamic_capacity);
    c_.rated_static_capacity = c_.static_capacity ? c_.static_capacity : life.equal_shares_static_capacity;
    if (c_.rated_static_capacity) c_.static_safety = *c_.rated_static_capacity / cycle_.largest_force;
    if (cycle_.mean_load && has_temperatures())
      c_.life = life_of(rating_ * rating_life(*c_.rated_dynamic_capacity, *cycle_.mean_load));
  }

  /// False where a mission has no temperatures, and no life.
  bool has_temperatures() const { return !c_.mission || c_.mission->converged(); }

  void find_bearing(const LifeResult& life) {
    if (!life.bearing) return;
    c_.bearing_static_safety = life.bearing->static_safety;
    if (!cycle_.mean_load) return;
    c_.bearing_load = life.bearing->equivalent_load;
    if (!life.bearing->life) return;
    c_.bearing_life = life_of(life.reliability_factor * *life.bearing->life);
    if (!c_.life.revolutions) return;
    const double lives[] = {*c_.life.revolutions / rating_, *life.bearing->life};
    c_.life_with_bearings = life_of(combined_life(lives));
  }

  /// Runs the mission; loads, losses and lives are then those of its mean temperatures. Without one, at ambient.
  void run_mission() {
    sized_.c.heat = heat_of_cycle(in_, sized_, c_.conductance);
    c_.mission = duty_cycle(sized_.c, contacts_, mission_warnings_, nullptr, nullptr, r_.limits.temperature);
    const double ambient = r_.heat->ambient;
    const PerPart<double> of_ambient{ambient, ambient, ambient};
    if (c_.mission->converged() && r_.friction->facts().has_film()) {
      take_temperatures(c_.mission->start.value_or(of_ambient));
      find_branches();
      at_start_ = demand();
    }
    take_temperatures(c_.mission->converged() ? c_.mission->mean : of_ambient);
  }

  void take_temperatures(const PerPart<double>& parts) {
    c_.parts_at = sized_.c.deviations.temperature = parts;
    oils_ = warm_oils(sized_.c, oil_temperatures(of_parts(parts)));
  }

  void find_branches() {
    branches_.clear();
    c_.segments.clear();
    c_.warnings.clear();
    const Result result = analyze_slip(sized_.c, contacts_, kManyDesigns, oils_);
    const LoadCaseResult& back = result.load_cases[sized_.back_driving()];
    if (slips(back)) c_.self_locking = back.slip->self_locking.value_or(false);
    bool by_row = false;
    const auto branch = [&](const LoadCaseResult& found, DrivenBy driven_by) {
      if (r_.losses == Requirement::Losses::slip && slips(found)) return branch_by_slip(found, lead_);
      by_row = true;
      return branch_by_catalogue(c_, found.load_case, driven_by, lead_);
    };
    for (std::size_t k = 0; k < cycle_.shown.size(); ++k) {
      Branch& b = branches_.emplace_back();
      b.torque = 0.0;
      if (const auto& place = sized_.load_case_of[k])
        b = branch(result.load_cases[*place], cycle_.shown[k].driven_by());
      b.name = cycle_.shown[k].name;
      c_.segments.push_back(b);
    }
    c_.back_driving_efficiency = branch(back, DrivenBy::load).efficiency;
    if (by_row && r_.losses == Requirement::Losses::slip)
      c_.warnings.push_back({"losses", "slip_without_equilibrium",
                             "slip finds no equilibrium of a load case, which has the catalogue's efficiency in its "
                             "place, if it prints one"});
  }

  /// Computes the torque of the preload without load, at the mean speed.
  void find_no_load_torque() {
    if (!sized_.c.preload) return;
    c_.preload_force = sized_.c.preload->force;
    if (!c_.is_steady) return;
    Conditions idle = sized_.c;
    idle.load_cases = {sized_.c.load_cases[sized_.back_driving()]};
    idle.load_cases.front().axial_force = 0.0;
    c_.no_load_torque = screw_torque(analyze_slip(idle, contacts_, kManyDesigns).load_cases.front(), lead_);
  }

  /// Computes the stiffness under the load case with the largest force, at rest, in series with shaft and bearing.
  void find_stiffness() {
    std::size_t largest = sized_.back_driving();
    for (std::size_t k = 0; k < sized_.back_driving(); ++k)
      if (largest == sized_.back_driving() ||
          sized_.c.load_cases[k].axial_force > sized_.c.load_cases[largest].axial_force * (1.0 + 1e-9))
        largest = k;
    Conditions at_rest = sized_.c;
    at_rest.load_cases = {sized_.c.load_cases[largest]};
    const std::optional<double> nut =
        at_rest.preload ? FlankSolver(at_rest, contacts_).solve(at_rest.load_cases.front()).axial_stiffness
                        : analyze(at_rest, contacts_, kManyDesigns).load_cases.front().axial_stiffness;
    if (!nut || !measures_.shaft_stiffness) return;
    double compliance = 1.0 / *nut + 1.0 / *measures_.shaft_stiffness;
    if (r_.bearings && r_.bearings->fixed.stiffness) compliance += 1.0 / *r_.bearings->fixed.stiffness;
    c_.stiffness = 1.0 / compliance;
  }

  void find_losses() {
    find_branches();
    double lost = 0.0, work = 0.0, input = 0.0;
    OfParts heat = OfParts::Zero();
    bool has_losses = true, has_heat = r_.heat && r_.losses == Requirement::Losses::slip, has_eta = true;
    for (const MotionSegment& s : cycle_.all) {
      const Branch& b = branches_[s.shown_as];
      if (!b.driven_by) continue;
      // Time for which the losses of the branch do the work of this segment [s].
      const MotionSegment& of = cycle_.shown[s.shown_as];
      const double weight = s.force == 0.0 ? s.duration : s.work() / of.work() * of.duration;
      has_losses = has_losses && b.power_loss;
      has_heat = has_heat && b.heat;
      if (b.power_loss) lost += *b.power_loss * weight;
      if (b.heat) heat += *b.heat * weight;
      if (b.driven_by != DrivenBy::screw || s.force == 0.0) continue;
      drives_ = true;
      has_eta = has_eta && b.efficiency;
    }
    // Classes count with the work of their mean force, as the steps of a spectrum do.
    for (const auto k : indices(cycle_.shown)) {
      const Branch& b = branches_[k];
      const double of_class = cycle_.shown[k].work();
      if (b.driven_by != DrivenBy::screw || of_class == 0.0 || !b.efficiency) continue;
      work += of_class;
      input += of_class / *b.efficiency;
    }
    if (has_losses) c_.power_lost = lost / cycle_.duration;
    if (has_eta && drives_) c_.efficiency = work / input;
    c_.temperature.reset();
    if (c_.mission && c_.mission->converged()) {
      c_.temperature = c_.mission->mean;
      c_.power_lost = c_.mission->energy_lost / c_.mission->duration();
    } else if (has_heat && !c_.mission)
      c_.temperature = per_part(network_of(r_, c_).steady(heat / cycle_.duration));
  }

  /// Computes losses, and all that follows, with parts at the temperatures that the losses cause. Without such a state
  /// nothing is known that depends on them.
  void warm_parts() {
    constexpr double kSame = 0.01;  ///< [K]
    if (!c_.temperature) return;
    const ThermalNetwork network = network_of(r_, c_);
    const auto warmed = [&](const OfParts& parts) -> std::optional<OfParts> {
      c_.parts_at = sized_.c.deviations.temperature = per_part(parts);
      find_losses();
      if (!c_.temperature) return std::nullopt;
      return network.conductance * (of_parts(*c_.temperature).array() - network.ambient).matrix();
    };
    const auto constant = [](const PerInterface<double>&) { return std::optional(OfParts(OfParts::Ones())); };
    const HeatSource source{warmed, [] { return std::string("slip finds no equilibrium"); }, constant, constant, false};
    const SteadyHeat found = find_steady_heat(network, source, of_parts(*c_.temperature), 0.1 * kSame);
    if (found.converged()) {
      warmed(of_parts(as_written(per_part(found.temperature))));
      return;
    }
    why_not_steady_ = fmt::format("{}: {}", name(found.status), found.reason);
    c_.is_steady = false;
    c_.warnings.clear();
    c_.parts_at = sized_.c.deviations.temperature = std::nullopt;
    c_.temperature = std::nullopt;
    c_.power_lost = c_.efficiency = c_.back_driving_efficiency = std::nullopt;
    c_.self_locking = std::nullopt;
    for (Branch& b : branches_) {
      const bool moves = b.driven_by.has_value();
      Branch none;
      none.name = b.name, none.driven_by = b.driven_by;
      if (!moves) none.torque = b.torque;
      b = none;
    }
    c_.segments.assign(branches_.begin(), branches_.end());
  }

  bool locks() const { return c_.self_locking.value_or(false); }

  /// Demand on the motor with the losses of the branches; none if one has no torque.
  std::optional<MotorDemand> demand() const {
    if (!c_.inertia) return std::nullopt;
    std::vector<DrivenStep> steps;
    for (const MotionSegment& m : cycle_.all) {
      const Branch& b = branches_[m.shown_as];
      if (!b.torque && m.sense() != 0) return std::nullopt;
      const double own = m.force == 0.0 ? 1.0 : std::abs(m.force / cycle_.shown[m.shown_as].force);
      steps.push_back({motor_step(m), b.driven_by ? *b.torque * own : 0.0});
    }
    return motor_demand(steps, r_.motor, lead_, *c_.inertia, sized_.drag_torque, r_.brake_torque || locks());
  }

  void find_torques() {
    const DriveMotor& motor = r_.motor;
    const double ratio = motor.gear_ratio;
    const double per_speed = kTurn / lead_;
    c_.holding_torque = cycle_.holding_force / (per_speed * ratio);
    c_.brake_needed = cycle_.holding_force > 0.0 && !locks();
    if (cycle_.moves()) c_.motor_largest_speed = ratio * per_speed * cycle_.largest_speed;
    if (motor.inertia > 0.0 && c_.inertia)
      c_.inertia_ratio = (*c_.inertia + cycle_.moved_mass / (per_speed * per_speed)) / (ratio * ratio * motor.inertia);
    if (c_.back_driving_efficiency && !locks())
      c_.back_driving_force =
          (sized_.drag_torque + c_.no_load_torque.value_or(0.0)) * per_speed / *c_.back_driving_efficiency;
    if (!c_.inertia) return;
    c_.reflected_mass = (*c_.inertia + ratio * ratio * motor.inertia) * per_speed * per_speed;
    const std::optional<MotorDemand> found = demand();
    if (!found) return;
    for (std::size_t k = 0; !cycle_.in_classes && k < found->torque.size(); ++k)
      c_.segments[k].motor_torque = found->torque[k];
    c_.motor_rms_torque = found->rms_torque;
    c_.motor_peak_torque = found->peak_torque;
    c_.motor_peak_power = found->peak_power;
    c_.regenerated_mean = found->regenerated_mean;
    c_.regenerated_peak = found->regenerated_peak;
    c_.electric = found->electric;
  }

  void find_relubrication() {
    if (!(cycle_.rms_speed > 0.0) || !cycle_.mean_load) return;
    const auto& rule = r_.relubrication;
    const double factor =
        rule ? std::min(1.0, rule->static_load_factor * rule->peak_force / *cycle_.mean_load - 0.15) : 1.0;
    if (factor > 0.0) c_.relubrication = 4500.0 * kHour * std::pow(cycle_.rms_speed / kInchPerSecond, -1.57) * factor;
  }

  // Verdict

  struct Given {
    std::optional<double> value, limit;          ///< SI values, temperatures in degC.
    std::string_view not_applicable = {};        ///< Reason why it does not apply; empty: it does.
    std::string_view not_computed = "no value";  ///< Reason why it is missing.
    std::string reason = {};
  };

  /// Adds a criterion with a limit. A value with a lower limit has the margin value/limit, one with an upper limit has
  /// limit/value, both counted from `zero`.
  void add(std::string_view name, std::string_view unit, bool must_reach, Given g, double zero = 0.0) {
    if (!g.limit) return;
    const double factor = unit_written(unit).factor;
    SizeCriterion& c = c_.criteria.emplace_back(SizeCriterion{name, unit, {}, *g.limit * factor});
    c.reason = std::move(g.reason);
    if (!g.not_applicable.empty() || !g.value) {
      c.status = g.not_applicable.empty() ? CriterionStatus::not_computed : CriterionStatus::not_applicable;
      c.reason = g.not_applicable.empty() ? g.not_computed : g.not_applicable;
      return;
    }
    c.value = *g.value * factor;
    const double margin = must_reach ? *g.value / *g.limit : (*g.limit - zero) / (*g.value - zero);
    if (!std::isfinite(margin)) return;
    c.margin = margin;
    if (margin < kPasses) c.status = CriterionStatus::fail;
  }
  void at_least(std::string_view name, std::string_view unit, Given g) { add(name, unit, true, std::move(g)); }
  void at_most(std::string_view name, std::string_view unit, Given g) { add(name, unit, false, std::move(g)); }

  void judge() {
    const Requirement::Limits& l = r_.limits;
    const DriveMotor& m = r_.motor;
    const std::string_view rests = cycle_.moves() ? "" : "nothing moves";
    const std::string_view no_load = cycle_.mean_load ? "" : "nothing moves under force";
    const std::string_view no_loads = !has_temperatures() ? std::string_view(c_.mission->reason)
                                      : c_.is_steady      ? "thread loads do not converge"
                                                          : std::string_view(why_not_steady_);
    const bool by_row = r_.losses == Requirement::Losses::catalogue;
    const std::string_view no_efficiency = by_row         ? "the row has no efficiency"
                                           : c_.is_steady ? "slip has no equilibrium, and the row no efficiency"
                                                          : std::string_view(why_not_steady_);
    const auto in_celsius = [](const std::optional<double>& kelvin) {
      return kelvin ? std::optional(*kelvin - kKelvin) : std::nullopt;
    };
    const auto rested_on = [&](std::string_view symbol, const std::optional<double>& printed, double used) {
      return fmt::format("{} {} {:.4g} kN",
                         !by_maker() ? "threads, Lemor's"
                         : printed   ? "maker's"
                                     : "computed",
                         symbol, 1e-3 * used);
    };
    const std::string basis = rested_on("C_a", c_.dynamic_capacity, capacity());
    const std::optional<double> hours = c_.life.hours ? std::optional(*c_.life.hours * kHour) : std::nullopt;
    at_least("life", "h", {hours, r_.life.hours, no_load, no_loads, basis});
    at_least("life", "km", {c_.life.travel, r_.life.distance, no_load, no_loads, basis});
    const std::optional<double> bearing_hours =
        c_.bearing_life.hours ? std::optional(*c_.bearing_life.hours * kHour) : std::nullopt;
    if (r_.bearings && r_.bearings->fixed.dynamic_capacity) {
      at_least("bearing_life", "h", {bearing_hours, r_.life.hours, no_load});
      at_least("bearing_life", "km", {c_.bearing_life.travel, r_.life.distance, no_load});
    }
    at_least("static_safety", "",
             {c_.static_safety, l.static_safety, "", no_loads,
              c_.rated_static_capacity ? rested_on("C_0", c_.static_capacity, *c_.rated_static_capacity)
                                       : "threads: pressure or deformation"});
    if (r_.bearings && r_.bearings->fixed.static_capacity)
      at_least("bearing_static_safety", "", {c_.bearing_static_safety, l.static_safety});
    at_least("buckling", "",
             {c_.buckling_safety, l.buckling_safety,
              cycle_.largest_compression > 0.0 ? "" : "nothing compresses the screw"});
    at_most(
        "critical_speed", "",
        {c_.critical_speed && c_.largest_speed ? std::optional(*c_.largest_speed / *c_.critical_speed) : std::nullopt,
         l.critical_speed_share,
         !cycle_.moves()                              ? rests
         : carrier_part(c_.screw.type) == Part::screw ? "the nut turns, not the screw"
                                                      : ""});
    at_most("speed_times_diameter", "mm/min", {c_.speed_times_diameter, l.speed_times_diameter, rests});
    at_most("nut_diameter", "mm", {c_.nut_diameter, l.nut_diameter});
    at_most("nut_length", "mm", {c_.nut_length, l.nut_length});
    at_most("weight", "kg", {c_.weight, l.weight});
    at_least("stiffness", "N/um", {c_.stiffness, l.stiffness, "", no_loads});
    at_least("efficiency", "",
             {c_.efficiency, l.efficiency, drives_ ? "" : "the screw drives in no segment", no_efficiency});
    judge_back_driving();
    add("temperature", "degC", false,
        {in_celsius(c_.hottest_part()), in_celsius(limit_of_temperature()), "",
         c_.mission     ? std::string_view(c_.mission->reason)
         : !r_.heat     ? "state `heat`, with the conductances of nut and screw in their seats"
         : by_row       ? "a catalogue does not say where losses arise"
         : c_.is_steady ? "slip has no equilibrium at the temperatures of its losses"
                        : std::string_view(why_not_steady_)},
        r_.heat ? coolest() - kKelvin : 0.0);
    at_most("motor_speed", "rpm", {c_.motor_largest_speed, m.largest_speed, rests});
    at_most("motor_torque", "N m", {c_.motor_rms_torque, m.rated_torque, "", no_efficiency, at_mean()});
    at_most("motor_peak_torque", "N m", {c_.motor_peak_torque, m.peak_torque, "", no_efficiency, at_mean()});
    judge_current(no_efficiency);
    if (r_.brake_torque)
      at_least("brake", "",
               {*r_.brake_torque / (r_.brake_safety * *c_.holding_torque), 1.0,
                cycle_.holding_force > 0.0 ? "" : "no force at rest", "",
                fmt::format("{:.4g} N m to hold, with a safety of {:g}", *c_.holding_torque, r_.brake_safety)});
    at_least(
        "relubrication", "h",
        {c_.relubrication, l.relubrication, cycle_.moves() ? no_load : rests, "the mean load is too high for the rule",
         r_.relubrication ? "" : "without the actuator's peak force: its factor is 1"});
    decide();
  }

  std::string at_mean() const { return c_.mission ? "at the mean temperatures of the mission" : ""; }

  void judge_current(std::string_view why_not) {
    const DriveMotor& m = r_.motor;
    const ElectricDemand e = c_.electric.value_or(ElectricDemand{});
    const auto known = [&](double value) { return c_.electric ? std::optional(value) : std::nullopt; };
    at_most("motor_voltage", "V",
            {e.peak_voltage, m.supply.voltage, "", why_not,
             e.voltage_speed ? fmt::format("under the largest torque the voltage ends at {:.0f} rpm of the motor",
                                           *e.voltage_speed * "rpm"_per_si)
                             : ""});
    at_most("motor_current", "A", {known(e.peak_current), m.supply.current, "", why_not, at_mean()});
    at_most("motor_rms_current", "A", {known(e.rms_current), m.continuous_current, "", why_not, at_mean()});
  }

  /// Limit of the temperature: the stated one, or the physical one where parts pass it.
  std::optional<double> limit_of_temperature() const {
    const bool passes = c_.hottest_part() > kHottest || !c_.is_steady || (c_.mission && !c_.mission->converged());
    return r_.limits.temperature || !passes ? r_.limits.temperature : std::optional(kHottest);
  }
  /// Temperature of the surroundings, or of a cooler start [K].
  double coolest() const {
    const double ambient = r_.heat->ambient;
    const auto& start = c_.mission ? c_.mission->start : std::nullopt;
    return start ? std::min({ambient, start->screw, start->roller, start->nut}) : ambient;
  }

  void judge_back_driving() {
    using enum BackDriving;
    const BackDriving wanted = r_.limits.back_driving;
    if (wanted == allowed) return;
    const bool holds = wanted == forbidden ? locks() : !locks();
    c_.criteria.push_back({.name = "back_driving",
                           .status = holds ? CriterionStatus::pass : CriterionStatus::fail,
                           .reason = locks() ? "the screw locks itself" : "the load turns the screw"});
  }

  void decide() {
    c_.passes = c_.missed().empty();
    double least = std::numeric_limits<double>::infinity();
    for (const SizeCriterion& c : c_.criteria) {
      if (c.holds() && !c.margin) continue;
      const double margin = c.margin.value_or(0.0);
      if (margin >= least) continue;
      least = margin;
      c_.limited_by = c.name;
    }
  }

  bool by_maker() const { return c_.life_basis == Requirement::Basis::maker; }
  /// C_a of the life that is compared [N].
  double capacity() const { return c_.rated_dynamic_capacity.value_or(*c_.by_threads.capacity); }

  void warn() {
    std::vector<Warning>& all = c_.warnings;
    if (cycle_.mean_load && *cycle_.mean_load > 0.5 * capacity())
      all.push_back(Warning{"life", "mean_load",
                            "the mean load, {value}, is beyond half of C_a, {limit}: the formula of life is not made "
                            "for it",
                            "take a larger screw"}
                        .with(*cycle_.mean_load, 0.5 * capacity(), "kN"_unit));
    if (c_.preload_force > kMostPreload * capacity())
      all.push_back(Warning{"preload", "large_preload",
                            "the preload, {value}, is beyond half of C_a, {limit}; makers take 3 to 10 % of C_a",
                            "check the unit, or take a larger screw"}
                        .with(*c_.preload_force, kMostPreload * capacity(), "kN"_unit));
    if (by_maker() && r_.preload)
      all.push_back({"life.basis", "maker_without_preload", "the formulas of catalogues have the life without preload",
                     "write `basis: threads`, which has the loads of both flanks"});
    if (cycle_.largest_force > kRegularLoad * capacity())
      all.push_back(Warning{"motion", "largest_force",
                            "the largest force, {value}, is beyond 0.9 C_a, {limit}, which a maker does not allow "
                            "regularly",
                            "take a larger screw"}
                        .with(cycle_.largest_force, kRegularLoad * capacity(), "kN"_unit));
    const Mechanism& mechanism = sized_.screw.c.mechanism;
    const bool on_nut = carrier_part(c_.screw.type) == Part::nut;
    const double length = on_nut ? c_.nut_length : mechanism.contacts_per_roller * axial_pitch(mechanism);
    if (on_nut && r_.stroke && sized_.shaft_length < *r_.stroke + c_.nut_length)
      all.push_back(Warning{"measures.shaft.length", "short_shaft",
                            "the shaft, {value}, is shorter than stroke and nut together, {limit}", "lengthen it"}
                        .with(sized_.shaft_length, *r_.stroke + c_.nut_length, "mm"_unit, Warning::Worse::smaller));
    const std::optional<double> stroke = r_.motion.loads ? r_.stroke : std::optional(cycle_.loaded_way);
    if (stroke && *stroke > 0.0 && *stroke < kShortStroke * length)
      all.push_back(Warning{"stroke", "short_stroke",
                            fmt::format("the stroke under load, {{value}}, is below {{limit}}, 1.5 times the {}: life "
                                        "needs a special calculation, none is public",
                                        on_nut ? "nut's length" : "length of the rollers' threads")}
                        .with(*stroke, kShortStroke * length, "mm"_unit, Warning::Worse::smaller));
    if (c_.brake_needed && !r_.friction->facts().holds_at_rest())
      all.push_back({"friction", "film_at_rest",
                     fmt::format("at rest the film of `{}` is gone, so that the screw may still hold",
                                 r_.friction->facts().name)});
    warn_of_heat();
  }

  void warn_of_heat() {
    c_.warnings.insert(c_.warnings.end(), mission_warnings_.begin(), mission_warnings_.end());
    constexpr double kReported = 1.01;  // Ratio of torques above which a start is reported.
    if (at_start_ && c_.motor_peak_torque && at_start_->peak_torque > kReported * *c_.motor_peak_torque)
      c_.warnings.push_back(
          Warning{"motor", "start_of_mission",
                  "at the temperatures of the mission's start the motor's largest torque is {value}; the criteria take "
                  "those at its mean temperatures, {limit}",
                  "leave room for the start"}
              .with(at_start_->peak_torque, *c_.motor_peak_torque, "N m"_unit));
    if (!c_.temperature) return;
    std::vector<Warning>& all = c_.warnings;
    const Requirement::Conductance& k = r_.heat->conductance;
    if (r_.limits.temperature && !(k.screw_ambient && k.nut_ambient && k.screw_rollers && k.rollers_nut))
      all.push_back({"heat", "conductances_by_rule",
                     "conductances by rule decide on temperatures: bare parts in still air, a bolted housing takes "
                     "several times as much",
                     "state those that are known"});
    if (!r_.limits.temperature && *c_.hottest_part() > kGreaseEnds)
      all.push_back(
          Warning{"heat", "hot_part",
                  fmt::format("the hottest part has {:.0f} degC; grease and seals do not last beyond 120 degC",
                              *c_.hottest_part() - kKelvin)}
              .with(*c_.hottest_part(), kGreaseEnds, "K"_unit));
    if (c_.mission) return;
    if (!r_.motion.loads && cycle_.duration > kLongCycle)
      all.push_back(Warning{
          "heat", "long_cycle",
          fmt::format("temperatures are the mean of a cycle of {:.3g} min, which hides a peak", cycle_.duration / 60.0)}
                        .with(cycle_.duration, kLongCycle));
    if (!r_.lubricant->temperature) return;
    const PerInterface<double> oil = oil_temperatures(of_parts(*c_.temperature));
    for (const Interface i : kInterfaces)
      if (const double off = std::abs(oil[i] - *r_.lubricant->temperature); off > kOilsMean) {
        all.push_back(Warning{"lubricant.temperature", "other_oil",
                              fmt::format("losses are those at {:.0f} degC, and the oil at the {} has {:.0f} degC",
                                          *r_.lubricant->temperature - kKelvin, prs::name(i), oil[i] - kKelvin),
                              "state a temperature near that of the oil"}
                          .with(off, kOilsMean, "K"_unit));
        return;
      }
  }

  const SizeInput& in_;
  const Requirement& r_;
  const MotionCycle& cycle_;
  SizedCase sized_;
  Contacts contacts_;
  std::optional<Oils> oils_;             ///< Oils of a mission.
  std::optional<MotorDemand> at_start_;  ///< Demand at the temperatures of its start.
  std::vector<Warning> mission_warnings_;
  double lead_ = 0.0;    ///< |l| [m]
  double rating_ = 1.0;  ///< a1 a_ISO
  Measures measures_;
  std::string why_not_steady_;    ///< Reason why the parts have no steady temperatures.
  std::vector<Branch> branches_;  ///< Branches of the shown segments.
  bool drives_ = false;           ///< Whether the screw drives in any segment.
  SizedCandidate c_;
};

}  // namespace

SizedCandidate evaluated(const SizeInput& in, const CandidateData& data) { return Evaluation(in, data).take(); }

namespace {

/// Mean load of the cycle at which a limit of its mean is just reached, if the candidate has the criterion [N].
std::optional<double> allowed_mean_load(const SizedCandidate& c, std::string_view limit, double mean_load) {
  const std::string_view name = limit == "motor_rated" ? "motor_torque" : limit;
  if (name == "static" || name == "buckling" || name == "motor_voltage") return std::nullopt;
  const auto found = std::ranges::find(c.criteria, name, &SizeCriterion::name);
  if (found == c.criteria.end() || !found->margin) return std::nullopt;
  return mean_load * (name == "life" ? std::cbrt(*found->margin) : *found->margin);
}

}  // namespace

std::optional<SizeCurve> force_over_speed(const SizeInput& in, const SizedCandidate& c) {
  const Requirement& r = in.values;
  if (!in.cycle.mean_load) return std::nullopt;
  const double force = *in.cycle.mean_load, lead = std::abs(c.screw.lead);
  double top = *r.limits.speed_times_diameter / c.screw.screw_diameter * lead;
  if (c.critical_speed) top = std::min(top, *r.limits.critical_speed_share * *c.critical_speed * lead / kTurn);
  if (r.motor.largest_speed) top = std::min(top, *r.motor.largest_speed / r.motor.gear_ratio * lead / kTurn);
  const bool has_voltage = r.motor.supply.voltage && c.electric;
  if (has_voltage)
    top = std::min(top, *r.motor.supply.voltage / *r.motor.torque_constant / r.motor.gear_ratio * lead / kTurn);

  SizedCase sized = sized_case(in, c);
  const LoadCase load = sized.c.load_cases[sized.back_driving()];
  SizeCurve curve;
  curve.rank = c.rank;
  sized.c.load_cases.clear();
  sized.c.deviations.temperature = c.parts_at;
  std::optional<Oils> oils;
  if (c.mission) oils = warm_oils(sized.c, oil_temperatures(of_parts(*c.parts_at)));
  for (std::size_t k = 1; k <= kCurvePoints; ++k) curve.speed.push_back(top * static_cast<double>(k) / kCurvePoints);
  std::vector<double> speeds = curve.speed;
  speeds.push_back(in.cycle.driving_speed());
  for (const double speed : speeds) {
    LoadCase& at_speed = sized.c.load_cases.emplace_back(load);
    at_speed.speed = -std::copysign(kTurn * speed / lead, *load.speed);
    at_speed.name = fmt::format("speed-{}", sized.c.load_cases.size());
  }
  std::optional<Result> found;
  if (r.losses == Requirement::Losses::slip && c.is_steady)
    found = analyze_slip(sized.c, checked_contacts(sized.c, Detail::numbers), kManyDesigns, oils);
  using Limit = std::pair<std::string_view, double>;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto limits_at = [&](std::size_t k, double& eta) {
    const double v = speeds[k];
    Branch b;
    if (c.is_steady) b.efficiency = c.row_efficiency;
    if (found && slips(found->load_cases[k])) b = branch_by_slip(found->load_cases[k], lead);
    eta = b.efficiency.value_or(kNone);
    std::vector<Limit> limits;
    if (c.static_safety)
      limits.emplace_back("static", *c.static_safety * in.cycle.largest_force / *r.limits.static_safety);
    if (c.buckling_safety) limits.emplace_back("buckling", *c.buckling_load / *r.limits.buckling_safety);
    if (c.life.revolutions && (r.life.hours || r.life.distance)) {
      // C_e (a1 a_ISO 10^6/L(v))^(1/3) with C_e from this life under F_m.
      const double turns = (r.life.hours ? *r.life.hours * v : *r.life.distance) / lead;
      limits.emplace_back("life", force * std::cbrt(*c.life.revolutions / turns));
    }
    if (r.limits.temperature && c.temperature && !c.mission) {
      const double warmest = b.heat ? network_of(r, c).steady(*b.heat).maxCoeff() : kNone;
      limits.emplace_back("temperature",
                          force * (*r.limits.temperature - r.heat->ambient) / (warmest - r.heat->ambient));
    }
    const auto by_motor = [&](double torque) {
      return (torque * r.motor.gear_ratio * r.motor.gear_efficiency - sized.drag_torque) * kTurn * eta / lead;
    };
    if (c.motor_rms_torque && r.motor.rated_torque) limits.emplace_back("motor_rated", by_motor(*r.motor.rated_torque));
    if (c.motor_peak_torque && r.motor.peak_torque) limits.emplace_back("motor_peak", by_motor(*r.motor.peak_torque));
    if (!c.electric) return limits;
    const double constant = *r.motor.torque_constant;
    if (r.motor.continuous_current)
      limits.emplace_back("motor_rms_current", by_motor(constant * *r.motor.continuous_current));
    if (r.motor.supply.current) limits.emplace_back("motor_current", by_motor(constant * *r.motor.supply.current));
    if (has_voltage) {
      const double left = *r.motor.supply.voltage - constant * r.motor.gear_ratio * kTurn * v / lead;
      limits.emplace_back("motor_voltage", std::max(0.0, by_motor(constant * left / *r.motor.resistance)));
    }
    return limits;
  };
  double eta = kNone;
  const std::vector<Limit> at_mean = limits_at(kCurvePoints, eta);
  std::vector<double> on_and_on(kCurvePoints, HUGE_VAL), in_cycle(kCurvePoints, HUGE_VAL);
  curve.force.resize(at_mean.size());
  ByKey<std::vector<double>> of_cycle(at_mean.size());
  for (std::size_t k = 0; k < kCurvePoints; ++k) {
    const std::vector<Limit> limits = limits_at(k, eta);
    curve.efficiency.push_back(eta);
    for (std::size_t n = 0; n < limits.size(); ++n) {
      const auto& [name, value] = limits[n];
      curve.force[n].first = name;
      curve.force[n].second.push_back(value);
      if (name == "motor_peak" || name == "motor_current") continue;
      on_and_on[k] = std::fmin(on_and_on[k], value);
      const std::optional<double> allowed = allowed_mean_load(c, name, force);
      const double own = allowed ? value / at_mean[n].second * *allowed : value;
      in_cycle[k] = std::fmin(in_cycle[k], own);
      if (!allowed) continue;
      of_cycle[n].first = fmt::format("{}_in_cycle", name);
      of_cycle[n].second.push_back(own);
    }
  }
  std::erase_if(of_cycle, [](const auto& series) { return series.second.empty(); });
  std::ranges::move(of_cycle, std::back_inserter(curve.force));
  if (std::isfinite(on_and_on.front())) curve.force.emplace_back("envelope", std::move(on_and_on));
  if (std::isfinite(in_cycle.front())) curve.force.emplace_back("envelope_in_cycle", std::move(in_cycle));
  for (const MotionSegment& s : in.cycle.shown)
    if (s.force != 0.0)
      curve.required.push_back(
          {s.name, s.largest_speed(), std::abs(s.force), s.sense() == 0 ? std::nullopt : std::optional(s.driven_by())});
  return curve;
}

}  // namespace prs
