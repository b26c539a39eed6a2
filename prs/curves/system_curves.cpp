#include "prs/curves/system_curves.h"

#include <fmt/ranges.h>

#include <atomic>
#include <deque>

#include "prs/heat/analyze_heat.h"
#include "prs/indices.h"
#include "prs/model/check_case.h"
#include "prs/model/quantity_text.h"
#include "prs/side_by_side.h"
#include "prs/slip/running.h"
#include "prs/threads/geometry_warnings.h"

namespace prs {
namespace {

/// Errors of a curve between its nodes.
struct Errors {
  double force = 0.0, stiffness = 0.0;

  /// The larger of both errors, over its tolerance.
  double share() const { return std::max(force / kForceTolerance, stiffness / kStiffnessTolerance); }
  void take(const Errors& other) {
    force = std::max(force, other.force);
    stiffness = std::max(stiffness, other.stiffness);
  }
};

/// An equilibrium of one sense, in magnitudes.
struct Node {
  double force = 0.0;       ///< [N]
  double deflection = 0.0;  ///< [m]
  double stiffness = 0.0;   ///< dF/du [N/m]
  bool is_open = false;     ///< Whether the interval from here to the next node still needs a check.
  Errors missed = {};       ///< Errors of the curve in it at the last check.
};

/// Equilibria under forces of one sense, in their order.
using Solve = std::function<std::vector<Node>(const std::vector<double>& forces)>;

BranchTable table_of(const std::vector<Node>& nodes, double origin, bool over_root) {
  BranchTable table{origin, over_root, {}, {}, {}};
  for (const Node& node : nodes) {
    const double way = node.deflection - origin;
    const double at = over_root ? std::sqrt(way) : way;
    table.at.push_back(at);
    table.force.push_back(node.force);
    table.slope.push_back(over_root ? 2.0 * at * node.stiffness : node.stiffness);
  }
  return table;
}

/// Limits slopes so that no cubic between two nodes falls (Fritsch and Carlson, SIAM J. Numer. Anal. 17, 1980, 238).
void keep_monotone(BranchTable& table) {
  for (std::size_t k = 0; k + 1 < table.at.size(); ++k) {
    const double secant = (table.force[k + 1] - table.force[k]) / (table.at[k + 1] - table.at[k]);
    for (double* slope : {&table.slope[k], &table.slope[k + 1]}) *slope = std::clamp(*slope, 0.0, 3.0 * secant);
  }
}

PrsCurves in_tension(const BranchTable& table) {
  PrsCurves curves{};
  curves.tension = table.view();
  return curves;
}

/// Place where an interval is checked and divided: there the slope of a cubic has the largest error, as t^2 (1 - t)^2
/// is steepest.
constexpr double kPlace = 0.2113248654051871;

/// Error, over the tolerance, below which an interval is done: threads and rollers that take or lose load change the
/// stiffness between the checked places.
constexpr double kReserve = 1.0 / 30.0;

/// Marks the open intervals to check, at most `room` of them, those with the largest errors.
std::vector<bool> to_look_at(const std::vector<Node>& nodes, std::size_t room) {
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (nodes[k].is_open) open.push_back(k);
  std::ranges::stable_sort(open, std::greater(), [&](std::size_t k) { return nodes[k].missed.share(); });
  if (open.size() > room) open.resize(room);
  std::vector<bool> look(nodes.size());
  for (const std::size_t k : open) look[k] = true;
  return look;
}

/// Adds a node in open intervals; if the curve missed it, both parts stay open.
void refine(std::vector<Node>& nodes, double origin, bool over_root, const Solve& solve, Errors& errors) {
  const BranchTable table = table_of(nodes, origin, over_root);
  const PrsCurves curves = in_tension(table);
  const auto place = [&](double a, double b) {
    if (!over_root) return a + kPlace * (b - a);
    return std::pow(std::cbrt(a) + kPlace * (std::cbrt(b) - std::cbrt(a)), 3.0);
  };
  const std::vector<bool> look = to_look_at(nodes, kMostNodes - nodes.size());
  std::vector<double> forces;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (look[k]) forces.push_back(place(nodes[k].force, nodes[k + 1].force));
  std::vector<Node> found = solve(forces);
  const double largest = nodes.back().force;
  const double stiffest = std::ranges::max(nodes, {}, &Node::stiffness).stiffness;
  std::vector<Node> finer;
  auto next = found.begin();
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    finer.push_back(nodes[k]);
    if (!look[k]) continue;
    Node between = *next++;
    int beyond = 0;
    double stiffness = 0.0;
    const double force = prs_force(&curves, between.deflection, &stiffness, &beyond);
    between.missed = {std::abs(force - between.force) / largest, std::abs(stiffness - between.stiffness) / stiffest};
    between.is_open = between.missed.share() > kReserve;
    if (!between.is_open) errors.take(between.missed);
    const bool divides = between.deflection > nodes[k].deflection;
    finer.back().is_open = between.is_open && divides;
    finer.back().missed = between.missed;
    if (divides) finer.push_back(between);
  }
  nodes = std::move(finer);
}

BranchTable branch_table(std::vector<Node> nodes, double origin, bool over_root, const Solve& solve, Errors& errors) {
  nodes.back().is_open = false;
  while (nodes.size() < kMostNodes && std::ranges::any_of(nodes, &Node::is_open))
    refine(nodes, origin, over_root, solve, errors);
  for (const Node& node : nodes)
    if (node.is_open) errors.take(node.missed);
  BranchTable table = table_of(nodes, origin, over_root);
  keep_monotone(table);
  return table;
}

constexpr int kOctaves = 8, kOctavesOfFull = 5;

/// Branch from the first contact on. Near it the deflection is origin + a F^(2/3) + b F. If a misalignment moves the
/// loaded section before there is a force, `shift` is the deflection [m] < 0 from which that of the table counts. The
/// first node is at the largest force over 8^octaves.
BranchTable branch_from_contact(const Solve& solve, double largest, int octaves, Errors& errors, double& shift) {
  std::vector<double> forces;
  for (int k = octaves; k >= 0; --k) forces.push_back(largest * std::pow(8.0, -k));
  std::vector<Node> nodes = solve(forces);
  const double u1 = nodes[0].deflection, u2 = nodes[1].deflection, u3 = nodes[2].deflection;
  const double b = (u3 - u1 - 5.0 * (u2 - u1)) / 28.0, a = (u2 - u1 - 7.0 * b) / 3.0;
  double origin = u1 - a - b;
  // The flanks that touch first have no gap; a small origin is the error of the estimate.
  if (std::abs(origin) < 1e-6 * nodes.back().deflection) origin = 0.0;
  shift = std::min(origin, 0.0);
  const Solve from_shift = [&](const std::vector<double>& at) {
    std::vector<Node> found = solve(at);
    for (Node& node : found) node.deflection -= shift;
    return found;
  };
  for (Node& node : nodes) {
    node.deflection -= shift;
    node.is_open = true;
  }
  origin -= shift;
  nodes.insert(nodes.begin(), Node{0.0, origin, 0.0});
  return branch_table(std::move(nodes), origin, true, from_shift, errors);
}

/// Branch of flanks that touch without load, with this stiffness there.
BranchTable branch_from_rest(const Solve& solve, double stiffness, double largest, Errors& errors) {
  constexpr int kParts = 8;
  std::vector<double> forces;
  for (int k = 1; k <= kParts; ++k) forces.push_back(largest * k / kParts);
  std::vector<Node> nodes = solve(forces);
  nodes.insert(nodes.begin(), Node{0.0, 0.0, stiffness});
  for (Node& node : nodes) node.is_open = true;
  return branch_table(std::move(nodes), 0.0, false, solve, errors);
}

/// Counts the points that are solved.
struct SolvedPoints {
  const std::function<void(std::size_t points)>& progress;
  std::atomic<std::size_t> solved = 0;

