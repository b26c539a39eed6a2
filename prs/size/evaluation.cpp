#include "prs/size/evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "prs/configurations/complete_screw.h"
#include "prs/heat/thermal_network.h"
#include "prs/life/analyze_life.h"
#include "prs/loads/analyze.h"
#include "prs/measures/measures.h"
#include "prs/model/units.h"
#include "prs/size/motion.h"
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
constexpr double kRegularLoad = 0.9;    ///< Of C_a: makers allow more only now and then.
constexpr double kShortStroke = 1.5;    ///< Of the nut's length.
constexpr int kCurvePoints = 40;

/// What friction makes of one load case.
struct Branch {
  DrivenBy driven_by = DrivenBy::screw;
  std::optional<double> efficiency;  ///< Of the side that drives.
  std::optional<double> power;       ///< Lost [W].
  std::optional<double> torque;      ///< In the sense of the motion [N m].
  std::optional<OfParts> heat;       ///< [W]; not of a catalogue's efficiencies.
};

double torque_of_screw(double force, double lead, double efficiency) {
  return force * lead / (kTurn * efficiency);
}

Branch branch_by_slip(const LoadCaseResult& r, double lead) {
  const SlipResult& slip = *r.slip;
  const double force = r.load_case.axial_force;
  Branch b{slip.driven_by, slip.efficiency, slip.power.total(), {}, heat_of(slip.power)};
  if (slip.driven_by == DrivenBy::screw && slip.efficiency)
    b.torque = torque_of_screw(force, lead, *slip.efficiency);
  else if (slip.driven_by == DrivenBy::load)
    b.torque = slip.efficiency ? -force * lead * *slip.efficiency / kTurn : *slip.holding_torque;
  return b;
}

Branch branch_by_catalogue(const CandidateData& data, const LoadCaseResult& r, DrivenBy driven_by,
                           double lead) {
  const double force = r.load_case.axial_force;
  const double input = force * std::abs(*r.load_case.speed) * lead / kTurn;
  Branch b{driven_by,
           driven_by == DrivenBy::screw ? data.efficiency : data.back_driving_efficiency,
           {},
           {},
           {}};
  if (!b.efficiency) return b;
  const double eta = *b.efficiency;
  b.power = driven_by == DrivenBy::screw ? input * (1.0 / eta - 1.0) : input * (1.0 - eta);
  b.torque = driven_by == DrivenBy::screw ? torque_of_screw(force, lead, eta)
                                          : -force * lead * eta / kTurn;
  return b;
}

bool slips(const LoadCaseResult& r) { return r.converged() && r.slip && r.slip->converged(); }

/// The parts of one candidate's evaluation, each on what those before it found.
class Evaluation {
 public:
  Evaluation(const SizeInput& in, const CandidateData& data)
      : in_(in), r_(in.values), cycle_(in.cycle), data_(data), sized_(sized_case(in, data)) {
    contacts_ = checked_contacts(sized_.c, Detail::numbers);
    lead_ = std::abs(contacts_.threads.screw.lead);
  }

