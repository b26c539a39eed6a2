#include "prs/life/analyze_life.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <numeric>

#include "prs/life/contact_loads.h"
#include "prs/slip/running.h"
#include "prs/slip/slip_warnings.h"
#include "prs/threads/geometry_warnings.h"

namespace prs {
namespace {

/// Load, as a share of the largest, below which shares are taken as constant: a million such loads contribute 1e-9 of
/// its damage.
constexpr double kLeastLoad = 1e-5;

/// Largest number of forces of one sense that are solved one by one if an equilibrium takes long or has no smooth
/// curve.
constexpr std::size_t kFewForces = 40;

/// Tolerances of curves over more than `kFewForces` forces: with preload, and for all rollers.
constexpr double kCurveTolerance = 1e-5, kOrbitTolerance = 1e-4;

void find_capacity(const LifeModel& p, LifeResult& r) {
  const double angle = contact_angle({p.laws.screw.normal_angle, p.laws.nut.normal_angle});
  const LemorGeometry g = lemor_geometry(p.contacts.mechanism, angle);
  r.element_ratio = g.roller_diameter * std::cos(angle) / g.pitch_circle;
  r.failure_shares = failure_shares(r.element_ratio);
  r.reliability_factor = reliability_factor(p.c.life->reliability);
  const Mechanism& m = p.contacts.mechanism;
  if (p.full())
    r.roller_shares = {roller_failure_share(m.rollers, *m.pitch_diameter.roller, *m.pitch_diameter.screw),
                       roller_failure_share(m.rollers, *m.pitch_diameter.roller, *m.pitch_diameter.nut)};
  if (p.c.life->dynamic_capacity) {
    r.dynamic_capacity = *p.c.life->dynamic_capacity;
    r.dynamic_capacity_range = {r.dynamic_capacity, r.dynamic_capacity};
    return;
  }
  if (p.c.materials && !is_steel(*p.c.materials))
    throw CaseError("materials",
                    "got parts that are not of steel; expected a modulus of 190 to 230 GPa, for which Lemor's capacity "
                    "is made; give a capacity from tests, for example `life: {dynamic_capacity: 60 kN, ..}`");
  r.lemor = lemor_capacity(g);
  if (!r.lemor)
    throw CaseError("mechanism.pitch_diameter.roller",
                    fmt::format("gives the ratio d_r cos(alpha)/d_nut = {:.4f}; expected {} to {}, where the "
                                "factor of Lemor's capacity is known; give the capacity of a catalogue, for "
                                "example `life: {{dynamic_capacity: 60 kN, ..}}`",
                                factor_ratio(g), kFactorRatios.least, kFactorRatios.greatest));
  r.dynamic_capacity = r.lemor->capacity;
  r.dynamic_capacity_range = r.lemor->capacity_range;
  for (Warning& warning : beside_lemor_range(angle, *r.contacts.mechanism.pitch_diameter.screw))
    r.warnings.push_back(std::move(warning));
}

void find_spectrum(const Conditions& c, LifeResult& r) {
  const std::optional<double> speed = c.operation ? std::optional(std::abs(c.operation->speed)) : std::nullopt;
  const double lead = r.contacts.mechanism.lead;
  r.steps = load_steps(*c.life, r.history, lead, speed);
  if (r.history) {
    r.duration = duration(*r.history);
  } else {
    r.revolutions_known = !c.life->spectrum.front().share;
    double seconds = 0.0;
    for (const SpectrumLoad& l : c.life->spectrum)
      seconds += l.duration.value_or(std::numeric_limits<double>::quiet_NaN());
    if (std::isfinite(seconds)) r.duration = seconds;
    if (c.life->period) r.duration = c.life->period;
  }
  for (const LoadStep& s : r.steps) {
    r.revolutions += s.revolutions;
    r.largest_force = std::max(r.largest_force, std::abs(s.axial_force));
  }
  r.mean_load = mean_load(r.steps);
  const char* path = r.history ? "life.history.file" : "life.spectrum";
  if (!(r.revolutions > 0.0))
    throw CaseError(path,
                    "got loads under which the screw does not turn; expected travel: rolling "
                    "contacts live by revolutions under load; check position, speed and time");
  if (r.history && !r.history->time.empty() && *r.duration == 0.0)
    throw CaseError("life.history.time",
                    "got the same time in all samples, between which the screw turns; expected times that grow; check "
                    "the column, or leave `time` out");
  if (!(r.largest_force > 0.0) && !c.preload)
    throw CaseError(path, "got no load other than 0; expected loads; check the column of the force");
  if (speed && *speed > 0.0) r.moving_rate = *speed / (2.0 * std::numbers::pi);
  constexpr double kRounding = 1e-5;
  if (const double moving = r.moving_rate ? r.revolutions / *r.moving_rate : 0.0;
      c.life->period && moving > (1.0 + kRounding) * *c.life->period)
    r.warnings.push_back(Warning{"life.period", "short_period",
                                 "a pass of the spectrum takes {value} at `operation.speed`, more than its period of "
                                 "{limit}",
                                 "state the time of the whole pass, or the speed of its motion"}
                             .with(moving, *c.life->period, "s"_unit));
  r.revolution_rate = r.duration && *r.duration > 0.0 ? std::optional(r.revolutions / *r.duration) : r.moving_rate;
}

/// The bearing under the loads of a pass; travel without load, which `life.travel` contains, counts too.
BearingLife bearing_life(const Bearings::Fixed& bearing, const LifeResult& r) {
  BearingLife found;
  double damage = 0.0;
  const auto add = [&](double force, double revolutions) {
    found.revolutions += revolutions;
    damage += std::pow(preloaded_bearing_load(force, bearing.preload), bearing.exponent) * revolutions;
  };
  for (const LoadStep& step : r.steps) add(std::abs(step.axial_force), step.revolutions);
  if (r.life.travel) add(0.0, std::max(0.0, *r.life.travel / std::abs(r.contacts.mechanism.lead) - r.revolutions));
  found.equivalent_load = std::pow(damage / found.revolutions, 1.0 / bearing.exponent);
  if (bearing.dynamic_capacity)
    found.life = 1e6 * std::pow(*bearing.dynamic_capacity / found.equivalent_load, bearing.exponent);
  if (bearing.static_capacity && r.largest_force > 0.0)
    found.static_safety = *bearing.static_capacity / r.largest_force;
  return found;
}

/// sum (load)^3 n of each contact, from equilibria alone: an interpolated cube is a sum over nodes, so that the weights
/// of all loads are first collected there.
class CubicSums {
 public:
  CubicSums(const ShareCurve& curve, std::size_t contacts)
      : curve_(curve), weights_(curve.node_count(), 0.0), sums_(contacts, 0.0) {}

