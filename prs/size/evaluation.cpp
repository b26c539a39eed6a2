#include "prs/heat/thermal_network.h"
#include "prs/life/analyze_life.h"
#include "prs/measures/measures.h"
#include "prs/size/size.h"
#include "prs/slip/slip.h"

namespace prs {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kPasses = 1.0 - 1e-9;  ///< Least margin, up to rounding.
constexpr double kInchPerSecond = 0.0254;
constexpr double kHour = 3600.0, kKelvin = 273.15;
constexpr double kOilsMean = 20.0;      ///< Difference of the oil's temperature worth a note [K].
constexpr double kGreaseEnds = 393.15;  ///< Grease and seals do not last beyond [K].
constexpr double kLongCycle = 600.0;    ///< Cycle whose mean hides a peak of temperature [s].
constexpr double kRegularLoad = 0.9;    ///< Share of C_a: makers allow more only now and then.
constexpr double kShortStroke = 1.5;    ///< Share of the nut's length.
constexpr int kCurvePoints = 40;

/// What friction makes of one load case.
struct Branch : SizedSegment {
  std::optional<OfParts> heat;  ///< [W]; not of a catalogue's efficiencies.
};

/// At the part that turns, in the sense of the motion [N m]; `efficiency` of the side that drives.
double screw_torque(double force, double lead, DrivenBy driven_by, double efficiency) {
  return (driven_by == DrivenBy::screw ? 1.0 / efficiency : -efficiency) * force * lead / kTurn;
}

Branch branch_by_slip(const LoadCaseResult& r, double lead) {
  const SlipResult& slip = *r.slip;
  Branch b;
  b.driven_by = slip.driven_by;
  b.efficiency = slip.efficiency;
  b.power_loss = slip.power.total();
  b.heat = heat_of(slip.power);
  if (slip.efficiency)
    b.torque = screw_torque(r.load_case.axial_force, lead, slip.driven_by, *slip.efficiency);
  else if (slip.driven_by == DrivenBy::load)
    b.torque = slip.holding_torque;
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
  const Requirement::Conductance& given = in.values.conductance;
  return {given.screw_ambient.value_or(rule.screw_ambient), given.nut_ambient.value_or(rule.nut_ambient),
          given.rollers_ambient.value_or(rule.rollers_ambient), given.screw_rollers.value_or(rule.screw_rollers),
          given.rollers_nut.value_or(rule.rollers_nut)};
}

/// Factor from SI to the unit of a criterion.
double per_si(std::string_view unit) {
  constexpr std::pair<std::string_view, double> kUnits[] = {
      {"h", 1.0 / kHour}, {"km", 1e-3}, {"mm", 1e3}, {"N/um", 1e-6}, {"mm/min", 60e3}, {"rpm", 60.0 / kTurn}};
  const auto found = std::ranges::find(kUnits, unit, &std::pair<std::string_view, double>::first);
  return found == std::end(kUnits) ? 1.0 : found->second;
}

/// The parts of one candidate's evaluation, each on what those before it found.
class Evaluation {
 public:
  Evaluation(const SizeInput& in, const CandidateData& data)
      : in_(in), r_(in.values), cycle_(in.cycle), sized_(sized_case(in, data)) {
    static_cast<CandidateData&>(c_) = data;
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
    find_lives();
    find_branches();
    find_stiffness();
    find_losses();
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
    const LifeResult life = analyze_life(sized_.c, contacts_);
    c_.by_threads.capacity = life.dynamic_capacity;
    rating_ = life.rated_over_l10();
    if (life.converged()) {
      c_.by_threads.static_safety = life.static_safety();
      if (cycle_.mean_load)
        c_.by_threads.life = life_of(life.system_life * rating_ * cycle_.travel / cycle_.loaded_travel);
    }
    c_.life = c_.by_threads.life;
    c_.static_safety = c_.by_threads.static_safety;
    if (r_.life.basis != Requirement::Basis::maker) return;
    if (c_.static_capacity) c_.static_safety = *c_.static_capacity / cycle_.largest_force;
    if (!c_.dynamic_capacity) return;
    c_.life_basis = Requirement::Basis::maker;
    if (cycle_.mean_load) c_.life = life_of(rating_ * rating_life(*c_.dynamic_capacity, *cycle_.mean_load));
  }