  void add(std::size_t points) {
    solved += points;
    if (progress) progress(solved);
  }
};

/// Loads of one load case at other forces.
class LoadsOfCase {
 public:
  LoadsOfCase(Conditions c, const Contacts& contacts, LoadCase pattern, SolvedPoints& points)
      : conditions_(std::move(c)), contacts_(contacts), pattern_(std::move(pattern)), points_(points) {
    pattern_.spatial.orbit.reset();
    // Sections as in `preload`: a single shoulder holds the nut in both senses.
    const PerDirection<double> section = held_sections(conditions_.structure->nut.thrust);
    conditions_.structure->nut.thrust.tension = section.tension;
    conditions_.structure->nut.thrust.compression = section.compression;
  }

  LoadCase at(Direction d, double force) const {
    LoadCase load = pattern_;
    load.axial_force = force;
    load.direction = d;
    return load;
  }

  std::vector<LoadCaseResult> solve(Direction d, const std::vector<double>& forces) {
    conditions_.load_cases.clear();
    for (const double force : forces) conditions_.load_cases.push_back(at(d, force));
    // Only complete results of a full mechanism have the stiffness of the loaded section.
    const bool full = conditions_.model.all_rollers();
    const AnalysisOptions options{full ? Detail::complete : Detail::numbers, Solver::chain, &full_};
    std::vector<LoadCaseResult> results = analyze(conditions_, contacts_, options).load_cases;
    for (const LoadCaseResult& r : results)
      if (!r.threads || !r.tangent_stiffness)
        throw CaseError(pattern_.input_path.empty() ? "preload" : pattern_.input_path,
                        fmt::format("has no {} at {:.4g} N in {}, and the curves of `export` need each force from zero "
                                    "on; leave out what only larger forces hold in place, such as `side_force`",
                                    r.threads ? "stiffness" : "equilibrium", r.load_case.axial_force, name(d)));
    points_.add(results.size());
    return results;
  }

