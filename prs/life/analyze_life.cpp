#include "prs/life/analyze_life.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "prs/life/share_curve.h"
#include "prs/loads/distribution_solver.h"
#include "prs/loads/load_case_result.h"
#include "prs/model/case_error.h"
#include "prs/threads/contact_laws.h"
#include "prs/threads/geometry_warnings.h"

namespace prs {
namespace {

/// Loads below this share of the largest have its shares: a million of them weigh 1e-9 of it.
constexpr double kLeastLoad = 1e-5;

/// A case with its threads and how they push.
struct Prepared {
  const Conditions& c;
  const Contacts& contacts;
  PerInterface<ContactLaw> laws;

  std::size_t threads() const {
    return static_cast<std::size_t>(contacts.mechanism.contacts_per_roller);
  }
  /// Axial load of a thread with equal shares per axial force.
  double equal_share() const {
    return 1.0 / (static_cast<double>(contacts.mechanism.rollers) * static_cast<double>(threads()));
  }
};

bool solves(const Conditions& c) { return c.life->share == LoadCase::Share::solved; }

/// Shares of all threads, screw before nut: 1 where all carry the same.
ShareCurve::Solve share_solver(const Prepared& p, Direction d) {
  const std::size_t n = p.threads();
  if (!solves(p.c)) return [n](double) { return std::vector<double>(2 * n, 1.0); };
  DistributionSolver solver =
      distribution_solver(p.c, p.contacts, p.laws, d, *p.c.life->position, Solver::chain);
  return [&p, n, solve = std::move(solver)](double force) -> std::optional<std::vector<double>> {
    const LoadDistribution loads = solve(force);
    if (!loads.solve.converged()) return std::nullopt;
    std::vector<double> shares;
    shares.reserve(2 * n);
    for (const Interface i : kInterfaces)
      for (const double normal : loads.normal_load[i])
        shares.push_back(normal * std::cos(p.laws[i].normal_angle) / (force * p.equal_share()));
    return shares;
  };
}

void find_capacity(const Prepared& p, LifeResult& r) {
  const double angle = contact_angle({p.laws.screw.normal_angle, p.laws.nut.normal_angle});
  const LemorGeometry g = lemor_geometry(p.contacts.mechanism, angle);
  r.element_ratio = g.roller_diameter * std::cos(angle) / g.pitch_circle;
  r.failure_shares = failure_shares(r.element_ratio);
  if (p.c.life->dynamic_capacity) {
    r.dynamic_capacity = *p.c.life->dynamic_capacity;
    r.dynamic_capacity_range = {r.dynamic_capacity, r.dynamic_capacity};
    return;
  }
  r.lemor = lemor_capacity(g);
  if (!r.lemor)
    throw CaseError(
        "mechanism.pitch_diameter.roller",
        fmt::format("gives the ratio d_r cos(alpha)/d_nut = {:.4f}; expected {} to {}, where the "
                    "factor of Lemor's capacity is known; give the capacity of a catalogue, for "
                    "example `life: {{dynamic_capacity: 60 kN, ..}}`",
                    factor_ratio(g), kFactorRatios.least, kFactorRatios.greatest));
  r.dynamic_capacity = r.lemor->capacity;
  r.dynamic_capacity_range = r.lemor->capacity_range;
  if (const auto note = beside_lemor_angle(angle))
    r.warnings.push_back(fmt::format("mechanism.flank_angle: {}", *note));
}

void find_spectrum(const Conditions& c, LifeResult& r) {
  const std::optional<double> speed =
      c.operation ? std::optional(std::abs(c.operation->speed)) : std::nullopt;
  const double lead = r.contacts.mechanism.lead;
  if (r.history) {
    r.steps = load_steps(*r.history, lead, speed);
    r.duration = duration(*r.history);
  } else {
    r.steps = load_steps(c.life->spectrum, lead, speed);
    r.revolutions_known = !c.life->spectrum.front().share;
    double seconds = 0.0;
    for (const SpectrumLoad& l : c.life->spectrum)
      seconds += l.duration.value_or(std::numeric_limits<double>::quiet_NaN());
    if (std::isfinite(seconds)) r.duration = seconds;
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
  if (!(r.largest_force > 0.0))
    throw CaseError(path,
                    "got no load other than 0; expected loads; check the column of the force");
  if (r.duration && *r.duration > 0.0)
    r.revolution_rate = r.revolutions / *r.duration;
  else if (speed && *speed > 0.0)
    r.revolution_rate = *speed / (2.0 * std::numbers::pi);
}

/// sum F^3 l^3 n of each thread, on equilibria alone: an interpolated cube of a share is a sum over
/// nodes, so that the weights of all loads are first gathered there.
class CubicSums {
 public:
  CubicSums(const ShareCurve& curve, std::size_t threads)
      : curve_(curve), weights_(curve.node_count(), 0.0), sums_(threads, 0.0) {}

  void add(double force, double revolutions) {
    const ShareCurve::Place place = curve_.place(force);
    const double weight = force * force * force * revolutions;
    for (std::size_t j = 0; j < ShareCurve::kNodes; ++j)
      weights_[place.first + j] += weight * place.weights[j];
  }

  std::vector<double> take() && {
    for (std::size_t node = 0; node < weights_.size(); ++node)
      for (std::size_t k = 0; k < sums_.size(); ++k) {
        const double share = curve_.shares(node)[k];
        sums_[k] += weights_[node] * share * share * share;
      }
    return std::move(sums_);
  }

 private:
  const ShareCurve& curve_;
  std::vector<double> weights_, sums_;
};

/// Magnitude of a force along a direction [N]; 0 where it has the other sense.
double along(double axial_force, Direction d) {
  return std::max(0.0, d == Direction::tension ? axial_force : -axial_force);
}

bool has_pressures(const Contacts& contacts) {
  return contacts.interfaces.screw.has_hertz() && contacts.interfaces.nut.has_hertz();
}

/// Largest normal load of the threads of an interface under an axial force [N].
double largest_normal_load(const Prepared& p, Interface i, std::span<const double> shares,
                           double force) {
  const auto first = shares.begin() + (i == Interface::screw ? 0 : std::ssize(shares) / 2);
  const double share = *std::max_element(first, first + std::ssize(shares) / 2);
  return share * force * p.equal_share() / std::cos(p.laws[i].normal_angle);
}

/// Largest peak pressure of the threads of an interface under an axial force [Pa].
double peak_pressure(const Prepared& p, Interface i, std::span<const double> shares, double force) {
  return contact::at_load(p.contacts.interfaces[i].hertz, largest_normal_load(p, i, shares, force))
      .peak_pressure;
}

/// Force at which the most loaded thread of one interface reaches its normal load: that load is
/// nearly proportional to the force, so F N_limit/N converges in a few steps.
std::optional<double> force_at(const Prepared& p, const ShareCurve::Solve& solve, double force,
                               const PerInterface<std::optional<double>>& limit) {
  if (!limit.screw && !limit.nut) return std::nullopt;
  for (int step = 0; step < 60; ++step) {
    const auto shares = solve(force);
    if (!shares) return std::nullopt;
    double used = 0.0;
    for (const Interface i : kInterfaces)
      if (limit[i]) used = std::max(used, largest_normal_load(p, i, *shares, force) / *limit[i]);
    const double next = force / used;
    if (std::abs(next - force) < 1e-10 * force) return next;
    force = next;
  }
  return std::nullopt;
}

void find_static_loads(const Prepared& p, const ShareCurve::Solve& solve, FlankLife& flank) {
  PerInterface<std::optional<double>> pressure, deformation, edge;
  bool deforms_first = false;
  for (const Interface i : kInterfaces) {
    const StaticLimits limits = static_limits(p.contacts, i);
    pressure[i] = limits.pressure;
    deformation[i] = limits.deformation;
    edge[i] = limits.flank_edge;
    deforms_first = deforms_first || (limits.deformation && *limits.deformation < *limits.pressure);
  }
  StaticLimits forces;
  if (has_pressures(p.contacts)) {
    forces.pressure = flank.static_capacity = force_at(p, solve, flank.largest_force, pressure);
    forces.flank_edge = flank.flank_edge_load = force_at(p, solve, flank.largest_force, edge);
    if (deforms_first) forces.deformation = force_at(p, solve, flank.largest_force, deformation);
  }
  flank.static_rating = static_rating(forces, p.c.life->static_capacity);
}

void find_equal_shares_static_loads(const Prepared& p, LifeResult& r) {
  if (!has_pressures(p.contacts)) return;
  double pressure = std::numeric_limits<double>::infinity(), edge = pressure;
  for (const Interface i : kInterfaces) {
    const StaticLimits limits = static_limits(p.contacts, i);
    const double per_normal_load = std::cos(p.laws[i].normal_angle) / p.equal_share();
    pressure = std::min(pressure, *limits.pressure * per_normal_load);
    edge = std::min(edge, *limits.flank_edge * per_normal_load);
  }
  r.equal_shares_static_capacity = pressure;
  r.equal_shares_flank_edge_load = edge;
}

void require_thrust(const Conditions& c, Direction d) {
  if (!solves(c)) return;
  const Structure::Thrust& thrust = c.structure->nut.thrust;
  if (d == Direction::tension ? thrust.tension : thrust.compression) return;
  throw CaseError(fmt::format("structure.nut.thrust.{}", name(d)),
                  fmt::format("missing; expected the axial position of the section that holds {}, "
                              "which the loads of `life` contain; add `{}: 10 mm`, for example",
                              name(d), name(d)));
}

/// Equivalent ranges of the threads' loads on the flanks of one direction over the cycles.
std::vector<double> equivalent_ranges(const ShareCurve& curve, std::span<const Cycle> cycles,
                                      Direction d, double slope, std::size_t threads) {
  std::vector<double> high(threads), low(threads), damage(threads, 0.0);
  double scale = 0.0;
  for (const Cycle& c : cycles)
    scale = std::max({scale, along(c.start.value, d), along(c.end.value, d)});
  for (const Cycle& c : cycles) {
    const double a = along(c.start.value, d), b = along(c.end.value, d);
    if (a == 0.0 && b == 0.0) continue;
    curve.shares_at(std::max(a, b), high);
    curve.shares_at(std::min(a, b), low);
    for (std::size_t k = 0; k < threads; ++k) {
      const double range = high[k] * std::max(a, b) - low[k] * std::min(a, b);
      damage[k] += c.count * std::pow(std::abs(range) / scale, slope);
    }
  }
  const double total = count(cycles);
  for (double& d_k : damage) d_k = total > 0.0 ? scale * std::pow(d_k / total, 1.0 / slope) : 0.0;
  return damage;
}

/// The part of a list of all threads that belongs to an interface, times a factor.
std::vector<double> part_of(std::span<const double> all, Interface i, double factor) {
  const std::size_t n = all.size() / 2;
  std::vector<double> part;
  for (const double value : all.subspan(i == Interface::screw ? 0 : n, n))
    part.push_back(value * factor);
  return part;
}

void find_lives(const Prepared& p, LifeResult& r, Direction d) {
  FlankLife flank;
  double least = std::numeric_limits<double>::infinity();
  double running_force = 0.0, damage = 0.0;
  for (const LoadStep& s : r.steps) {
    const double force = along(s.axial_force, d);
    if (force == 0.0) continue;
    flank.revolutions += s.revolutions;
    flank.largest_force = std::max(flank.largest_force, force);
    if (s.revolutions > 0.0) running_force = std::max(running_force, force);
    least = std::min(least, force);
    damage += force * force * force * s.revolutions;
  }
  if (flank.largest_force == 0.0) return;
  require_thrust(p.c, d);
  flank.mean_load = std::cbrt(damage / r.revolutions);

  const std::size_t threads = 2 * p.threads();
  const ShareCurve::Solve solve = share_solver(p, d);
  const ShareCurve curve(solve, std::max(least, kLeastLoad * flank.largest_force),
                         flank.largest_force);
  flank.solves = curve.solves();
  flank.interpolation_error = curve.error();
  if (curve.failed_at()) {
    r.failure = fmt::format("the load distribution under {:.6g} N in {} did not converge",
                            *curve.failed_at(), name(d));
    return;
  }

  CubicSums sums(curve, threads);
  for (const LoadStep& s : r.steps)
    if (const double force = along(s.axial_force, d); force > 0.0 && s.revolutions > 0.0)
      sums.add(force, s.revolutions);
  std::vector<double> equivalent = std::move(sums).take();
  for (double& f : equivalent) f = std::cbrt(std::max(f, 0.0) / r.revolutions);
  std::vector<double> ranges;
  if (r.cycles)
    ranges = equivalent_ranges(curve, r.cycles->cycles, d, p.c.life->fatigue_slope, threads);
  std::vector<double> largest(threads);
  curve.shares_at(flank.largest_force, largest);
  std::vector<double> largest_running(threads);
  if (running_force > 0.0) curve.shares_at(running_force, largest_running);

  std::vector<double> lives;
  for (const Interface i : kInterfaces) {
    ThreadLives& t = flank.threads[i];
    for (const double load : part_of(equivalent, i, 1.0))
      t.life.push_back(thread_life(r.dynamic_capacity, load, r.failure_shares[i],
                                   p.contacts.mechanism.contacts_per_roller));
    lives.insert(lives.end(), t.life.begin(), t.life.end());
    t.equivalent_load = part_of(equivalent, i, p.equal_share());
    t.largest_load = part_of(largest, i, flank.largest_force * p.equal_share());
    if (!ranges.empty()) t.equivalent_range = part_of(ranges, i, p.equal_share());
    if (!p.contacts.interfaces[i].has_hertz()) continue;
    flank.peak_pressure[i] = peak_pressure(p, i, largest, flank.largest_force);
    if (running_force > 0.0)
      flank.running_peak_pressure[i] = peak_pressure(p, i, largest_running, running_force);
  }
  flank.life = combined_life(lives);
  find_static_loads(p, solve, flank);
  r.flanks[d] = std::move(flank);
}

void find_weakest(LifeResult& r) {
  for (const Direction d : kDirections) {
    if (!r.flanks[d]) continue;
    for (const Interface i : kInterfaces) {
      const ThreadLives& t = r.flanks[d]->threads[i];
      for (std::size_t k = 0; k < t.life.size(); ++k)
        if (std::isfinite(t.life[k]) && (!r.weakest || t.life[k] < r.weakest->life))
          r.weakest = WeakestThread{d, i, k, t.equivalent_load[k], t.life[k]};
    }
  }
}

void warn_of_flank_edge(const std::optional<double>& edge, const std::optional<double>& capacity,
                        Direction d, std::vector<std::string>& warnings) {
  if (edge && capacity && *edge < *capacity)
    warnings.push_back(fmt::format(
        "mechanism.profile: in {}, an ellipse reaches the end of a flank at {:.4g} kN, below the "
        "static capacity of "
        "{:.4g} kN; static safety takes the smaller; lower the profile radius or take a coarser "
        "pitch",
        name(d), *edge * 1e-3, *capacity * 1e-3));
}

void warn_of_loads(LifeResult& r) {
  const std::string_view loads = r.life.history ? "life.history" : "life.spectrum";
  for (const Direction d : kDirections) {
    if (!r.flanks[d]) continue;
    for (const Interface i : kInterfaces) {
      const std::optional<double> pressure = r.flanks[d]->peak_pressure[i];
      if (pressure && *pressure > kStaticPressureLimit)
        r.warnings.push_back(fmt::format("{}: {} peak pressure {:.2f} GPa in {} exceeds {:.1f} GPa",
                                         loads, label(i), *pressure * 1e-9, name(d),
                                         kStaticPressureLimit * 1e-9));
      if (const auto& running = r.flanks[d]->running_peak_pressure[i])
        if (const auto note = running_pressure_note(i, *running))
          r.warnings.push_back(fmt::format("{}: in {}, {}", loads, name(d), *note));
    }
    if (const auto& rating = r.flanks[d]->static_rating)
      if (const auto note = beyond_static_rating(r.flanks[d]->largest_force, *rating))
        r.warnings.push_back(fmt::format("{}: in {}, {}", loads, name(d), *note));
    warn_of_flank_edge(
        r.flanks[d]->flank_edge_load,
        r.life.static_capacity ? r.life.static_capacity : r.flanks[d]->static_capacity, d,
        r.warnings);
  }
  if (const auto note = beyond_life_formula(r.mean_load, r.dynamic_capacity))
    r.warnings.push_back(fmt::format("{}: {}", loads, *note));
  const std::optional<double> static_capacity =
      r.life.static_capacity ? r.life.static_capacity : r.equal_shares_static_capacity;
  if (static_capacity)
    if (const auto note = dynamic_above_static(r.dynamic_capacity, *static_capacity))
      r.warnings.push_back(fmt::format(
          "{}: {}", r.life.dynamic_capacity ? "life.dynamic_capacity" : "mechanism.profile",
          *note));
}

}  // namespace

const FlankLife* LifeResult::statically_weakest() const {
  const FlankLife* flank = nullptr;
  for (const Direction d : kDirections)
    if (flanks[d] && flanks[d]->static_safety() &&
        (!flank || *flanks[d]->static_safety() < *flank->static_safety()))
      flank = &*flanks[d];
  return flank;
}

std::optional<double> LifeResult::static_safety() const {
  const FlankLife* flank = statically_weakest();
  return flank ? flank->static_safety() : std::nullopt;
}

std::optional<StaticLimit> LifeResult::static_safety_limit() const {
  const FlankLife* flank = statically_weakest();
  return flank ? std::optional(flank->static_rating->limit) : std::nullopt;
}

LifeResult analyze_life(const Conditions& c, Contacts contacts,
                        std::optional<LoadHistory> history) {
  LifeResult r;
  r.life = *c.life;
  r.model = c.model;
  r.contacts = std::move(contacts);
  r.warnings = geometry_warnings(c, r.contacts, {});
  r.history = std::move(history);
  const Prepared p{c, r.contacts, contact_laws(c, r.contacts)};

  find_capacity(p, r);
  find_spectrum(c, r);
  if (r.history) {
    LoadCycles cycles;
    cycles.cycles = rainflow(r.history->force, r.life.history->hysteresis);
    cycles.matrix = cycle_matrix(cycles.cycles, r.life.history->bins);
    cycles.equivalent_range = equivalent_range(cycles.cycles, r.life.fatigue_slope);
    r.cycles = std::move(cycles);
  }

  for (const Direction d : kDirections) {
    find_lives(p, r, d);
    if (r.failure) return r;
  }
  find_equal_shares_static_loads(p, r);
  r.catalogue_life = rating_life(r.dynamic_capacity, r.mean_load);
  std::vector<double> equal, real;
  for (const Direction d : kDirections)
    if (r.flanks[d]) {
      equal.push_back(rating_life(r.dynamic_capacity, r.flanks[d]->mean_load));
      real.push_back(r.flanks[d]->life);
    }
  r.equal_shares_life = combined_life(equal);
  r.system_life = combined_life(real);
  find_weakest(r);
  warn_of_loads(r);
  return r;
}

}  // namespace prs