  /// Adds a weight of the cubes of the curve's values at a force [N].
  void add(double force, double weight) {
    const ShareCurve::Place place = curve_.place(force);
    for (std::size_t j = 0; j < ShareCurve::kNodes; ++j) weights_[place.first + j] += weight * place.weights[j];
  }

  std::vector<double> take() && {
    for (std::size_t node = 0; node < weights_.size(); ++node) {
      if (weights_[node] == 0.0) continue;
      for (std::size_t k = 0; k < sums_.size(); ++k) {
        const double share = curve_.shares(node)[k];
        sums_[k] += weights_[node] * share * share * share;
      }
    }
    return std::move(sums_);
  }

 private:
  const ShareCurve& curve_;
  std::vector<double> weights_, sums_;
};

/// Magnitude of a force along a direction [N]; 0 for the other sense.
double along(double axial_force, Direction d) {
  return std::max(0.0, d == Direction::tension ? axial_force : -axial_force);
}

bool has_pressures(const Contacts& contacts) {
  return contacts.interfaces.screw.has_hertz() && contacts.interfaces.nut.has_hertz();
}

/// Part of the spectrum with one sense of the force, and its results.
struct Sense {
  double revolutions = 0.0;            ///< Revolutions under a force other than 0.
  double largest = 0.0;                ///< [N]
  double running = 0.0;                ///< Largest force under which the screw turns [N].
  double damage = 0.0;                 ///< sum F^3 n
  std::vector<double> forces;          ///< Magnitudes [N].
  std::vector<double> turns;           ///< Revolutions under each.
  std::vector<double> driven_by_load;  ///< Revolutions driven by the load.

  ContactSolver solver;
  std::optional<ContactLoads> at_largest, at_running;  ///< Loads at rest under these forces, if solved.
  /// Largest loads of each thread over all forces: at rest, and of the turning screw.
  std::optional<PerDirection<LargestLoads>> resting, turning;
  std::optional<ShareCurve> curve;  ///< Curve at rest.
  /// sum (load)^3 n of each rated contact, as in `LifeModel::rated`, and the same at rest.
  std::vector<double> cubes, cubes_at_rest;
  int solves = 0;      ///< Number of equilibria of all curves.
  double error = 0.0;  ///< Largest error of all curves.
  /// Largest load of a thread over that at rest, under the force where friction changes it most.
  PerInterface<OverStatic> over_static;