  /// Warnings at the largest force.
  std::vector<Warning> warnings(Direction d, double force) {
    Conditions c = conditions_;
    c.load_cases = {at(d, force)};
    Result result = analyze(c, contacts_);
    std::vector<Warning>& of_load = result.load_cases.front().warnings;
    for (Warning& warning : of_load) warning.what += fmt::format(", at {{{:.4g} kN}} in {}", 1e-3 * force, name(d));
    add_new(std::move(of_load), result.warnings);
    return result.warnings;
  }

 private:
  Conditions conditions_;
  const Contacts& contacts_;
  LoadCase pattern_;
  SolvedPoints& points_;
  FullSolver full_{FullStart::neighbour};
};

void add_loaded_branches(const Conditions& c, const Contacts& contacts, const LoadCase& pattern, double largest,
                         SolvedPoints& points, Errors& errors, SystemCurves& curves) {
  LoadsOfCase loads(c, contacts, pattern, points);
  // Without load, rollers that a misalignment presses to one side take seconds to converge.
  const bool full = c.model.all_rollers();
  const int octaves = full ? kOctavesOfFull : kOctaves;
  for (const Direction d : kDirections) {
    const Solve solve = [&](const std::vector<double>& forces) {
      std::vector<Node> nodes;
      for (const LoadCaseResult& r : loads.solve(d, forces))
        nodes.push_back({r.load_case.axial_force, *r.axial_displacement, *r.tangent_stiffness});
      return nodes;
    };
    double shift = 0.0;
    curves.senses[d] = branch_from_contact(solve, largest, octaves, errors, shift);
    if (shift < 0.0)
      curves.warnings.push_back(
          Warning{pattern.input_path, fmt::format("shifted_{}", name(d)),
                  fmt::format("in {} the force begins at {{value}}, as the misalignment moves the "
                              "loaded section; the deflection of the model counts from there",
                              name(d))}
              .with(shift, {}, "mm"_unit));
    add_new(loads.warnings(d, largest), curves.warnings);
  }
}

void add_preloaded_branches(const Conditions& c, const Contacts& contacts, double largest, Errors& errors,
                            SystemCurves& curves) {
  const PreloadSectors sectors = preload_sectors(c, contacts, contact_laws(c, contacts), c.preload->position);
  PreloadedMechanism mechanism(sectors, preload_fit(c, contacts, sectors));
  for (const Direction d : kDirections) {
    const double sign = d == Direction::tension ? 1.0 : -1.0;
    const Solve solve = [&](const std::vector<double>& forces) {
      std::vector<Node> nodes;
      for (const double force : forces) {
        const PreloadPoint point = mechanism.solve(sign * force);
        if (!point.solve.converged() || !point.tangent_stiffness)
          throw CaseError("preload", fmt::format("does not converge at {:.4g} N; expected every force from "
                                                 "zero on for `export`; take less preload",
                                                 sign * force));
        nodes.push_back({force, sign * point.axial_displacement, *point.tangent_stiffness});
      }
      return nodes;
    };
    const double at_rest = mechanism[d].at_rest().tangent_stiffness.value_or(0.0);
    double none = 0.0;
    curves.senses[d] = at_rest > 0.0 ? branch_from_rest(solve, at_rest, largest, errors)
                                     : branch_from_contact(solve, largest, kOctaves, errors, none);
  }
  add_new(geometry_warnings(c, contacts, {}), curves.warnings);
}

// Friction

/// Torque due to friction at a force and a speed [N m], or how the search for its equilibrium ended without one: `slip
/// ends as jammed`.
struct TorqueOfFriction {
  std::optional<double> torque;
  std::string failure;
};

/// Torque due to friction, at the forces and speeds of a table.
class FrictionTorque {
 public:
  FrictionTorque(const Conditions& c, const Contacts& contacts, const LoadCase& pattern, Oils oils,
                 SolvedPoints& points)
      : pattern_(pattern),
        points_(points),
        loads_(c, contacts, pattern, points),
        models_(c, contacts, std::move(oils)) {
    if (slip_takes_running_loads(c.model, pattern.share)) running_.emplace(c, contacts, models_);
  }