  SizedCandidate take() {
    describe();
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
  void describe() {
    const CompleteScrew& s = sized_.screw;
    c_.name = data_.name;
    c_.is_row = data_.is_row;
    c_.number = data_.number;
    c_.type = s.data.type;
    c_.screw_diameter = s.data.screw_diameter;
    c_.lead = s.data.lead;
    c_.starts = s.c.mechanism.starts.screw;
    c_.nut_diameter = s.c.structure->nut.outer_diameter;
    c_.nut_length = s.c.structure->nut.length;
    c_.dynamic_capacity = data_.dynamic_capacity;
    c_.static_capacity = data_.static_capacity;
  }

  void find_measures() {
    measures_ = measures_of(sized_.c, contacts_);
    c_.shaft_length = sized_.shaft_length;
    if (measures_.weight && measures_.screw_weight_per_length)
      c_.weight = *measures_.weight + *measures_.screw_weight_per_length * sized_.shaft_length;
    c_.inertia = measures_.equivalent_inertia;
    c_.buckling_load = measures_.buckling_load;
    if (c_.buckling_load && cycle_.largest_compression > 0.0)
      c_.buckling_safety = *c_.buckling_load / cycle_.largest_compression;
    if (!(cycle_.largest_speed > 0.0)) return;
    c_.critical_speed = measures_.critical_speed;
    c_.largest_speed = kTurn * cycle_.largest_speed / lead_;
    c_.speed_times_diameter = cycle_.largest_speed / lead_ * c_.screw_diameter;
  }

  SizedLife life_of(double revolutions) const {
    return {revolutions, revolutions * lead_ / cycle_.travel * cycle_.duration / kHour,
            revolutions * lead_};
  }

  void find_lives() {
    const LifeResult life = analyze_life(sized_.c, contacts_);
    c_.thread_capacity = life.dynamic_capacity;
    rating_ = life.rated_over_l10();
    if (life.converged()) {
      c_.thread_static_safety = life.static_safety();
      if (cycle_.mean_load)
        c_.thread_life = life_of(life.system_life * rating_ * cycle_.travel / cycle_.loaded_travel);
    }
    c_.life = c_.thread_life;
    c_.static_safety = c_.thread_static_safety;
    if (r_.life.basis != Requirement::Basis::maker) return;
    if (data_.static_capacity) c_.static_safety = *data_.static_capacity / cycle_.largest_force;
    if (!data_.dynamic_capacity) return;
    c_.life_basis = Requirement::Basis::maker;
    if (cycle_.mean_load)
      c_.life = life_of(rating_ * rating_life(*data_.dynamic_capacity, *cycle_.mean_load));
  }

  void find_branches() {
    result_ = analyze_slip(sized_.c, contacts_, kManyDesigns);
    const LoadCaseResult& back = result_.load_cases[sized_.back_driving()];
    if (slips(back)) c_.self_locking = back.slip->self_locking.value_or(false);
    branches_.resize(cycle_.shown.size());
    bool by_row = false;
    const auto branch = [&](std::size_t place, DrivenBy driven_by) {
      const LoadCaseResult& found = result_.load_cases[place];
      if (r_.losses == Requirement::Losses::slip && slips(found))
        return branch_by_slip(found, lead_);
      by_row = true;
      return branch_by_catalogue(data_, found, driven_by, lead_);
    };
    for (std::size_t k = 0; k < branches_.size(); ++k) {
      const MotionSegment& s = cycle_.shown[k];
      if (const auto& place = sized_.load_case_of[k])
        branches_[k] = branch(*place, s.force * s.sense() > 0.0 ? DrivenBy::screw : DrivenBy::load);
    }
    c_.back_driving_efficiency = branch(sized_.back_driving(), DrivenBy::load).efficiency;
    if (by_row && r_.losses == Requirement::Losses::slip)
      c_.warnings.push_back(
          "losses: slip finds no equilibrium of a load case, which has the catalogue's efficiency "
          "in its place, if it prints one");
  }

  /// That of the load case with the largest force, at rest, in series with the shaft.
  void find_stiffness() {
    std::size_t largest = sized_.back_driving();
    for (std::size_t k = 0; k < sized_.back_driving(); ++k)
      if (largest == sized_.back_driving() ||
          sized_.c.load_cases[k].axial_force >
              sized_.c.load_cases[largest].axial_force * (1.0 + 1e-9))
        largest = k;
    Conditions at_rest = sized_.c;
    at_rest.load_cases = {sized_.c.load_cases[largest]};
    const std::optional<double> nut =
        analyze(at_rest, contacts_, kManyDesigns).load_cases.front().axial_stiffness;
    if (nut && measures_.shaft_stiffness)
      c_.stiffness = 1.0 / (1.0 / *nut + 1.0 / *measures_.shaft_stiffness);
  }

  /// Of losses a segment's branch has so many times as much, over its whole duration [s].
  double weight(const MotionSegment& s) const {
    const MotionSegment& of = cycle_.shown[s.shown_as];
    return std::abs(s.force * s.travel()) / (std::abs(of.force) * of.mean_speed());
  }

  void find_losses() {
    double lost = 0.0, work = 0.0, input = 0.0;
    OfParts heat = OfParts::Zero();
    bool has_losses = true, has_heat = r_.losses == Requirement::Losses::slip, has_eta = true;
    for (const MotionSegment& s : cycle_.all) {
      const std::optional<Branch>& b = branches_[s.shown_as];
      if (!b || !s.is_loaded()) continue;
      has_losses = has_losses && b->power;
      has_heat = has_heat && b->heat;
      if (b->power) lost += *b->power * weight(s);
      if (b->heat) heat += *b->heat * weight(s);
      if (b->driven_by != DrivenBy::screw) continue;
      drives_ = true;
      has_eta = has_eta && b->efficiency;
      work += std::abs(s.force * s.travel());
      if (b->efficiency) input += std::abs(s.force * s.travel()) / *b->efficiency;
    }
    if (has_losses) c_.power_lost = lost / cycle_.duration;
    if (has_eta && drives_) c_.efficiency = work / input;
    if (has_heat)
      c_.temperature =
          per_part(thermal_network({.ambient = r_.heat.ambient, .conductance = *c_.conductance})
                       .steady(heat / cycle_.duration));
  }

  bool locks() const { return c_.self_locking.value_or(false); }

  void find_torques() {
    const Requirement::Motor& motor = r_.motor;
    const double ratio = motor.gear_ratio, gear = motor.gear_efficiency;
    const double per_speed = kTurn / lead_;
    c_.holding_torque = cycle_.holding_force / (per_speed * ratio);
    c_.brake_needed = cycle_.holding_force > 0.0 && !locks();
    if (cycle_.largest_speed > 0.0)
      c_.motor_largest_speed = ratio * per_speed * cycle_.largest_speed;
    if (motor.inertia > 0.0 && c_.inertia)
      c_.inertia_ratio = (*c_.inertia + r_.load.moved_mass / (per_speed * per_speed)) /
                         (ratio * ratio * motor.inertia);
    double square = 0.0, peak = 0.0, power = 0.0, mean_back = 0.0, peak_back = 0.0;
    bool known = c_.inertia.has_value();
    c_.segments.reserve(cycle_.shown.size());
    for (std::size_t k = 0; k < cycle_.shown.size(); ++k) {
      SizedSegment& own = c_.segments.emplace_back();
      own.name = cycle_.shown[k].name;
      if (const std::optional<Branch>& b = branches_[k]) {
        own.efficiency = b->efficiency;
        own.driven_by = b->driven_by;
        own.power_loss = b->power;
        own.torque = b->torque;
      } else {
        own.torque = 0.0;
      }
    }
    for (const MotionSegment& s : cycle_.all) {
      double at_motor = 0.0;
      if (s.sense() == 0) {
        if (!r_.brake && !locks()) at_motor = std::abs(s.force) / (per_speed * ratio);
      } else {
        const std::optional<Branch>& b = branches_[s.shown_as];
        double torque = 0.0;
        if (b && s.is_loaded()) {
          if (!b->torque) {
            known = false;
            continue;
          }
          torque = *b->torque * std::abs(s.force / cycle_.shown[s.shown_as].force);
        }
        const double alpha = per_speed * s.acceleration() * s.sense();
        torque += r_.load.drag_torque + c_.inertia.value_or(0.0) * alpha;
        at_motor = (torque >= 0.0 ? torque / (ratio * gear) : torque * gear / ratio) +
                   motor.inertia * ratio * alpha;
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
        rule ? std::min(1.0, rule->static_load_factor * rule->peak_force / *cycle_.mean_load - 0.15)
             : 1.0;
    if (factor > 0.0)
      c_.relubrication =
          4500.0 * kHour * std::pow(cycle_.rms_speed / kInchPerSecond, -1.57) * factor;
  }

  // The verdict

  struct Given {
    std::optional<double> value;  ///< In the unit of the criterion, as is the limit.
    std::optional<double> limit;
    std::string not_applicable = {};  ///< Why; empty: it applies.
    std::string not_computed = "no value";
    std::string reason = {};
  };

  /// A criterion with a limit; `least`: the value must reach it. `zero` counts as no value at all.
  void add(std::string_view name, std::string_view unit, bool least, Given g, double zero = 0.0) {
    if (!g.limit) return;
    SizeCriterion& c = c_.criteria.emplace_back(SizeCriterion{name, unit, {}, g.limit});
    c.reason = std::move(g.reason);
    if (!g.not_applicable.empty()) {
      c.status = CriterionStatus::not_applicable;
      c.reason = std::move(g.not_applicable);
      return;
    }
    if (!g.value) {
      c.status = CriterionStatus::not_computed;
      c.reason = std::move(g.not_computed);
      return;
    }
    c.value = g.value;
    const double margin = least ? *g.value / *g.limit : (*g.limit - zero) / (*g.value - zero);
    if (!std::isfinite(margin)) return;
    c.margin = margin;
    if (margin < kPasses) c.status = CriterionStatus::fail;
  }

  void judge() {
    const Requirement::Limits& l = r_.limits;
    const Requirement::Motor& m = r_.motor;
    const bool moves = cycle_.largest_speed > 0.0;
    const std::string rests = moves ? "" : "nothing moves";
    const std::string no_load = cycle_.mean_load ? "" : "nothing moves under force";
    const std::string no_efficiency = r_.losses == Requirement::Losses::catalogue
                                          ? "the row has no efficiency"
                                          : "slip has no equilibrium, and the row no efficiency";
    const auto scaled = [](const std::optional<double>& value, double factor) {
      return value ? std::optional(*value * factor) : std::nullopt;
    };
    const bool maker = c_.life_basis == Requirement::Basis::maker;
    const std::string basis =
        fmt::format("{} C_a {:.4g} kN", maker ? "maker's" : "threads, Lemor's",
                    1e-3 * (maker ? *data_.dynamic_capacity : *c_.thread_capacity));
    if (r_.life.hours)
      add("life", "h", true,
          {c_.life.hours, *r_.life.hours / kHour, no_load, "thread loads do not converge", basis});
    if (r_.life.distance)
      add("life", "km", true,
          {scaled(c_.life.travel, 1e-3), *r_.life.distance * 1e-3, no_load,
           "thread loads do not converge", basis});
    add("static_safety", "", true,
        {c_.static_safety, l.static_safety, "", "thread loads do not converge",
         r_.life.basis == Requirement::Basis::maker && data_.static_capacity
             ? fmt::format("maker's C_0 {:.4g} kN", 1e-3 * *data_.static_capacity)
             : "threads: pressure, deformation or a flank's edge"});
    add("buckling", "", true,
        {c_.buckling_safety, l.buckling_safety,
         cycle_.largest_compression > 0.0 ? "" : "nothing compresses the screw"});
    add("critical_speed", "", false,
        {c_.critical_speed ? scaled(c_.largest_speed, 1.0 / *c_.critical_speed) : std::nullopt,
         l.critical_speed_share,
         !moves                                 ? rests
         : c_.type == Mechanism::Type::inverted ? "the screw does not turn"
                                                : ""});
    add("speed_times_diameter", "mm/min", false,
        {scaled(c_.speed_times_diameter, 60e3), l.speed_times_diameter * 60e3, rests});
    add("nut_diameter", "mm", false, {1e3 * c_.nut_diameter, scaled(l.nut_diameter, 1e3)});
    add("nut_length", "mm", false, {1e3 * c_.nut_length, scaled(l.nut_length, 1e3)});
    add("weight", "kg", false, {c_.weight, l.weight});
    add("stiffness", "N/um", true,
        {scaled(c_.stiffness, 1e-6), scaled(l.stiffness, 1e-6), "",
         "thread loads do not converge"});
    add("efficiency", "", true,
        {c_.efficiency, l.efficiency, drives_ ? "" : "the screw drives in no segment",
         no_efficiency});
    judge_back_driving();
    const double ambient = r_.heat.ambient - kKelvin;
    std::optional<double> hottest;
    if (c_.temperature) hottest = hottest_part() - kKelvin;
    add("temperature", "degC", false,
        {hottest, l.temperature ? std::optional(*l.temperature - kKelvin) : std::nullopt, "",
         r_.losses == Requirement::Losses::catalogue ? "a catalogue does not say where losses arise"
                                                     : "slip has no equilibrium"},
        ambient);
    add("motor_speed", "rpm", false,
        {scaled(c_.motor_largest_speed, 60.0 / kTurn), scaled(m.largest_speed, 60.0 / kTurn),
         rests});
    add("motor_torque", "N m", false, {c_.motor_rms_torque, m.rated_torque, "", no_efficiency});
    add("motor_peak_torque", "N m", false,
        {c_.motor_peak_torque, m.peak_torque, "", no_efficiency});
    add("brake", "N m", false,
        {c_.holding_torque, r_.brake ? std::optional(r_.brake->torque) : std::nullopt,
         cycle_.holding_force > 0.0 ? "" : "no force at rest"});
    add("relubrication", "h", true,
        {scaled(c_.relubrication, 1.0 / kHour), scaled(l.relubrication, 1.0 / kHour),
         moves ? no_load : rests, "the mean load is too high for the rule",
         r_.relubrication ? "" : "without the actuator's peak force: its factor is 1"});
    decide();
  }

  void judge_back_driving() {
    using enum Requirement::BackDriving;
    const Requirement::BackDriving wanted = r_.limits.back_driving;
    if (wanted == allowed) return;
    const bool holds = wanted == forbidden ? locks() : !locks();
    c_.criteria.push_back(
        {.name = "back_driving",
         .status = holds ? CriterionStatus::pass : CriterionStatus::fail,
         .reason = locks() ? "the screw locks itself" : "the load turns the screw"});
  }

  void decide() {
    c_.passes = c_.missed() == 0;
    double least = std::numeric_limits<double>::infinity();
    for (const SizeCriterion& c : c_.criteria) {
      if (c.holds() && !c.margin) continue;
      const double margin = c.margin.value_or(0.0);
      if (margin < least) least = margin, c_.limited_by = c.name;
    }
  }

  double hottest_part() const {
    return std::max({c_.temperature->screw, c_.temperature->roller, c_.temperature->nut});
  }

  template <class... Args>
  void note(fmt::format_string<Args...> text, Args&&... args) {
    c_.warnings.push_back(fmt::format(text, std::forward<Args>(args)...));
  }

  void warn() {
    const double capacity =
        c_.life_basis == Requirement::Basis::maker ? *data_.dynamic_capacity : *c_.thread_capacity;
    if (cycle_.mean_load && *cycle_.mean_load > 0.5 * capacity)
      note(
          "life: the mean load, {:.4g} kN, is beyond half of C_a, {:.4g} kN: the formula of life "
          "is not made for it",
          1e-3 * *cycle_.mean_load, 0.5e-3 * capacity);
    if (cycle_.largest_force > kRegularLoad * capacity)
      note(
          "motion: the largest force, {:.4g} kN, is beyond 0.9 C_a, {:.4g} kN, which a maker does "
          "not allow regularly",
          1e-3 * cycle_.largest_force, kRegularLoad * 1e-3 * capacity);
    const Mechanism& mechanism = sized_.screw.c.mechanism;
    const double length = c_.type == Mechanism::Type::standard
                              ? c_.nut_length
                              : mechanism.contacts_per_roller * axial_pitch(mechanism);
    if (r_.stroke && *r_.stroke < kShortStroke * length)
      note(
          "stroke: {:.4g} mm is below 1.5 times the {}, {:.4g} mm: life needs a special "
          "calculation, none is public",
          1e3 * *r_.stroke,
          c_.type == Mechanism::Type::standard ? "nut's length" : "length of the rollers' threads",
          1e3 * length);
    if (c_.brake_needed && r_.friction->model == Friction::Model::jacod)
      note("friction: at rest the film of `jacod` is gone, so that the screw may still hold");
    warn_of_heat();
  }

  void warn_of_heat() {
    if (!c_.temperature) return;
    const Requirement::Heat::Conductance& k = r_.heat.conductance;
    if (r_.limits.temperature &&
        !(k.screw_ambient && k.nut_ambient && k.screw_rollers && k.rollers_nut))
      note(
          "heat: conductances by rule decide on temperatures: bare parts in still air, a bolted "
          "housing takes several times as much");
    if (!r_.limits.temperature && hottest_part() > kGreaseEnds)
      note("heat: the hottest part has {:.3g} degC; grease and seals do not last beyond 120 degC",
           hottest_part() - kKelvin);
    if (!r_.motion.loads && cycle_.duration > kLongCycle)
      note("heat: temperatures are the mean of a cycle of {:.3g} min, which hides a peak",
           cycle_.duration / 60.0);
    if (!r_.lubricant->temperature) return;
    const PerInterface<double> oil = oil_temperatures(of_parts(*c_.temperature));
    for (const Interface i : kInterfaces)
      if (std::abs(oil[i] - *r_.lubricant->temperature) > kOilsMean)
        return note(
            "lubricant.temperature: losses are those at {:.3g} degC, and the oil at the {} "
            "has {:.3g} degC",
            *r_.lubricant->temperature - kKelvin, prs::name(i), oil[i] - kKelvin);
  }

  const SizeInput& in_;
  const Requirement& r_;
  const MotionCycle& cycle_;
  const CandidateData& data_;
  SizedCase sized_;
  Contacts contacts_;
  double lead_ = 0.0;    ///< |l| [m]
  double rating_ = 1.0;  ///< a1 a_ISO
  Measures measures_;
  Result result_;
  std::vector<std::optional<Branch>> branches_;  ///< Of the segments that are shown.
  bool drives_ = false;                          ///< The screw, in some segment.
  SizedCandidate c_;
};

}  // namespace

SizedCandidate evaluated(const SizeInput& in, const CandidateData& data) {
  return Evaluation(in, data).take();
}

Heat::Conductance conductance_of(const SizeInput& in, const SizedCase& sized) {
  CompleteScrew screw = sized.screw;
  screw.load = in.cycle.driving_force();
  Heat::Conductance k = estimated_conductance(screw, sized.shaft_length);
  const Requirement::Heat::Conductance& given = in.values.heat.conductance;
  const auto take = [](double& value, const std::optional<double>& stated) {
    if (stated) value = *stated;
  };
  take(k.screw_ambient, given.screw_ambient);
  take(k.nut_ambient, given.nut_ambient);
  take(k.rollers_ambient, given.rollers_ambient);
  take(k.screw_rollers, given.screw_rollers);
  take(k.rollers_nut, given.rollers_nut);
  return k;
}

std::optional<SizeCurve> force_over_speed(const SizeInput& in, const CandidateData& data,
                                          const SizedCandidate& candidate) {
  const Requirement& r = in.values;
  const MotionCycle& cycle = in.cycle;
  if (!cycle.mean_load) return std::nullopt;
  const double force = *cycle.mean_load, lead = std::abs(candidate.lead);
  double top = r.limits.speed_times_diameter / candidate.screw_diameter * lead;
  if (candidate.critical_speed)
    top = std::min(top, r.limits.critical_speed_share * *candidate.critical_speed * lead / kTurn);
  if (r.motor.largest_speed)
    top = std::min(top, *r.motor.largest_speed / r.motor.gear_ratio * lead / kTurn);

  SizedCase sized = sized_case(in, data);
  LoadCase load = sized.c.load_cases[sized.back_driving()];
  SizeCurve curve;
  curve.rank = candidate.rank;
  std::vector<LoadCase> cases;
  for (int k = 1; k <= kCurvePoints; ++k) {
    curve.speed.push_back(top * k / kCurvePoints);
    load.speed = -std::copysign(kTurn * curve.speed.back() / lead, *load.speed);
    load.name = fmt::format("speed-{}", k);
    cases.push_back(load);
    load.speed = -*load.speed;  // Back to the sense in which the load drives.
  }
  sized.c.load_cases = std::move(cases);
  std::optional<Result> found;
  if (r.losses == Requirement::Losses::slip) found = analyze_slip(sized.c, kManyDesigns);
  const double rating = reliability_factor(r.life.reliability) * r.life.modification_factor;
  const ThermalNetwork network =
      thermal_network({.ambient = r.heat.ambient, .conductance = *candidate.conductance});
  std::vector<double> least(kCurvePoints, std::numeric_limits<double>::infinity());
  bool bounded = false;
  const auto put = [&](std::vector<double>& series, std::size_t k, double value) {
    series.push_back(value);
    least[k] = std::fmin(least[k], value);
    bounded = true;
  };
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < curve.speed.size(); ++k) {
    const double v = curve.speed[k];
    std::optional<Branch> b;
    if (found && slips(found->load_cases[k]))
      b = branch_by_slip(found->load_cases[k], lead);
    else
      b = Branch{DrivenBy::screw, data.efficiency, {}, {}, {}};
    const double eta = b->efficiency.value_or(kNone);
    curve.efficiency.push_back(eta);
    if (candidate.static_safety)
      put(curve.by_static, k,
          *candidate.static_safety * cycle.largest_force / r.limits.static_safety);
    if (candidate.buckling_safety)
      put(curve.by_buckling, k, *candidate.buckling_load / r.limits.buckling_safety);
    if (candidate.life.revolutions && (r.life.hours || r.life.distance)) {
      const double capacity = force * std::cbrt(*candidate.life.revolutions / (rating * 1e6));
      const double turns = (r.life.hours ? *r.life.hours * v : *r.life.distance) / lead;
      put(curve.by_life, k, capacity * std::cbrt(rating * 1e6 / turns));
    }
    if (r.limits.temperature && candidate.temperature) {
      const double warmest = b->heat ? network.steady(*b->heat).maxCoeff() : kNone;
      put(curve.by_temperature, k,
          force * (*r.limits.temperature - r.heat.ambient) / (warmest - r.heat.ambient));
    }
    const auto motor = [&](double torque) {
      return (torque * r.motor.gear_ratio * r.motor.gear_efficiency - r.load.drag_torque) * kTurn *
             eta / lead;
    };
    if (r.motor.rated_torque && candidate.motor_rms_torque)
      put(curve.by_motor_rated, k, motor(*r.motor.rated_torque));
    if (r.motor.peak_torque && candidate.motor_peak_torque)
      curve.by_motor_peak.push_back(motor(*r.motor.peak_torque));
  }
  if (bounded) curve.envelope = std::move(least);
  return curve;
}

}  // namespace prs