  void find_branches() {
    const Result result = analyze_slip(sized_.c, contacts_, kManyDesigns);
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

  /// Finds the stiffness of the load case with the largest force, at rest, in series with the shaft.
  void find_stiffness() {
    std::size_t largest = sized_.back_driving();
    for (std::size_t k = 0; k < sized_.back_driving(); ++k)
      if (largest == sized_.back_driving() ||
          sized_.c.load_cases[k].axial_force > sized_.c.load_cases[largest].axial_force * (1.0 + 1e-9))
        largest = k;
    Conditions at_rest = sized_.c;
    at_rest.load_cases = {sized_.c.load_cases[largest]};
    const std::optional<double> nut = analyze(at_rest, contacts_, kManyDesigns).load_cases.front().axial_stiffness;
    if (nut && measures_.shaft_stiffness) c_.stiffness = 1.0 / (1.0 / *nut + 1.0 / *measures_.shaft_stiffness);
  }

  void find_losses() {
    double lost = 0.0, work = 0.0, input = 0.0;
    OfParts heat = OfParts::Zero();
    bool has_losses = true, has_heat = r_.losses == Requirement::Losses::slip, has_eta = true;
    for (const MotionSegment& s : cycle_.all) {
      const Branch& b = branches_[s.shown_as];
      if (!b.driven_by || s.force == 0.0) continue;
      // Of its losses a branch has so many times as much [s].
      const MotionSegment& of = cycle_.shown[s.shown_as];
      const double weight = s.work() / of.work() * of.duration;
      has_losses = has_losses && b.power_loss;
      has_heat = has_heat && b.heat;
      if (b.power_loss) lost += *b.power_loss * weight;
      if (b.heat) heat += *b.heat * weight;
      if (b.driven_by != DrivenBy::screw) continue;
      drives_ = true;
      has_eta = has_eta && b.efficiency;
      work += s.work();
      if (b.efficiency) input += s.work() / *b.efficiency;
    }
    if (has_losses) c_.power_lost = lost / cycle_.duration;
    if (has_eta && drives_) c_.efficiency = work / input;
    if (has_heat)
      c_.temperature = per_part(
          thermal_network({.ambient = r_.ambient, .conductance = c_.conductance}).steady(heat / cycle_.duration));
  }

  bool locks() const { return c_.self_locking.value_or(false); }

  void find_torques() {
    const Requirement::Motor& motor = r_.motor;
    const double ratio = motor.gear_ratio, gear = motor.gear_efficiency;
    const double per_speed = kTurn / lead_;
    c_.holding_torque = cycle_.holding_force / (per_speed * ratio);
    c_.brake_needed = cycle_.holding_force > 0.0 && !locks();
    if (cycle_.moves()) c_.motor_largest_speed = ratio * per_speed * cycle_.largest_speed;
    if (motor.inertia > 0.0 && c_.inertia)
      c_.inertia_ratio = (*c_.inertia + r_.load.moved_mass / (per_speed * per_speed)) / (ratio * ratio * motor.inertia);
    double square = 0.0, peak = 0.0, power = 0.0, mean_back = 0.0, peak_back = 0.0;
    bool known = c_.inertia.has_value();
    for (const MotionSegment& s : cycle_.all) {
      double at_motor = 0.0;
      if (s.sense() == 0) {
        if (!r_.brake_torque && !locks()) at_motor = std::abs(s.force) / (per_speed * ratio);
      } else {
        const Branch& b = branches_[s.shown_as];
        if (!b.torque) {
          known = false;
          continue;
        }
        const double alpha = per_speed * s.acceleration() * s.sense();
        const double torque =
            (s.force == 0.0 || !b.driven_by ? 0.0 : *b.torque * std::abs(s.force / cycle_.shown[s.shown_as].force)) +
            r_.load.drag_torque + c_.inertia.value_or(0.0) * alpha;
        at_motor = (torque >= 0.0 ? torque / (ratio * gear) : torque * gear / ratio) + motor.inertia * ratio * alpha;
      }
      if (!cycle_.in_classes) c_.segments[s.shown_as].motor_torque = at_motor;
      const double speed = per_speed * ratio;  // Of the motor over that of the axis.
      square += at_motor * at_motor * s.duration;
      peak = std::max(peak, std::abs(at_motor));
      power = std::max(power, std::abs(at_motor) * speed * s.largest_speed());
      if (at_motor >= 0.0) continue;
      mean_back -= at_motor * speed * std::abs(s.travel());
      peak_back = std::max(peak_back, -at_motor * speed * s.largest_speed());
    }
    if (!known) return;
    c_.motor_rms_torque = std::sqrt(square / cycle_.duration);
    c_.motor_peak_torque = peak;
    c_.motor_peak_power = power;
    c_.regenerated_mean = mean_back / cycle_.duration;
    c_.regenerated_peak = peak_back;
  }

  void find_relubrication() {
    if (!(cycle_.rms_speed > 0.0) || !cycle_.mean_load) return;
    const auto& rule = r_.relubrication;
    const double factor =
        rule ? std::min(1.0, rule->static_load_factor * rule->peak_force / *cycle_.mean_load - 0.15) : 1.0;
    if (factor > 0.0) c_.relubrication = 4500.0 * kHour * std::pow(cycle_.rms_speed / kInchPerSecond, -1.57) * factor;
  }

  // The verdict

  struct Given {
    std::optional<double> value, limit;          ///< SI, temperatures in degC.
    std::string_view not_applicable = {};        ///< Why; empty: it applies.
    std::string_view not_computed = "no value";  ///< Why, where there is none.
    std::string reason = {};
  };

  /// A criterion with a limit. A value that must reach it has the margin value/limit, one that must
  /// not pass it limit/value, both counted from `zero`.
  void add(std::string_view name, std::string_view unit, bool must_reach, Given g, double zero = 0.0) {
    if (!g.limit) return;
    const double factor = per_si(unit);
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
    const Requirement::Motor& m = r_.motor;
    const std::string_view rests = cycle_.moves() ? "" : "nothing moves";
    const std::string_view no_load = cycle_.mean_load ? "" : "nothing moves under force";
    const std::string_view no_loads = "thread loads do not converge";
    const bool by_row = r_.losses == Requirement::Losses::catalogue;
    const std::string_view no_efficiency =
        by_row ? "the row has no efficiency" : "slip has no equilibrium, and the row no efficiency";
    const auto in_celsius = [](const std::optional<double>& kelvin) {
      return kelvin ? std::optional(*kelvin - kKelvin) : std::nullopt;
    };
    const std::string basis =
        fmt::format("{} C_a {:.4g} kN", by_maker() ? "maker's" : "threads, Lemor's", 1e-3 * capacity());
    const std::optional<double> hours = c_.life.hours ? std::optional(*c_.life.hours * kHour) : std::nullopt;
    at_least("life", "h", {hours, r_.life.hours, no_load, no_loads, basis});
    at_least("life", "km", {c_.life.travel, r_.life.distance, no_load, no_loads, basis});
    at_least("static_safety", "",
             {c_.static_safety, l.static_safety, "", no_loads,
              r_.life.basis == Requirement::Basis::maker && c_.static_capacity
                  ? fmt::format("maker's C_0 {:.4g} kN", 1e-3 * *c_.static_capacity)
                  : "threads: pressure, deformation or a flank's edge"});
    at_least("buckling", "",
             {c_.buckling_safety, l.buckling_safety,
              cycle_.largest_compression > 0.0 ? "" : "nothing compresses the screw"});
    at_most(
        "critical_speed", "",
        {c_.critical_speed && c_.largest_speed ? std::optional(*c_.largest_speed / *c_.critical_speed) : std::nullopt,
         l.critical_speed_share,
         !cycle_.moves()                              ? rests
         : c_.screw.type == Mechanism::Type::inverted ? "the screw does not turn"
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
        {in_celsius(c_.hottest_part()), in_celsius(l.temperature), "",
         by_row ? "a catalogue does not say where losses arise" : "slip has no equilibrium"},
        r_.ambient - kKelvin);
    at_most("motor_speed", "rpm", {c_.motor_largest_speed, m.largest_speed, rests});
    at_most("motor_torque", "N m", {c_.motor_rms_torque, m.rated_torque, "", no_efficiency});
    at_most("motor_peak_torque", "N m", {c_.motor_peak_torque, m.peak_torque, "", no_efficiency});
    at_most("brake", "N m", {c_.holding_torque, r_.brake_torque, cycle_.holding_force > 0.0 ? "" : "no force at rest"});
    at_least(
        "relubrication", "h",
        {c_.relubrication, l.relubrication, cycle_.moves() ? no_load : rests, "the mean load is too high for the rule",
         r_.relubrication ? "" : "without the actuator's peak force: its factor is 1"});
    decide();
  }

  void judge_back_driving() {
    using enum Requirement::BackDriving;
    const Requirement::BackDriving wanted = r_.limits.back_driving;
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
  /// C_a of the life that counts [N].
  double capacity() const { return by_maker() ? *c_.dynamic_capacity : *c_.by_threads.capacity; }

  void warn() {
    std::vector<Warning>& all = c_.warnings;
    if (cycle_.mean_load && *cycle_.mean_load > 0.5 * capacity())
      all.push_back(Warning{"life", "mean_load",
                            "the mean load, {value}, is beyond half of C_a, {limit}: the formula of life is not made "
                            "for it",
                            "take a larger screw"}
                        .with(*cycle_.mean_load, 0.5 * capacity(), text_unit::kilonewton));
    if (cycle_.largest_force > kRegularLoad * capacity())
      all.push_back(Warning{"motion", "largest_force",
                            "the largest force, {value}, is beyond 0.9 C_a, {limit}, which a maker does not allow "
                            "regularly",
                            "take a larger screw"}
                        .with(cycle_.largest_force, kRegularLoad * capacity(), text_unit::kilonewton));
    const Mechanism& mechanism = sized_.screw.c.mechanism;
    const bool standard = c_.screw.type == Mechanism::Type::standard;
    const double length = standard ? c_.nut_length : mechanism.contacts_per_roller * axial_pitch(mechanism);
    if (standard && r_.stroke && sized_.shaft_length < *r_.stroke + c_.nut_length)
      all.push_back(
          Warning{"shaft.length", "short_shaft", "the shaft, {value}, is shorter than stroke and nut together, {limit}",
                  "lengthen it"}
              .with(sized_.shaft_length, *r_.stroke + c_.nut_length, text_unit::millimetre, Warning::Worse::smaller));
    const std::optional<double> stroke = r_.motion.loads ? r_.stroke : std::optional(cycle_.loaded_way);
    if (stroke && *stroke > 0.0 && *stroke < kShortStroke * length)
      all.push_back(Warning{"stroke", "short_stroke",
                            fmt::format("the stroke under load, {{value}}, is below {{limit}}, 1.5 times the {}: life "
                                        "needs a special calculation, none is public",
                                        standard ? "nut's length" : "length of the rollers' threads")}
                        .with(*stroke, kShortStroke * length, text_unit::millimetre, Warning::Worse::smaller));
    if (c_.brake_needed && r_.friction->model == Friction::Model::jacod)
      all.push_back(
          {"friction", "film_at_rest", "at rest the film of `jacod` is gone, so that the screw may still hold"});
    warn_of_heat();
  }

  void warn_of_heat() {
    if (!c_.temperature) return;
    std::vector<Warning>& all = c_.warnings;
    const Requirement::Conductance& k = r_.conductance;
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
              .with(*c_.hottest_part(), kGreaseEnds, text_unit::kelvin));
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
                          .with(off, kOilsMean, text_unit::kelvin));
        return;
      }
  }