  /// At a signed force [N] and speed [rad/s].
  const TorqueOfFriction& at(double force, double speed) {
    const auto [known, is_new] = torque_.try_emplace({force, speed});
    if (!is_new) return known->second;
    points_.add(1);
    return known->second = running_ ? under_running_loads(force, speed) : under_static_loads(force, speed);
  }

 private:
  TorqueOfFriction under_static_loads(double force, double speed) {
    SlipModel& model = model_at(force);
    model.speed = speed;
    const SlipResult slip = slip_result(model);
    if (!slip.converged()) return {{}, fmt::format("slip ends as {}", name(slip.status))};
    return {slip.torque_screw - without_friction(model, force), {}};
  }
  TorqueOfFriction under_running_loads(double force, double speed) {
    LoadCase load = pattern_;
    load.direction = force < 0.0 ? Direction::compression : Direction::tension;
    load.axial_force = std::abs(force);
    load.speed = speed;
    std::optional<SlipEquilibrium> slip;
    const LoadCaseResult found = running_->solve(load, Detail::numbers, slip);
    if (!found.threads) return {{}, fmt::format("running loads end as {}", name(found.running->status))};
    const SlipModel model = models_.of(found);
    return {drive_torques(model, slip->balance).screw - without_friction(model, force), {}};
  }
  static double without_friction(const SlipModel& model, double force) {
    return force * model.geometry.lead / (2.0 * std::numbers::pi);
  }
  SlipModel& model_at(double force) {
    if (const auto known = model_.find(force); known != model_.end()) return known->second;
    const Direction d = force < 0.0 ? Direction::compression : Direction::tension;
    return model_.emplace(force, models_.of(loads_.solve(d, {std::abs(force)}).front())).first->second;
  }

