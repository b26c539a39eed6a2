#include "prs/life/contact_loads.h"

#include <numeric>

#include "prs/life/rating_life.h"
#include "prs/slip/running.h"

namespace prs {
namespace {

constexpr std::size_t kNodes = ShareCurve::kNodes;
/// Number of halvings down to the narrowest panels: a kink costs that many.
constexpr int kMostHalvings = 22;
/// Places at which a panel is checked, between its nodes on [-1, 1].
constexpr double kChecks[] = {-0.96, -0.55, 0.19, 0.75};

/// Chebyshev points of the second kind on [-1, 1], ends included.
std::array<double, kNodes> chebyshev_points() {
  std::array<double, kNodes> points{};
  for (std::size_t j = 0; j < kNodes; ++j)
    points[j] = 2 * j + 1 == kNodes ? 0.0 : -std::cos(std::numbers::pi * static_cast<double>(j) / (kNodes - 1));
  return points;
}

/// Lagrange polynomials of these points at t, by the barycentric formula (Berrut & Trefethen 2004).
std::array<double, kNodes> lagrange(double t) {
  static const std::array<double, kNodes> kPoints = chebyshev_points();
  std::array<double, kNodes> l{};
  double sum = 0.0;
  for (std::size_t j = 0; j < kNodes; ++j) {
    const double distance = t - kPoints[j];
    if (distance == 0.0) {
      l.fill(0.0);
      l[j] = 1.0;
      return l;
    }
    const double end = j == 0 || j == kNodes - 1 ? 0.5 : 1.0;
    l[j] = (j % 2 == 0 ? end : -end) / distance;
    sum += l[j];
  }
  for (double& value : l) value /= sum;
  return l;
}

double cube(double x) { return x * x * x; }

/// Error of the interpolated shares and of their cubes against the solved ones, relative to the largest.
double interpolation_error(std::span<const std::vector<double>> nodes, double t, std::span<const double> solved) {
  const std::array<double, kNodes> weights = lagrange(t);
  double largest = 0.0, of_shares = 0.0, of_cubes = 0.0;
  for (std::size_t k = 0; k < solved.size(); ++k) {
    double share = 0.0, cubed = 0.0;
    for (std::size_t j = 0; j < kNodes; ++j) {
      share += weights[j] * nodes[j][k];
      cubed += weights[j] * cube(nodes[j][k]);
    }
    largest = std::max(largest, solved[k]);
    of_shares = std::max(of_shares, std::abs(share - solved[k]));
    of_cubes = std::max(of_cubes, std::abs(cubed - cube(solved[k])));
  }
  return std::max(of_shares / largest, of_cubes / cube(largest));
}

}  // namespace

ShareCurve::ShareCurve(const Solve& solve, double least, double greatest, Accuracy accuracy)
    : accuracy_(std::move(accuracy)) {
  const Panel all{std::cbrt(least), std::cbrt(greatest)};
  if (least < greatest) {
    refine(solve, all, 0);
  } else if (const auto shares = solve_at(solve, all.from)) {
    panels_.push_back(all);
    nodes_.assign(kNodes, *shares);
  }
  shared_.clear();
}

ShareCurve::ShareCurve(const Solve& solve, const std::set<double>& forces) {
  for (const double force : forces) {
    const double x = std::cbrt(force);
    const auto shares = solve_at(solve, x);
    if (!shares) return;
    panels_.push_back({x, x});
    nodes_.insert(nodes_.end(), kNodes, *shares);
  }
}

std::optional<std::vector<double>> ShareCurve::solve_at(const Solve& solve, double x) {
  ++solves_;
  std::optional<std::vector<double>> shares = solve(cube(x));
  if (!shares) failed_at_ = cube(x);
  return shares;
}

void ShareCurve::refine(const Solve& solve, Panel panel, int depth) {
  const double middle = 0.5 * (panel.from + panel.to);
  const auto at = [&](double t) {
    return t == -1.0 ? panel.from : t == 1.0 ? panel.to : middle + 0.5 * t * (panel.to - panel.from);
  };
  std::vector<std::vector<double>> nodes;
  for (const double t : chebyshev_points()) {
    const double x = at(t);
    const auto known = shared_.find(x);
    std::optional<std::vector<double>> shares =
        known != shared_.end() ? std::optional(known->second) : solve_at(solve, x);
    if (!shares) return;
    if (x == panel.from || x == middle || x == panel.to) shared_.emplace(x, *shares);
    nodes.push_back(std::move(*shares));
  }
  const double weight =
      accuracy_.weight ? std::max(accuracy_.weight(cube(panel.from), cube(panel.to)), accuracy_.tolerance / kWorstError)
                       : 1.0;
  double error = 0.0;
  for (const double t : kChecks) {
    const std::optional<std::vector<double>> shares = solve_at(solve, at(t));
    if (!shares) return;
    error = std::max(error, weight * interpolation_error(nodes, t, *shares));
    if (error > accuracy_.tolerance) break;
  }
  if (error > accuracy_.tolerance && depth < kMostHalvings) {
    refine(solve, {panel.from, middle}, depth + 1);
    if (!failed_at_) refine(solve, {middle, panel.to}, depth + 1);
    return;
  }
  error_ = std::max(error_, error);
  panels_.push_back(panel);
  std::ranges::move(nodes, std::back_inserter(nodes_));
}

ShareCurve::Place ShareCurve::place(double force) const {
  const double x = std::clamp(std::cbrt(force), panels_.front().from, panels_.back().to);
  const auto next = std::upper_bound(panels_.begin() + 1, panels_.end(), x,
                                     [](double value, const Panel& p) { return value < p.from; });
  const auto k = static_cast<std::size_t>(next - panels_.begin()) - 1;
  const Panel& panel = panels_[k];
  const double width = panel.to - panel.from;
  const double t = width > 0.0 ? (x - panel.from) / width * 2.0 - 1.0 : 0.0;
  return {k * kNodes, lagrange(t)};
}

void ShareCurve::shares_at(double force, std::span<double> shares) const {
  const Place p = place(force);
  std::ranges::fill(shares, 0.0);
  for (std::size_t j = 0; j < kNodes; ++j)
    for (std::size_t k = 0; k < shares.size(); ++k) shares[k] += p.weights[j] * nodes_[p.first + j][k];
}

namespace {

/// Solver in which every thread carries its equal share of the force on one flank.
ContactSolver equal_solver(const LifeModel& model, Direction d) {
  return [&model, d](double force) {
    const std::size_t n = model.rated().threads;
    ContactLoads loads;
    loads.rated.assign(model.rated().count(), 1.0);
    for (const Interface i : kInterfaces) loads.largest[d][i].assign(n, force * model.equal_share());
    return std::optional(std::move(loads));
  };
}

ContactSolver sector_solver(const LifeModel& model, Direction d) {
  return [&model, d,
          solve = body_solver(model.c).at_rest({{model.c, model.contacts, model.laws}, d, *model.c.life->position},
                                               Solver::chain)](double force) {
    const LoadDistribution solved = solve(force);
    if (!solved.solve.converged()) return std::optional<ContactLoads>();
    ContactLoads loads;
    for (const Interface i : kInterfaces)
      for (const double normal : solved.normal_load[i]) {
        const double axial = normal * std::cos(model.laws[i].normal_angle);
        loads.rated.push_back(axial / (force * model.equal_share()));
        loads.largest[d][i].push_back(axial);
      }
    return std::optional(std::move(loads));
  };
}

/// Solver of both flanks under a force of one sense.
ContactSolver preload_solver(const LifeModel& model, Direction d, std::shared_ptr<PreloadedMechanism> mechanism) {
  return [&model, d, mechanism = std::move(mechanism)](double force) {
    const PreloadPoint point = mechanism->solve(d == Direction::tension ? force : -force);
    if (!point.solve.converged()) return std::optional<ContactLoads>();
    ContactLoads loads;
    for (const Direction flank : kDirections) {
      const SideLoads& side = point.sides[flank];
      for (const Interface i : kInterfaces) {
        std::vector<double> axial = side.normal_load[i];
        axial.resize(model.rated().threads, 0.0);
        for (double& load : axial) load *= std::cos(model.laws[i].normal_angle);
        const double mean = side.axial_load[i];
        for (double& load : axial) {
          if (!model.solved()) load = mean * model.equal_share();
          loads.rated.push_back(load / model.equal_share());
        }
        loads.largest[flank][i] = std::move(axial);
      }
      loads.rated.push_back(side.axial_load.screw);
    }
    return std::optional(std::move(loads));
  };
}

/// The load case that acts together with all forces, or an empty one.
SpatialLoad spatial_load(const Conditions& c) {
  const auto named = [&](const LoadCase& load) {
    return load.share == LoadCase::Share::solved && (!c.life->load_case || load.name == *c.life->load_case);
  };
  const auto found = std::ranges::find_if(c.load_cases, named);
  return found == c.load_cases.end() ? SpatialLoad{} : found->spatial;
}

/// Load case for `life`, before its force is set.
LoadCase load_case_of(const Conditions& c, Direction d) {
  LoadCase load;
  load.direction = d;
  load.position = c.life->position;
  load.spatial = spatial_load(c);
  return load;
}
LoadCase load_case_of(const LifeModel& model, Direction d) { return load_case_of(model.c, d); }

/// The turn of the carrier over which loads are rated.
SpatialLoad::Orbit turn_of(const LoadCase& load) {
  SpatialLoad::Orbit turn = load.spatial.orbit.value_or(SpatialLoad::Orbit{});
  turn.exponent = kLifeExponent;
  return turn;
}

/// `ContactLoads::rated` over a turn under a force.
std::vector<double> rated_over(const LifeModel& model, const Orbit& orbit, double force) {
  const RatedContacts rated = model.rated();
  std::vector<double> loads(rated.count(), 0.0);
  for (const Interface i : kInterfaces) {
    const double per_mean = std::cos(model.laws[i].normal_angle) / (force * model.equal_share());
    for (std::size_t k = 0; k < rated.threads; ++k) {
      double cubes = 0.0;
      for (std::size_t j = 0; j < rated.rollers; ++j) {
        const double own = orbit.loads[i].equivalent[j][k];
        cubes += own * own * own;
        loads[rated.roller(i) + j * rated.threads + k] = per_mean * own;
      }
      loads[rated.body(i) + k] = per_mean * std::cbrt(cubes / static_cast<double>(rated.rollers));
    }
  }
  return loads;
}

/// Adds the largest loads of a turn of the carrier, and the carrier angle of each interface's largest.
void add_largest(const LifeModel& model, const Orbit& orbit, Direction d, ContactLoads& loads) {
  const RatedContacts rated = model.rated();
  for (const Interface i : kInterfaces) {
    const OrbitLoads& turned = orbit.loads[i];
    loads.carrier_angle[i] = turned.carrier_angle;
    const double axial = std::cos(model.laws[i].normal_angle);
    loads.largest[d][i].assign(rated.threads, 0.0);
    for (std::size_t k = 0; k < rated.threads; ++k)
      for (std::size_t j = 0; j < rated.rollers; ++j)
        loads.largest[d][i][k] = std::max(loads.largest[d][i][k], axial * turned.peak[j][k]);
  }
}

ContactSolver full_solver(const LifeModel& model, Direction d) {
  const LoadCase load = load_case_of(model, d);
  const SpatialLoad::Orbit turn = turn_of(load);
  const auto solver = std::make_shared<FullSolver>();
  return [&model, d, load, turn, solver](double force) {
    LoadCase at = load;
    at.axial_force = force;
    const Orbit orbit = full_orbit(at, model.c, model.contacts, model.laws, *solver, turn);
    if (!orbit.converged()) return std::optional<ContactLoads>();
    ContactLoads loads;
    loads.rated = rated_over(model, orbit, force);
    add_largest(model, orbit, d, loads);
    return std::optional(std::move(loads));
  };
}

}  // namespace

RatedContacts LifeModel::rated() const {
  const Mechanism& m = contacts.mechanism;
  return {static_cast<std::size_t>(m.contacts_per_roller), full() ? static_cast<std::size_t>(m.rollers) : 0,
          preloaded()};
}

bool LifeModel::is_loaded_across() const { return full() && spatial_load(c).acts_across(); }

double LifeModel::equal_share() const {
  const Mechanism& m = contacts.mechanism;
  return 1.0 / (static_cast<double>(loaded_rollers(m)) * static_cast<double>(m.contacts_per_roller));
}

LargestSolver largest_solver(const LifeModel& model, Direction d, const ContactSolver& solver, const ContactLoads& at) {
  if (!model.full())
    return [d, solver](double force) {
      std::optional<ContactLoads> loads = solver(force);
      if (!loads) return std::optional<LargestLoads>();
      LargestLoads& largest = loads->largest[d];
      for (const Interface i : kInterfaces) {  // With preload the other flank is loaded too.
        const std::vector<double>& other = loads->largest[opposite(d)][i];
        for (std::size_t k = 0; k < other.size(); ++k) largest[i][k] = std::max(largest[i][k], other[k]);
      }
      return std::optional(std::move(largest));
    };
  std::vector<double> angles = {at.carrier_angle.screw};
  if (at.carrier_angle.nut != at.carrier_angle.screw) angles.push_back(at.carrier_angle.nut);
  const auto solver_of_all = std::make_shared<FullSolver>();
  return [&model, load = load_case_of(model, d), angles, solver_of_all](double force) {
    LoadCase there = load;
    there.axial_force = force;
    LargestLoads largest;
    for (const Interface i : kInterfaces) largest[i].assign(model.rated().threads, 0.0);
    for (const double angle : angles) {
      there.spatial.carrier_angle = angle;
      there.travel.reset();  // In an orbit only the carrier turns.
      const FullDistribution solved =
          full_distribution(there, model.c, model.contacts, model.laws, *solver_of_all, Detail::numbers);
      if (!solved.solve.converged()) return std::optional<LargestLoads>();
      for (const Interface i : kInterfaces)
        for (const std::vector<double>& roller : solved.normal_load[i])
          for (std::size_t k = 0; k < roller.size(); ++k)
            largest[i][k] = std::max(largest[i][k], roller[k] * std::cos(model.laws[i].normal_angle));
    }
    return std::optional(std::move(largest));
  };
}

std::string why_not_held(const LifeModel& model, Direction d, double force) {
  if (!model.full()) return {};
  LoadCase load = load_case_of(model, d);
  load.axial_force = force;
  FullSolver solver;
  const Orbit orbit =
      full_orbit(load, model.c, model.contacts, model.laws, solver, load.spatial.orbit.value_or(SpatialLoad::Orbit{}));
  return orbit.converged() ? std::string() : text(*orbit.failure);
}

PerDirection<ContactSolver> contact_solvers(const LifeModel& model, const PerDirection<bool>& wanted) {
  std::shared_ptr<PreloadedMechanism> preloaded;
  if (model.preloaded()) {
    const auto sectors_at = [&](double position) {
      return preload_sectors(model.c, model.contacts, model.laws, position);
    };
    const double position = model.c.preload->position;
    const Fit fit = preload_fit(model.c, model.contacts, sectors_at(position));
    preloaded = std::make_shared<PreloadedMechanism>(sectors_at(model.c.life->position.value_or(position)), fit);
  }
  PerDirection<ContactSolver> solvers;
  for (const Direction d : kDirections)
    if (wanted[d])
      solvers[d] = preloaded         ? preload_solver(model, d, preloaded)
                   : !model.solved() ? equal_solver(model, d)
                   : model.full()    ? full_solver(model, d)
                                     : sector_solver(model, d);
  return solvers;
}

LoadCase driven_load_case(const Conditions& c, double lead, Direction d, DrivenBy driven_by) {
  LoadCase load = load_case_of(c, d);
  // F_N omega l > 0: the screw drives.
  load.speed =
      std::abs(c.operation->speed) * -sense(d) * std::copysign(1.0, lead) * (driven_by == DrivenBy::screw ? 1.0 : -1.0);
  return load;
}

ContactSolver running_loads_solver(const LifeModel& model, Direction d, DrivenBy driven_by) {
  const auto models =
      std::make_shared<SlipModels>(model.c, model.contacts, model.oils ? *model.oils : oils_in_operation(model.c));
  const auto running = std::make_shared<RunningSolver>(model.c, model.contacts, *models);
  const LoadCase load = driven_load_case(model.c, model.contacts.threads.screw.lead, d, driven_by);
  return [&model, d, load, models, running](double force) -> std::optional<ContactLoads> {
    LoadCase at = load;
    at.axial_force = force;
    ContactLoads loads;
    if (model.full()) {
      const Orbit orbit = running->turned(at, turn_of(at));
      if (!orbit.converged()) return std::nullopt;
      loads.rated = rated_over(model, orbit, force);
      add_largest(model, orbit, d, loads);
      return loads;
    }
    std::optional<SlipEquilibrium> slip;
    const LoadCaseResult found = running->solve(at, Detail::numbers, slip);
    if (!found.threads) return std::nullopt;
    const double per_load = model.equal_share() * (model.preloaded() ? 1.0 : force);
    for (const Direction flank : kDirections) {
      const bool named = flank == d;
      if (!named && !model.preloaded()) continue;
      for (const Interface i : kInterfaces)
        for (const double normal :
             named ? (*found.threads)[i].normal_load : found.other_flank->threads[i].normal_load) {
          const double axial = normal * std::cos(model.laws[i].normal_angle);
          loads.largest[flank][i].push_back(axial);
          loads.rated.push_back(axial / per_load);
        }
      if (!model.preloaded()) continue;
      const std::vector<double>& axial =
          named ? found.threads->screw.axial_load : found.other_flank->threads.screw.axial_load;
      loads.rated.push_back(loaded_rollers(model.contacts.mechanism) *
                            std::accumulate(axial.begin(), axial.end(), 0.0));
    }
    return loads;
  };
}

}  // namespace prs