  bool exists() const { return !forces.empty(); }
  /// Loads under a force, kept if it is requested again.
  std::optional<ContactLoads> solve(double force) {
    const auto is = [&](double kept) { return std::abs(force - kept) <= 1e-12 * kept; };
    std::optional<ContactLoads> loads = solver(force);
    if (is(largest)) at_largest = loads;
    if (is(running)) at_running = loads;
    return loads;
  }
  /// Loads of the rated contacts under a force [N].
  std::vector<double> loads_at(double force, std::size_t count, bool preloaded) const {
    std::vector<double> loads(count, 0.0);
    if (!curve || (force == 0.0 && !preloaded)) return loads;
    curve->shares_at(force, loads);
    if (!preloaded)
      for (double& load : loads) load *= force;
    return loads;
  }
};

/// Steps of a spectrum by the sense of their force; with preload a step without force belongs to
/// tension.
PerDirection<Sense> senses_of(const LifeModel& p, const LifeResult& r) {
  PerDirection<Sense> senses;
  for (const LoadStep& step : r.steps) {
    if (step.axial_force == 0.0 && !p.preloaded()) continue;
    const double force = std::abs(step.axial_force);
    Sense& s = senses[step.axial_force < 0.0 ? Direction::compression : Direction::tension];
    s.forces.push_back(force);
    s.turns.push_back(step.revolutions);
    s.driven_by_load.push_back(step.driven_by_load);
    if (force > 0.0) s.revolutions += step.revolutions;
    s.largest = std::max(s.largest, force);
    if (step.revolutions > 0.0) s.running = std::max(s.running, force);
    s.damage += force * force * force * step.revolutions;
  }
  return senses;
}

/// Share of the damage between two forces, or that of the cube of the larger force if larger: the range of a cycle
/// counts however little the screw turns.
std::function<double(double, double)> damage_between(const Sense& s) {
  std::map<double, double> up_to;  // Cumulative damage by force.
  for (std::size_t k = 0; k < s.forces.size(); ++k) up_to[s.forces[k]] += std::pow(s.forces[k], 3) * s.turns[k];
  double sum = 0.0;
  for (auto& [force, damage] : up_to) sum = damage += sum;
  return [up_to = std::move(up_to), largest = s.largest, sum](double from, double to) {
    const auto below = [&](auto place) { return place == up_to.begin() ? 0.0 : std::prev(place)->second; };
    const double part = below(up_to.upper_bound(to)) - below(up_to.lower_bound(from));
    return std::max(std::pow(to / largest, 3), sum > 0.0 ? part / sum : 0.0);
  };
}

/// Curve of a sense, with few equilibria.
ShareCurve curve_of_sense(const LifeModel& p, const Sense& s, const ShareCurve::Solve& solve) {
  const double least = std::max(*std::ranges::min_element(s.forces), kLeastLoad * s.largest);
  if (!p.full() && !p.preloaded()) return ShareCurve(solve, least, s.largest);
  std::set<double> forces(s.forces.begin(), s.forces.end());
  if (p.preloaded()) forces.insert(0.0);
  if (forces.size() <= kFewForces) return ShareCurve(solve, forces);
  if (p.preloaded()) return ShareCurve(solve, 0.0, s.largest, {kCurveTolerance, {}});
  return ShareCurve(solve, least, s.largest, {kOrbitTolerance, damage_between(s)});
}

/// Curve of a running screw under the forces at which it turns, without interpolation if they are fewer than the nodes
/// of a panel. Under small forces, where the centrifugal one opens threads, loads are only as accurate as their share
/// of the damage requires.
ShareCurve running_curve(const LifeModel& p, const Sense& s, const std::vector<double>& turns,
                         const ShareCurve::Solve& solve) {
  std::set<double> forces;
  for (std::size_t k = 0; k < turns.size(); ++k)
    if (turns[k] > 0.0) forces.insert(s.forces[k]);
  if (forces.size() < ShareCurve::kNodes && !p.full() && !p.preloaded()) return ShareCurve(solve, forces);
  if (p.full() || p.preloaded()) return curve_of_sense(p, s, solve);
  const double least = std::max(*std::ranges::min_element(s.forces), kLeastLoad * s.largest);
  return ShareCurve(solve, least, s.largest, {ShareCurve::kTolerance, damage_between(s)});
}

/// Keeps the larger load of each thread.
void keep_larger(const std::vector<double>& loads, std::vector<double>& kept) {
  kept.resize(std::max(kept.size(), loads.size()), 0.0);
  for (std::size_t k = 0; k < loads.size(); ++k) kept[k] = std::max(kept[k], loads[k]);
}

void keep_larger(const ContactLoads& loads, std::optional<PerDirection<LargestLoads>>& kept) {
  if (!kept) kept.emplace();
  for (const Direction flank : kDirections)
    for (const Interface i : kInterfaces) keep_larger(loads.largest[flank][i], (*kept)[flank][i]);
}

double largest_of(const std::vector<double>& loads) { return loads.empty() ? 0.0 : *std::ranges::max_element(loads); }

/// Largest normal load of the flanks of an interface [N].
double largest_normal_load(const LifeModel& p, Interface i, const LargestLoads& loads) {
  return largest_of(loads[i]) / std::cos(p.laws[i].normal_angle);
}

/// Largest load of a thread over its limit, under a force; none without equilibrium.
using Overload = std::function<std::optional<double>(double force)>;

/// Force at which the overload is 1: secant method on logarithms, in which that load is nearly a straight line over the
/// force.
std::optional<double> by_secant(const Overload& overload, double force, double tolerance) {
  constexpr double kLargestStep = 2.0;
  double x = std::log(force), step = 0.0, last = 0.0;
  for (int k = 0; k < 60; ++k) {
    const std::optional<double> used = overload(std::exp(x));
    if (!used) return std::nullopt;
    const double over = std::log(*used);
    const double slope = k == 0 ? 1.0 : (over - last) / step;
    step = std::clamp(-over / (slope > 0.05 ? slope : 1.0), -kLargestStep, kLargestStep);
    last = over;
    x += step;
    if (std::abs(step) < tolerance) return std::exp(x);
  }
  return std::nullopt;
}

/// Root between a force that does not reach the limit and one that does.
std::optional<double> between(const Overload& overload, double below, double above, double tolerance) {
  bool failed = false;
  const auto over = [&](double force) {
    const std::optional<double> used = overload(force);
    failed = failed || !used;
    return used.value_or(1.0) - 1.0;
  };
  std::uintmax_t most = 100;
  const auto close = [tolerance](double a, double b) { return std::abs(a - b) <= tolerance * std::abs(b); };
  const auto [from, to] = boost::math::tools::toms748_solve(over, below, above, close, most);
  return failed ? std::nullopt : std::optional(0.5 * (from + to));
}

/// Smallest force at which a thread of an interface reaches its normal load: 0 if one does without external force, as
/// preload and lateral loads may cause. Both can also hide the limit from the secant method, and cause a smaller force
/// at which it is reached.
std::optional<double> force_at(const LifeModel& p, const LargestSolver& solve, double force,
                               const PerInterface<std::optional<double>>& limit) {
  if (!limit.screw && !limit.nut) return std::nullopt;
  const Overload overload = [&](double at) -> std::optional<double> {
    const auto loads = solve(at);
    if (!loads) return std::nullopt;
    double used = 0.0;
    for (const Interface i : kInterfaces)
      if (limit[i]) used = std::max(used, largest_normal_load(p, i, *loads) / *limit[i]);
    return used;
  };
  if (p.preloaded()) {
    const std::optional<double> used = overload(0.0);
    if (!used) return std::nullopt;
    if (*used >= 1.0) return 0.0;
  }
  const double tolerance = p.full() ? 1e-7 : 1e-10;
  const std::optional<double> found = by_secant(overload, force, tolerance);
  if (p.preloaded() ? found.has_value() : !p.is_loaded_across()) return found;

  double above = found.value_or(force);
  for (int k = 0; !found; ++k, above *= 2.0) {
    const std::optional<double> used = k < 20 ? overload(above) : std::nullopt;
    if (!used) return std::nullopt;
    if (*used >= 1.0) break;
  }
  if (p.preloaded()) return between(overload, 0.0, above, tolerance);
  // Lateral loads may be worse under smaller forces: factor of the steps, and share that counts as no force.
  constexpr double kStep = 0.84, kNoForce = 1e-3;
  const double least = kNoForce * above;
  std::optional<double> below;
  for (double at = kStep * above; at > least; at *= kStep) {
    const std::optional<double> used = overload(at);
    if (!used) return below && above != found ? between(overload, *below, above, tolerance) : found;
    if (*used >= 1.0) {
      above = at;
      below.reset();
    } else if (!below) {
      below = at;
    }
  }
  if (!below) return 0.0;
  return above == found ? found : between(overload, *below, above, tolerance);
}

/// `turns`: revolutions for the forces of a sense.
std::vector<double> cubes_of(const LifeModel& p, const Sense& s, const ShareCurve& curve,
                             const std::vector<double>& turns) {
  CubicSums sums(curve, p.rated().count());
  for (std::size_t k = 0; k < s.forces.size(); ++k) {
    const double force = s.forces[k];
    if (turns[k] > 0.0) sums.add(force, turns[k] * (p.preloaded() ? 1.0 : force * force * force));
  }
  return std::move(sums).take();
}

/// Compares running loads with those at rest, at the forces under which a sense turns, or at some of many.
void compare_with_rest(const LifeModel& p, Sense& s, Direction d, const ShareCurve& running,
                       const std::vector<double>& turns) {
  const RatedContacts rated = p.rated();
  const std::size_t step = (s.forces.size() + kFewForces - 1) / kFewForces;
  std::vector<double> runs(rated.count()), rests(rated.count());
  for (std::size_t k = 0; k < s.forces.size(); k += step) {
    if (!(turns[k] > 0.0)) continue;
    running.shares_at(s.forces[k], runs);
    s.curve->shares_at(s.forces[k], rests);
    for (const Interface i : kInterfaces) {
      const auto of_threads = [&](const std::vector<double>& loads) {
        return std::span(loads).subspan(rated.flank(d) + rated.body(i), rated.threads);
      };
      const std::span<const double> run = of_threads(runs), rest = of_threads(rests);
      const double largest = std::ranges::max(rest);
      if (!(largest > 0.0)) continue;
      const OverStatic over{std::ranges::max(run) / largest, std::accumulate(run.begin(), run.end(), 0.0) /
                                                                 std::accumulate(rest.begin(), rest.end(), 0.0)};
      if (is_worse(over, s.over_static[i])) s.over_static[i] = over;
    }
  }
}

/// Loads of rated contacts; the largest of forces up to `greatest` are kept.
ShareCurve::Solve keeping_larger(ContactSolver solve, double greatest,
                                 std::optional<PerDirection<LargestLoads>>& kept) {
  return [solve = std::move(solve), greatest, &kept](double force) -> std::optional<std::vector<double>> {
    std::optional<ContactLoads> loads = solve(force);
    if (!loads) return std::nullopt;
    if (force <= greatest) keep_larger(*loads, kept);
    return std::move(loads->rated);
  };
}

/// A force without thread loads [N], at rest or running.
struct FailedLoad {
  double force = 0.0;
  bool is_running = false;
};

/// Computes curves of a sense and the damage of its loads; returns the force if they failed.
std::optional<FailedLoad> find_cubes(const LifeModel& p, Sense& s, Direction d) {
  const auto found = [&](const ShareCurve& curve) {
    s.solves += curve.solves();
    s.error = std::max(s.error, curve.error());
    return curve.failed_at();
  };
  s.curve = curve_of_sense(p, s, keeping_larger([&](double force) { return s.solve(force); }, HUGE_VAL, s.resting));
  if (const auto failed = found(*s.curve)) return FailedLoad{*failed};
  s.cubes = s.cubes_at_rest = cubes_of(p, s, *s.curve, s.turns);
  if (!p.running()) return std::nullopt;
  s.cubes.assign(s.cubes.size(), 0.0);
  for (const DrivenBy by : {DrivenBy::screw, DrivenBy::load}) {
    std::vector<double> turns = s.driven_by_load;
    if (by == DrivenBy::screw)
      for (std::size_t k = 0; k < turns.size(); ++k) turns[k] = s.turns[k] - turns[k];
    if (!(std::ranges::max(turns) > 0.0)) continue;
    const ContactSolver running = running_loads_solver(p, d, by);
    double largest = 0.0;
    for (std::size_t k = 0; k < turns.size(); ++k)
      if (turns[k] > 0.0) largest = std::max(largest, s.forces[k]);
    const ShareCurve::Solve rated_at = keeping_larger(running, largest, s.turning);
    const ShareCurve curve = running_curve(p, s, turns, rated_at);
    if (const auto failed = found(curve)) return FailedLoad{*failed, true};
    if (!rated_at(largest)) return FailedLoad{largest, true};
    compare_with_rest(p, s, d, curve, turns);
    const std::vector<double> cubes = cubes_of(p, s, curve, turns);
    for (std::size_t k = 0; k < cubes.size(); ++k) s.cubes[k] += cubes[k];
  }
  return std::nullopt;
}

std::string failure_at(const LifeModel& p, const FailedLoad& at, Direction d) {
  const double force = at.force;
  if (at.is_running)
    return fmt::format("the screw does not run under {:.6g} N in {}: `prs slip` under this force says why", force,
                       name(d));
  const std::string why = why_not_held(p, d, force);
  return fmt::format("the load distribution under {:.6g} N in {} did not converge{}{}", force, name(d),
                     why.empty() ? "" : ": ", why);
}

void find_static_loads(const LifeModel& p, const LargestSolver& solve, FlankLife& flank) {
  PerInterface<std::optional<double>> pressure, edge;
  for (const Interface i : kInterfaces) {
    const StaticLimits limits = static_limits(p.c.materials, p.contacts, i);
    pressure[i] = limits.pressure;
    edge[i] = limits.flank_edge;
  }
  if (has_pressures(p.contacts)) {
    if (pressure.screw && pressure.nut) flank.static_capacity = force_at(p, solve, flank.largest_force, pressure);
    flank.flank_edge_load = force_at(p, solve, flank.largest_force, edge);
  }
  flank.static_rating = static_rating(flank.static_capacity, p.c.life->static_capacity);
}

void find_equal_shares_static_loads(const LifeModel& p, LifeResult& r) {
  if (!has_pressures(p.contacts)) return;
  double pressure = std::numeric_limits<double>::infinity(), edge = pressure;
  bool is_known = true;
  for (const Interface i : kInterfaces) {
    const StaticLimits limits = static_limits(p.c.materials, p.contacts, i);
    const double per_normal_load = std::cos(p.laws[i].normal_angle) / p.equal_share();
    is_known = is_known && limits.pressure;
    pressure = std::min(pressure, limits.pressure.value_or(0.0) * per_normal_load);
    edge = std::min(edge, *limits.flank_edge * per_normal_load);
  }
  if (is_known) r.equal_shares_static_capacity = pressure;
  r.equal_shares_flank_edge_load = edge;
}

void require_thrust(const LifeModel& p, Direction d) {
  if (!p.solved() || p.preloaded()) return;
  const Conditions& c = p.c;
  const Structure::Thrust& thrust = c.structure->nut.thrust;
  if (d == Direction::tension ? thrust.tension : thrust.compression) return;
  throw CaseError(fmt::format("structure.nut.thrust.{}", name(d)),
                  fmt::format("missing; expected the axial position of the section that holds {}, "
                              "which the loads of `life` contain; add `{}: 10 mm`, for example",
                              name(d), name(d)));
}

/// Contacts of a flank among all rated ones.
std::span<const double> of_flank(const LifeModel& p, std::span<const double> all, Direction d) {
  return all.subspan(p.rated().flank(d), p.rated().of_flank());
}

/// Equivalent ranges of the loads of the threads on the flanks of one direction over the cycles.
std::vector<double> equivalent_ranges(const LifeModel& p, const PerDirection<Sense>& senses,
                                      std::span<const Cycle> cycles, Direction d) {
  const RatedContacts rated = p.rated();
  const double slope = p.c.life->fatigue_slope;
  std::vector<double> damage(rated.of_flank(), 0.0);
  double scale = 0.0;
  for (const Direction s : kDirections)
    if (p.preloaded() || s == d) scale = std::max(scale, senses[s].largest);
  const auto loads_at = [&](double axial_force) {
    const bool pushed = axial_force < 0.0 || (axial_force == 0.0 && !senses.tension.curve);
    const Direction s = pushed ? Direction::compression : Direction::tension;
    if (!p.preloaded() && s != d) return std::vector<double>(rated.count(), 0.0);
    return senses[s].loads_at(std::abs(axial_force), rated.count(), p.preloaded());
  };
  for (const Cycle& c : cycles) {
    if (!p.preloaded() && along(c.start.value, d) == 0.0 && along(c.end.value, d) == 0.0) continue;
    const std::vector<double> start = loads_at(c.start.value), end = loads_at(c.end.value);
    for (std::size_t k = 0; k < damage.size(); ++k) {
      const std::size_t at = rated.flank(d) + k;
      damage[k] += c.count * std::pow(std::abs(start[at] - end[at]) / scale, slope);
    }
  }
  const double total = count(cycles);
  for (double& d_k : damage) d_k = total > 0.0 ? scale * std::pow(d_k / total, 1.0 / slope) : 0.0;
  return damage;
}

/// Values times a factor.
std::vector<double> scaled(std::span<const double> values, double factor) {
  std::vector<double> result;
  for (const double value : values) result.push_back(value * factor);
  return result;
}

/// Lives of contacts that share a part of the failures; `loads`: loads of the mechanism at which all would carry as
/// much [N].
std::vector<double> lives_of(const LifeResult& r, std::span<const double> loads, double failure_share) {
  std::vector<double> lives;
  for (const double load : loads)
    lives.push_back(thread_life(r.dynamic_capacity, load, failure_share, static_cast<int>(loads.size())));
  return lives;
}

/// Threads of an interface from the equivalent loads of a flank's contacts; adds their lives.
ThreadLives thread_lives_of(const LifeModel& p, const LifeResult& r, Interface i, std::span<const double> equivalent,
                            std::vector<double>& lives) {
  const RatedContacts rated = p.rated();
  const double rollers = r.roller_shares ? (*r.roller_shares)[i] : 0.0;
  const double per_load = p.equal_share(), share = r.failure_shares[i];
  const auto bodies = equivalent.subspan(rated.body(i), rated.threads);
  ThreadLives t;
  t.equivalent_load = scaled(bodies, per_load);
  t.life = lives_of(r, bodies, share * (1.0 - rollers));
  t.rated_life = scaled(t.life, r.rated_over_l10());
  lives.insert(lives.end(), t.life.begin(), t.life.end());
  if (rated.rollers == 0) return t;
  const auto loads = equivalent.subspan(rated.roller(i), rated.rollers * rated.threads);
  RollerLives& own = t.rollers.emplace();
  own.threads_per_roller = static_cast<int>(rated.threads);
  own.equivalent_load = scaled(loads, per_load);
  own.life = lives_of(r, loads, share * rollers);
  own.rated_life = scaled(own.life, r.rated_over_l10());
  lives.insert(lives.end(), own.life.begin(), own.life.end());
  return t;
}

void find_flank(const LifeModel& p, const PerDirection<Sense>& senses, LifeResult& r, Direction d) {
  const Sense& s = senses[d];
  FlankLife flank;
  flank.revolutions = s.revolutions;
  flank.largest_force = s.largest;
  for (const Direction of : kDirections) {
    if (!senses[of].curve || (of != d && !p.preloaded())) continue;
    flank.solves += senses[of].solves;
    flank.interpolation_error = std::max(flank.interpolation_error, senses[of].error);
  }
  const auto equivalent_loads = [&](std::vector<double> Sense::*of_sense) {
    std::vector<double> equivalent(p.rated().of_flank(), 0.0);
    for (const Direction of : kDirections) {
      if (senses[of].cubes.empty() || (of != d && !p.preloaded())) continue;
      const auto cubes = of_flank(p, senses[of].*of_sense, d);
      for (std::size_t k = 0; k < equivalent.size(); ++k) equivalent[k] += cubes[k];
    }
    for (double& f : equivalent) f = std::cbrt(std::max(f, 0.0) / r.revolutions);
    return equivalent;
  };
  const std::vector<double> equivalent = equivalent_loads(&Sense::cubes);
  flank.mean_load = p.preloaded() ? equivalent[p.rated().side()] : std::cbrt(s.damage / r.revolutions);

  std::vector<double> lives, at_rest;
  for (const Interface i : kInterfaces) flank.threads[i] = thread_lives_of(p, r, i, equivalent, lives);
  flank.life = combined_life(lives);
  const std::vector<double> equivalent_at_rest = equivalent_loads(&Sense::cubes_at_rest);
  for (const Interface i : kInterfaces) thread_lives_of(p, r, i, equivalent_at_rest, at_rest);
  flank.life_at_rest = combined_life(at_rest);
  if (r.cycles) {
    const std::vector<double> ranges = equivalent_ranges(p, senses, r.cycles->cycles, d);
    for (const Interface i : kInterfaces)
      flank.threads[i].equivalent_range =
          scaled(std::span(ranges).subspan(p.rated().body(i), p.rated().threads), p.equal_share());
  }

  // Flanks that only the preload loads carry most without external load.
  const Sense& worst = s.exists() ? s : senses[opposite(d)];
  const bool runs = s.running > 0.0 || p.preloaded();
  const auto solved = [&](const std::optional<ContactLoads>& kept, double force) {
    return kept && s.exists() ? kept : worst.solver(force);
  };
  const auto largest = solved(s.at_largest, s.largest);
  const auto running = runs ? solved(s.at_running, s.running) : largest;
  if (!largest || !running) {
    r.failure = failure_at(p, {s.largest}, d);
    return;
  }
  for (const Interface i : kInterfaces) {
    std::vector<double>& all = flank.threads[i].largest_load;
    all = largest->largest[d][i];
    if (s.resting) keep_larger((*s.resting)[d][i], all);
    const std::vector<double>& turning = worst.turning ? (*worst.turning)[d][i] : running->largest[d][i];
    if (runs) keep_larger(turning, all);
    if (!p.contacts.interfaces[i].has_hertz()) continue;
    const auto pressure = [&](const std::vector<double>& loads) {
      const double normal = largest_of(loads) / std::cos(p.laws[i].normal_angle);
      return contact::at_load(p.contacts.interfaces[i].hertz, normal).peak_pressure;
    };
    flank.peak_pressure[i] = pressure(all);
    if (runs) flank.running_peak_pressure[i] = pressure(turning);
  }
  if (s.largest > 0.0) find_static_loads(p, largest_solver(p, d, s.solver, *largest), flank);
  r.flanks[d] = std::move(flank);
}

/// Solves the equilibria of both senses, then computes the lives of the loaded flanks.
void find_lives(const LifeModel& p, LifeResult& r) {
  PerDirection<Sense> senses = senses_of(p, r);
  const PerDirection<bool> wanted{senses.tension.exists(), senses.compression.exists()};
  for (const Direction d : kDirections)
    if (wanted[d]) require_thrust(p, d);
  const PerDirection<ContactSolver> solvers = contact_solvers(p, wanted);
  for (const Direction d : kDirections) {
    if (!wanted[d]) continue;
    Sense& s = senses[d];
    s.solver = solvers[d];
    if (const std::optional<FailedLoad> failed = find_cubes(p, s, d)) {
      r.failure = failure_at(p, *failed, d);
      return;
    }
  }
  for (const Direction d : kDirections)
    if (!r.failure && (wanted[d] || p.preloaded())) find_flank(p, senses, r, d);
  if (!p.running() || r.failure) return;
  for (const Direction d : kDirections)
    if (auto warning = guides_press(p.c, senses[d].over_static)) {
      r.warnings.push_back(std::move(*warning));
      return;
    }
}

void find_weakest(LifeResult& r) {
  for (const Direction d : kDirections) {
    if (!r.flanks[d]) continue;
    for (const Interface i : kInterfaces) {
      const ThreadLives& t = r.flanks[d]->threads[i];
      const auto weaker = [&](double life) { return std::isfinite(life) && (!r.weakest || life < r.weakest->life); };
      std::optional<Part> body;
      if (t.rollers) body = body_of(i);
      for (std::size_t k = 0; k < t.life.size(); ++k)
        if (weaker(t.life[k])) r.weakest = WeakestThread{d, i, k, body, {}, t.equivalent_load[k], t.life[k]};
      if (!t.rollers) continue;
      for (std::size_t k = 0; k < t.rollers->life.size(); ++k)
        if (weaker(t.rollers->life[k]))
          r.weakest = WeakestThread{d,
                                    i,
                                    k % t.life.size(),
                                    Part::roller,
                                    k / t.life.size(),
                                    t.rollers->equivalent_load[k],
                                    t.rollers->life[k]};
    }
  }
}

void warn_of_loads(LifeResult& r) {
  const std::string loads = r.life.history ? "life.history" : "life.spectrum";
  const auto add = [&](std::optional<Warning> warning, const std::string& path) {
    if (!warning) return;
    warning->path = path;
    r.warnings.push_back(std::move(*warning));
  };
  for (const Direction d : kDirections) {
    if (!r.flanks[d]) continue;
    const auto add_to_sense = [&](std::optional<Warning> warning) {
      if (!warning) return;
      warning->code += fmt::format("_in_{}", name(d));
      warning->what.insert(0, fmt::format("in {}, ", name(d)));
      add(std::move(warning), loads);
    };
    for (const Interface i : kInterfaces) {
      const std::optional<double> pressure = r.flanks[d]->peak_pressure[i];
      if (pressure) add_to_sense(static_pressure_warning(loads, i, *pressure, r.contacts));
      if (const auto& running = r.flanks[d]->running_peak_pressure[i])
        add_to_sense(running_pressure_warning(loads, i, *running, r.contacts));
    }
    if (const auto& rating = r.flanks[d]->static_rating)
      add_to_sense(beyond_static_rating(r.flanks[d]->largest_force, *rating));
    const std::optional<double> capacity =
        r.life.static_capacity ? r.life.static_capacity : r.flanks[d]->static_capacity;
    if (capacity && r.flanks[d]->flank_edge_load)
      add_to_sense(flank_edge_near("an ellipse", *r.flanks[d]->flank_edge_load, *capacity, r.flanks[d]->largest_force));
  }
  add(beyond_life_formula(r.mean_load, r.dynamic_capacity), loads);
  const std::optional<double> static_capacity =
      r.life.static_capacity ? r.life.static_capacity : r.equal_shares_static_capacity;
  if (static_capacity)
    add(dynamic_above_static(r.dynamic_capacity, *static_capacity, r.life.static_capacity.has_value()),
        r.life.dynamic_capacity ? "life.dynamic_capacity" : "mechanism.profile");
}

}  // namespace

const FlankLife* LifeResult::statically_weakest() const {
  const FlankLife* flank = nullptr;
  for (const Direction d : kDirections)
    if (flanks[d] && flanks[d]->static_safety() && (!flank || *flanks[d]->static_safety() < *flank->static_safety()))
      flank = &*flanks[d];
  return flank;
}

std::optional<double> LifeResult::static_safety() const {
  const FlankLife* flank = statically_weakest();
  return flank ? flank->static_safety() : std::nullopt;
}

std::optional<double> LifeResult::bearing_life() const {
  if (!bearing || !bearing->life) return std::nullopt;
  return *bearing->life * revolutions / bearing->revolutions;
}

std::optional<double> LifeResult::life_with_bearings() const {
  const std::optional<double> own = bearing_life();
  if (!own) return std::nullopt;
  const double lives[] = {screw_life(), *own};
  return combined_life(lives);
}

std::optional<StaticLimit> LifeResult::static_safety_limit() const {
  const FlankLife* flank = statically_weakest();
  return flank ? std::optional(flank->static_rating->limit) : std::nullopt;
}

StaticForces solved_static_forces(const Conditions& c, const Contacts& contacts, Direction direction, double position,
                                  double force) {
  Conditions own = c;
  if (!own.life) own.life.emplace();
  own.life->share = LoadCase::Share::solved;
  own.life->position = position;
  const LifeModel p{own, contacts, contact_laws(own, contacts)};
  PerDirection<bool> wanted{};
  wanted[direction] = true;
  FlankLife flank;
  flank.largest_force = force;
  find_static_loads(p, largest_solver(p, direction, contact_solvers(p, wanted)[direction], {}), flank);
  return {flank.static_rating, flank.flank_edge_load};
}

LifeResult analyze_life(const Conditions& c, Contacts contacts, std::optional<LoadHistory> history,
                        const std::optional<Oils>& oils) {
  LifeResult r;
  r.life = *c.life;
  r.model = c.model;
  if (life_takes_running_loads(c)) r.loads = ModelOptions::Loads::running;
  r.contacts = std::move(contacts);
  r.warnings = geometry_warnings(c, r.contacts, {});
  r.history = std::move(history);
  const LifeModel p{c, r.contacts, contact_laws(c, r.contacts), oils};

  find_capacity(p, r);
  find_spectrum(c, r);
  if (c.bearings) r.bearing = bearing_life(c.bearings->fixed, r);
  if (r.history) {
    LoadCycles cycles;
    cycles.cycles = rainflow(r.history->force, r.life.history->hysteresis);
    cycles.matrix = cycle_matrix(cycles.cycles, r.life.history->bins);
    cycles.equivalent_range = equivalent_range(cycles.cycles, r.life.fatigue_slope);
    r.cycles = std::move(cycles);
  }

  find_lives(p, r);
  if (r.failure) return r;
  find_equal_shares_static_loads(p, r);
  r.catalogue_life = rating_life(r.dynamic_capacity, r.mean_load);
  std::vector<double> equal, real, at_rest;
  for (const Direction d : kDirections)
    if (r.flanks[d]) {
      equal.push_back(rating_life(r.dynamic_capacity, r.flanks[d]->mean_load));
      real.push_back(r.flanks[d]->life);
      at_rest.push_back(r.flanks[d]->life_at_rest);
    }
  r.equal_shares_life = combined_life(equal);
  r.system_life = combined_life(real);
  if (p.running()) r.life_at_rest = combined_life(at_rest);
  find_weakest(r);
  warn_of_loads(r);
  return r;
}

}  // namespace prs