  LoadCase pattern_;
  SolvedPoints& points_;
  LoadsOfCase loads_;
  SlipModels models_;
  std::optional<RunningSolver> running_;
  std::map<double, SlipModel> model_;
  std::map<std::pair<double, double>, TorqueOfFriction> torque_;
};

double force_of(double root) { return root * std::abs(root); }

/// The torque by the signs of force and speed, each with a search of its own.
class QuadrantTorques {
 public:
  QuadrantTorques(const Conditions& c, const Contacts& contacts, const LoadCase& pattern, const Oils& oils,
                  SolvedPoints& points) {
    for (int k = 0; k < 4; ++k) torques_.emplace_back(c, contacts, pattern, oils, points);
  }
  FrictionTorque& of(double force, double speed) { return torques_[2U * (force < 0.0) + (speed < 0.0)]; }

 private:
  std::deque<FrictionTorque> torques_;
};

FrictionTable table_on(const std::vector<double>& root_force, const std::vector<double>& speeds,
                       QuadrantTorques& torques) {
  const std::size_t roots = root_force.size();
  const std::vector<double> none(roots * speeds.size());
  FrictionTable table{root_force, speeds, none, none};
  const auto fill = [&](double force_sign, double speed_sign) {
    FrictionTorque& torque = torques.of(force_sign, speed_sign);
    for (const auto j : up_to(roots)) {
      if (table.root_force[j] * force_sign < 0.0) continue;
      for (const auto i : indices(table.speed)) {
        const double force = force_of(table.root_force[j]), speed = speed_sign * table.speed[i];
        const auto& [found, failure] = torque.at(force, speed);
        if (!found)
          throw CaseError("friction",
                          fmt::format("{} at {} and {}, so that there is no torque for `export`; ask for less "
                                      "by --force or --speed, or check friction and carrier",
                                      failure, newton(force), rpm(speed)));
        (speed_sign > 0.0 ? table.forward : table.backward)[i * roots + j] = *found;
      }
    }
  };
  std::vector<std::future<void>> quadrants;
  for (const double force_sign : {1.0, -1.0})
    for (const double speed_sign : {1.0, -1.0})
      quadrants.push_back(std::async(kSideBySide, fill, force_sign, speed_sign));
  for (std::future<void>& quadrant : quadrants) quadrant.get();
  return table;
}

PrsCurves curves_of(const FrictionTable& table) {
  PrsCurves curves{};
  curves.forces = table.root_force.size();
  curves.speeds = table.speed.size();
  curves.root_force = table.root_force.data();
  curves.speed = table.speed.data();
  curves.forward = table.forward.data();
  curves.backward = table.backward.data();
  return curves;
}

/// Largest differences of a table at each speed, or each root of a force, of a finer one [N m].
std::vector<double> missed(const FrictionTable& coarse, const FrictionTable& fine, bool by_speed) {
  const PrsCurves curves = curves_of(coarse);
  std::vector<double> most((by_speed ? fine.speed : fine.root_force).size());
  std::size_t k = 0;
  for (const auto i : indices(fine.speed))
    for (const auto j : indices(fine.root_force)) {
      int beyond = 0;
      double& at = most[by_speed ? i : j];
      // With a lead of zero the torque is that of friction.
      for (const auto& [friction, sign] : {std::pair{fine.forward[k], 1.0}, {fine.backward[k], -1.0}})
        at = std::max(
            at, std::abs(friction - prs_torque(&curves, force_of(fine.root_force[j]), sign * fine.speed[i], &beyond)));
      ++k;
    }
  return most;
}

/// Smallest root of the table, below which friction is constant: the torques of the carrier may be too large for a
/// screw with less load.
double least_root(QuadrantTorques& torque, double largest_root, const std::vector<double>& speeds) {
  constexpr double kLeast = 1.0 / 64.0, kMost = 0.5;
  for (double share = kLeast; share < kMost; share *= 2.0) {
    bool all = true;
    const double force = force_of(share * largest_root);
    for (const double speed : speeds)
      for (const double f : {force, -force})
        for (const double v : {speed, -speed}) all = all && torque.of(f, v).at(f, v).torque;
    if (all) return share * largest_root;
  }
  return kMost * largest_root;
}

constexpr double kSpeedRange = 1e-3;          ///< Smallest speed of the table over the largest.
constexpr std::ptrdiff_t kMostOfTable = 260;  ///< Nodes along speeds or roots.

/// A table that is refined along roots and along speeds where it misses the torque.
FrictionTable friction_table(QuadrantTorques& torque, double force, double speed, bool depends_on_speed, double lead,
                             double& error) {
  std::vector<double> speeds, roots;
  const int ratios = depends_on_speed ? 4 : 1, parts = 8;
  for (int k = 0; k <= ratios; ++k) speeds.push_back(speed * std::pow(kSpeedRange, 1.0 - 1.0 * k / ratios));
  const double most = std::sqrt(force), least = least_root(torque, most, speeds);
  for (int k = parts; k >= 0; --k) roots.push_back(-least - (most - least) * k / parts);
  for (int k = 0; k <= parts; ++k) roots.push_back(least + (most - least) * k / parts);
  // Intervals that are still to be divided.
  std::vector<bool> open_roots(roots.size() - 1, true), open_speeds(speeds.size() - 1, depends_on_speed);
  FrictionTable table = table_on(roots, speeds, torque);
  const double largest = std::abs(force * lead) / (2.0 * std::numbers::pi) +
                         std::max(std::ranges::max(table.forward), std::abs(std::ranges::min(table.backward)));

  const auto refine = [&](bool by_speed) {
    std::vector<bool>& open = by_speed ? open_speeds : open_roots;
    std::vector<double>& at = by_speed ? speeds : roots;
    open_roots[static_cast<std::size_t>(std::ranges::upper_bound(roots, 0.0) - roots.begin()) - 1] = false;  // No load.
    const std::ptrdiff_t parted = std::ranges::count(open, true);
    if (parted == 0 || std::ssize(at) + parted > kMostOfTable) return false;
    for (std::size_t k = open.size(); k-- > 0;)
      if (open[k])
        at.insert(at.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                  by_speed ? std::sqrt(at[k] * at[k + 1]) : 0.5 * (at[k] + at[k + 1]));
    FrictionTable finer = table_on(roots, speeds, torque);
    const std::vector<double> off = missed(table, finer, by_speed);
    std::vector<bool> halves;
    for (const bool is_open : open) {
      // At the node between both halves.
      const bool stays = is_open && !(off[halves.size() + 1] <= largest * kTorqueTolerance / 8.0);
      halves.insert(halves.end(), is_open ? 2 : 1, stays);
    }
    open = std::move(halves);
    table = std::move(finer);
    return true;
  };
  for (bool more = true; more;) {
    more = refine(false);
    more = refine(true) || more;
  }
  const PrsCurves curves = curves_of(table);
  for (std::size_t k = 0; k < 400; ++k) {  // Places off the nodes, in all quadrants.
    const std::size_t i = k % open_speeds.size(), j = 7 * k % open_roots.size();
    const double sign = k / open_speeds.size() % 2 == 0 ? 1.0 : -1.0;
    const double f = force_of(0.7 * roots[j] + 0.3 * roots[j + 1]), v = sign * (0.7 * speeds[i] + 0.3 * speeds[i + 1]);
    int beyond = 0;
    if (roots[j] * roots[j + 1] > 0.0)
      if (const std::optional<double>& found = torque.of(f, v).at(f, v).torque)
        error = std::max(error, std::abs(*found - prs_torque(&curves, f, v, &beyond)) / largest);
  }
  return table;
}

/// Conditions of the running parts: with `heat` at its steady temperatures.
struct Running {
  Conditions conditions;
  Oils oils;
};

Running running(const Conditions& c, const Contacts& contacts, const LoadCase& pattern) {
  if (!warms(c.heat)) return {c, oils_in_operation(c)};
  Conditions one = c;
  one.load_cases = {pattern};
  one.heat->duty.clear();
  const Result result = analyze_heat(one, contacts, {.detail = Detail::numbers});
  const HeatResult& heat = *result.load_cases.front().heat;
  if (!heat.converged())
    throw CaseError("heat", fmt::format("{}: {}; the oil's temperature decides on the torque of "
                                        "`export`; leave `heat` out, or fix it",
                                        name(heat.status), heat.reason));
  Running warm{one, c.lubricant ? oils_at(*c.lubricant, *heat.oil) : Oils{}};
  warm.conditions.deviations.temperature = heat.temperature;
  return warm;
}

/// Reason why there is no friction in the torque up to a speed; none if there is.
std::optional<Warning> lacking_friction(const Case& c, const LoadCase& pattern, double speed) {
  Case one = c;
  one.load_cases = {pattern};
  const std::vector<Problem> problems = missing(one, Command::slip);
  constexpr std::string_view kWithout = "the torque is that of a screw without friction";
  if (!problems.empty())
    return Warning{problems.front().path, "no_friction", fmt::format("{}; {}", problems.front().message, kWithout)};
  if (speed > 0.0) return {};
  return Warning{"operation.speed", "no_friction",
                 fmt::format("got 0 rpm, the largest speed of the case; {}", kWithout), "state a speed other than 0"};
}

double largest_speed(const Case& c) {
  double speed = c.operation ? std::abs(c.operation->speed) : 0.0;
  for (const LoadCase& load : c.load_cases) speed = std::max(speed, std::abs(load.speed.value_or(0.0)));
  return speed;
}

/// Conditions for which the torque of a preloaded screw is valid; none if they are the obvious ones.
std::optional<Warning> torque_of_preloaded(const Case& c, const LoadCase& pattern, bool chosen) {
  std::vector<std::string> conditions;
  if (chosen) conditions.push_back("position");
  if (c.heat) conditions.push_back("temperatures");
  std::string where;
  if (!pattern.name.empty() && !conditions.empty())
    where = fmt::format(", at the {} of load case `{}`, which the force does not have", fmt::join(conditions, " and "),
                        pattern.name);
  if (slip_takes_running_loads(c.model, pattern.share)) {
    if (where.empty()) return std::nullopt;
    return Warning{"preload", "torque_elsewhere", "the torque is that of both flanks" + where};
  }
  return Warning{"preload", "torque_without_preload",
                 fmt::format("the torque is that of the external load alone{}; what friction takes "
                             "of the preload is not in it",
                             where)};
}

void add_friction(const Case& c, const Contacts& contacts, LoadCase pattern, double force, const CurveOptions& options,
                  SolvedPoints& points, SystemCurves& curves) {
  if (!pattern.speed && !c.operation && options.speed) pattern.speed = options.speed;
  const double speed = options.speed.value_or(largest_speed(c));
  if (std::optional<Warning> lacking = lacking_friction(c, pattern, speed)) {
    curves.warnings.push_back(std::move(*lacking));
    if (c.preload && options.load_case)
      curves.warnings.push_back({"preload", "idle_load_case",
                                 fmt::format("the force is that of `prs preload`; without friction "
                                             "the load case `{}` changes nothing",
                                             pattern.name)});
    return;
  }
  require_rolling(c, contacts);
  if (c.preload && !c.preload->backlash)
    if (std::optional<Warning> note = torque_of_preloaded(c, pattern, options.load_case.has_value()))
      curves.warnings.push_back(std::move(*note));
  const Running parts = running(c, contacts, pattern);
  QuadrantTorques torque(parts.conditions, contacts, pattern, parts.oils, points);
  curves.friction = friction_table(torque, force, speed, c.friction->facts().changes_with_speed || c.carrier.is_oiled(),
                                   curves.lead, curves.torque_error);
}

/// Load case with the conditions: position, misalignment, speed. With `preload` and no chosen load case, its position
/// is that of the preload.
LoadCase pattern_of(const Case& c, const CurveOptions& options) {
  const auto is_asked_for = [&](const LoadCase& load) {
    return options.load_case ? load.name == *options.load_case : load.is_solved();
  };
  const auto found = std::ranges::find_if(c.load_cases, is_asked_for);
  const bool usable = found != c.load_cases.end() && found->is_solved();
  if (c.preload && !options.load_case) {  // Torque and force must be at the same position.
    LoadCase pattern = usable ? *found : LoadCase{};
    pattern.position = c.preload->position;
    return pattern;
  }
  if (usable) return *found;
  if (found != c.load_cases.end())
    throw CaseError(found->input_path,
                    "got `share: equal`; expected a load case that the models solve for `export`; "
                    "leave `share` out, and state `direction` and `position`");
  std::string names;
  for (const LoadCase& load : c.load_cases)
    if (load.is_solved()) names.append(names.empty() ? "" : ", ").append(load.name);
  if (names.empty())
    throw CaseError("load_cases",
                    "got equal thread loads in each; expected one that the models solve for `export`; "
                    "add a load case without `share: equal`");
  throw CaseError("load_cases",
                  fmt::format("there is none called `{}`; expected one of {}", *options.load_case, names));
}

double largest_force(const Case& c) {
  double force = 0.0;
  for (const LoadCase& load : c.load_cases) force = std::max(force, std::abs(load.axial_force));
  if (c.preload) force = std::max({force, std::abs(c.preload->load.from), std::abs(c.preload->load.to)});
  return force;
}

}  // namespace