  const SizeInput& in_;
  const Requirement& r_;
  const MotionCycle& cycle_;
  SizedCase sized_;
  Contacts contacts_;
  double lead_ = 0.0;    ///< |l| [m]
  double rating_ = 1.0;  ///< a1 a_ISO
  Measures measures_;
  std::vector<Branch> branches_;  ///< Branches of the segments that are shown.
  bool drives_ = false;           ///< The screw, in some segment.
  SizedCandidate c_;
};

}  // namespace

SizedCandidate evaluated(const SizeInput& in, const CandidateData& data) { return Evaluation(in, data).take(); }

std::optional<SizeCurve> force_over_speed(const SizeInput& in, const SizedCandidate& c) {
  const Requirement& r = in.values;
  if (!in.cycle.mean_load) return std::nullopt;
  const double force = *in.cycle.mean_load, lead = std::abs(c.screw.lead);
  double top = *r.limits.speed_times_diameter / c.screw.screw_diameter * lead;
  if (c.critical_speed) top = std::min(top, *r.limits.critical_speed_share * *c.critical_speed * lead / kTurn);
  if (r.motor.largest_speed) top = std::min(top, *r.motor.largest_speed / r.motor.gear_ratio * lead / kTurn);

  SizedCase sized = sized_case(in, c);
  const LoadCase load = sized.c.load_cases[sized.back_driving()];
  SizeCurve curve;
  curve.rank = c.rank;
  sized.c.load_cases.clear();
  for (int k = 1; k <= kCurvePoints; ++k) {
    curve.speed.push_back(top * k / kCurvePoints);
    LoadCase& at_speed = sized.c.load_cases.emplace_back(load);
    at_speed.speed = -std::copysign(kTurn * curve.speed.back() / lead, *load.speed);
    at_speed.name = fmt::format("speed-{}", k);
  }
  std::optional<Result> found;
  if (r.losses == Requirement::Losses::slip) found = analyze_slip(sized.c, kManyDesigns);
  const ThermalNetwork network = thermal_network({.ambient = r.ambient, .conductance = c.conductance});
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> least(kCurvePoints, std::numeric_limits<double>::infinity());
  const auto put = [&](const char* limit, std::size_t k, double value) {
    if (k == 0) curve.force.push_back({limit, {}});
    std::ranges::find(curve.force, limit, [](const auto& series) { return series.first; })->second.push_back(value);
    if (std::string_view(limit) != "motor_peak") least[k] = std::fmin(least[k], value);
  };
  for (std::size_t k = 0; k < curve.speed.size(); ++k) {
    const double v = curve.speed[k];
    Branch b;
    b.efficiency = c.row_efficiency;
    if (found && slips(found->load_cases[k])) b = branch_by_slip(found->load_cases[k], lead);
    const double eta = b.efficiency.value_or(kNone);
    curve.efficiency.push_back(eta);
    if (c.static_safety) put("static", k, *c.static_safety * in.cycle.largest_force / *r.limits.static_safety);
    if (c.buckling_safety) put("buckling", k, *c.buckling_load / *r.limits.buckling_safety);
    if (c.life.revolutions && (r.life.hours || r.life.distance)) {
      // C_e (a1 a_ISO 10^6/L(v))^(1/3) with the C_e that has this life under F_m.
      const double turns = (r.life.hours ? *r.life.hours * v : *r.life.distance) / lead;
      put("life", k, force * std::cbrt(*c.life.revolutions / turns));
    }
    if (r.limits.temperature && c.temperature) {
      const double warmest = b.heat ? network.steady(*b.heat).maxCoeff() : kNone;
      put("temperature", k, force * (*r.limits.temperature - r.ambient) / (warmest - r.ambient));
    }
    const auto by_motor = [&](double torque) {
      return (torque * r.motor.gear_ratio * r.motor.gear_efficiency - r.load.drag_torque) * kTurn * eta / lead;
    };
    if (c.motor_rms_torque && r.motor.rated_torque) put("motor_rated", k, by_motor(*r.motor.rated_torque));
    if (c.motor_peak_torque && r.motor.peak_torque) put("motor_peak", k, by_motor(*r.motor.peak_torque));
  }
  if (std::isfinite(least.front())) curve.force.emplace_back("envelope", std::move(least));
  return curve;
}

}  // namespace prs