PrsBranch BranchTable::view() const {
  return {origin, over_root ? 1 : 0, at.size(), at.data(), force.data(), slope.data()};
}

double BranchTable::deflection(std::size_t node) const { return origin + (over_root ? at[node] * at[node] : at[node]); }

double BranchTable::stiffness(std::size_t node) const {
  if (!over_root) return slope[node];
  return at[node] > 0.0 ? slope[node] / (2.0 * at[node]) : 0.0;
}

PrsCurves SystemCurves::view() const {
  PrsCurves curves = curves_of(friction);
  curves.lead = lead;
  curves.tension = senses.tension.view();
  curves.compression = senses.compression.view();
  return curves;
}

std::vector<double> SystemCurves::data() const {
  std::vector<double> all{1.0, lead};
  const auto add = [&](const std::vector<double>& values) { all.insert(all.end(), values.begin(), values.end()); };
  for (const Direction d : kDirections) {
    const BranchTable& branch = senses[d];
    add({branch.origin, branch.over_root ? 1.0 : 0.0, static_cast<double>(branch.at.size())});
    add(branch.at);
    add(branch.force);
    add(branch.slope);
  }
  add({static_cast<double>(friction.root_force.size()), static_cast<double>(friction.speed.size())});
  add(friction.root_force);
  add(friction.speed);
  add(friction.forward);
  add(friction.backward);
  return all;
}

SystemCurves system_curves(const Case& c, const CurveOptions& asked) {
  SystemCurves curves;
  CurveOptions options = asked;
  const LoadCase pattern = pattern_of(c, options);
  const Contacts contacts = checked_contacts(c, Detail::complete);
  const double force = options.force.value_or(largest_force(c));
  curves.lead = contacts.threads.screw.lead;
  if (asked.speed && asked.speed_along_axis) options.speed = std::abs(input::rotation(*asked.speed, curves.lead));
  SolvedPoints points{options.progress};
  Errors errors;
  if (c.preload) {
    add_preloaded_branches(c, contacts, force, errors, curves);
  } else {
    curves.load_case = pattern.name;
    add_loaded_branches(c, contacts, pattern, force, points, errors, curves);
  }
  curves.force_error = errors.force;
  curves.stiffness_error = errors.stiffness;
  add_friction(c, contacts, pattern, force, options, points, curves);
  return curves;
}

}  // namespace prs
