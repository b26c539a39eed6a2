#include "prs/curves/system_curves.h"

#include <fmt/ranges.h>

#include "prs/heat/analyze_heat.h"
#include "prs/model/check_case.h"
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

/// Loads of one load case at other forces.
class LoadsOfCase {
 public:
  LoadsOfCase(Conditions c, const Contacts& contacts, LoadCase pattern,
              std::function<void(std::size_t loads)> progress = {})
      : conditions_(std::move(c)), contacts_(contacts), pattern_(std::move(pattern)), progress_(std::move(progress)) {
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
    solved_ += results.size();
    if (progress_) progress_(solved_);
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
  std::function<void(std::size_t loads)> progress_;
  std::size_t solved_ = 0;
  FullSolver full_{FullStart::neighbour};
};

void add_loaded_branches(const Conditions& c, const Contacts& contacts, const LoadCase& pattern, double largest,
                         const CurveOptions& options, Errors& errors, SystemCurves& curves) {
  LoadsOfCase loads(c, contacts, pattern, options.progress);
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

/// Torque due to friction, at the forces and speeds of a table.
class FrictionTorque {
 public:
  FrictionTorque(const Conditions& c, const Contacts& contacts, const LoadCase& pattern, Oils oils)
      : pattern_(pattern), loads_(c, contacts, pattern), models_(c, contacts, std::move(oils)) {
    if (slip_takes_running_loads(c.model, pattern.share)) running_.emplace(c, contacts, models_);
  }

  /// Torque [N m] at a signed force [N] and speed [rad/s]; none without equilibrium.
  std::optional<double> at(double force, double speed) {
    const auto [known, is_new] = torque_.try_emplace({force, speed});
    if (!is_new) return known->second;
    if (running_) return known->second = running_at(force, speed);
    SlipModel& model = model_at(force);
    model.speed = speed;
    const SlipResult slip = slip_result(model);
    if (slip.converged()) known->second = slip.torque_screw - force * model.geometry.lead / (2.0 * std::numbers::pi);
    status_ = slip.status;
    return known->second;
  }
  /// Reason why there was none.
  SlipStatus status() const { return status_; }

 private:
  std::optional<double> running_at(double force, double speed) {
    LoadCase load = pattern_;
    load.direction = force < 0.0 ? Direction::compression : Direction::tension;
    load.axial_force = std::abs(force);
    load.speed = speed;
    std::optional<SlipEquilibrium> slip;
    const LoadCaseResult found = running_->solve(load, Detail::numbers, slip);
    status_ = slip ? slip->status : SlipStatus::no_equilibrium;
    if (!found.threads) return std::nullopt;
    const SlipModel model = models_.of(found);
    return drive_torques(model, slip->balance).screw - force * model.geometry.lead / (2.0 * std::numbers::pi);
  }
  SlipModel& model_at(double force) {
    if (const auto known = model_.find(force); known != model_.end()) return known->second;
    const Direction d = force < 0.0 ? Direction::compression : Direction::tension;
    return model_.emplace(force, models_.of(loads_.solve(d, {std::abs(force)}).front())).first->second;
  }

  LoadCase pattern_;
  LoadsOfCase loads_;
  SlipModels models_;
  std::optional<RunningSolver> running_;
  std::map<double, SlipModel> model_;
  std::map<std::pair<double, double>, std::optional<double>> torque_;
  SlipStatus status_ = SlipStatus::not_computed;
};

/// Nodes of a table: 2^k + 1 roots of a force in each sense, 2^k + 1 speeds, refined by halving.
struct FrictionGrid {
  double least_root = 0.0, largest_root = 0.0;
  double least_speed = 0.0, largest_speed = 0.0;
  std::size_t forces = 8, speeds = 4;  ///< Number of intervals; one for speeds if they do not matter.

  std::vector<double> roots() const {
    std::vector<double> roots;
    for (std::size_t k = 0; k <= forces; ++k)
      roots.push_back(least_root + (largest_root - least_root) * static_cast<double>(k) / static_cast<double>(forces));
    std::vector<double> all;
    std::transform(roots.rbegin(), roots.rend(), std::back_inserter(all), std::negate{});
    all.insert(all.end(), roots.begin(), roots.end());
    return all;
  }
  std::vector<double> speed() const {
    std::vector<double> all;
    for (std::size_t k = 0; k <= speeds; ++k)
      all.push_back(largest_speed *
                    std::pow(least_speed / largest_speed, 1.0 - static_cast<double>(k) / static_cast<double>(speeds)));
    return all;
  }
};

double force_of(double root) { return root * std::abs(root); }

FrictionTable table_on(const FrictionGrid& grid, FrictionTorque& torque) {
  FrictionTable table{grid.roots(), grid.speed(), {}, {}};
  for (const double speed : table.speed)
    for (const double root : table.root_force)
      for (const double sign : {1.0, -1.0}) {
        const std::optional<double> found = torque.at(force_of(root), sign * speed);
        if (!found)
          throw CaseError("friction",
                          fmt::format("slip ends as {} at {:.4g} N and {:.4g} rad/s, so that there is no torque for "
                                      "`export`; ask for less by --force or --speed, or check friction and carrier",
                                      name(torque.status()), force_of(root), sign * speed));
        (sign > 0.0 ? table.forward : table.backward).push_back(*found);
      }
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

/// Largest difference at the nodes of a finer table [N m].
double difference(const FrictionTable& coarse, const FrictionTable& fine) {
  const PrsCurves curves = curves_of(coarse);
  double largest = 0.0;
  std::size_t k = 0;
  for (const double speed : fine.speed)
    for (const double root : fine.root_force) {
      int beyond = 0;
      // With a lead of zero the torque is that of friction.
      const auto missed = [&](double friction, double sign) {
        return std::abs(friction - prs_torque(&curves, force_of(root), sign * speed, &beyond));
      };
      largest = std::max({largest, missed(fine.forward[k], 1.0), missed(fine.backward[k], -1.0)});
      ++k;
    }
  return largest;
}

/// Smallest root of the table, below which friction is constant: the torques of the carrier may be too large for a
/// screw with less load.
double least_root(FrictionTorque& torque, const FrictionGrid& grid) {
  constexpr double kLeast = 1.0 / 64.0, kMost = 0.5;
  for (double share = kLeast; share < kMost; share *= 2.0) {
    bool all = true;
    for (const double force_sign : {1.0, -1.0})
      for (const double sign : {1.0, -1.0})
        for (const double speed : grid.speed())
          all = all && torque.at(force_sign * force_of(share * grid.largest_root), sign * speed);
    if (all) return share * grid.largest_root;
  }
  return kMost * grid.largest_root;
}

constexpr std::size_t kMostIntervals = 128;
constexpr double kSpeedRange = 1e-3;  ///< Smallest speed of the table over the largest.

FrictionTable friction_table(FrictionTorque& torque, double force, double speed, bool depends_on_speed, double lead,
                             double& error) {
  FrictionGrid grid{0.0, std::sqrt(force), kSpeedRange * speed, speed};
  if (!depends_on_speed) grid.speeds = 1;
  grid.least_root = least_root(torque, grid);
  FrictionTable table = table_on(grid, torque);
  const double largest = std::abs(force * lead) / (2.0 * std::numbers::pi) +
                         std::max(std::ranges::max(table.forward), std::abs(std::ranges::min(table.backward)));
  bool is_coarse_in_force = true, is_coarse_in_speed = depends_on_speed;
  const auto refine_by = [&](std::size_t FrictionGrid::*intervals, bool& is_coarse) {
    if (!is_coarse || grid.*intervals >= kMostIntervals) return false;
    grid.*intervals *= 2;
    FrictionTable finer = table_on(grid, torque);
    const double missed = difference(table, finer) / largest;
    is_coarse = missed > kTorqueTolerance / 3.0;
    error = std::max(is_coarse && grid.*intervals < kMostIntervals ? 0.0 : missed, error);
    table = std::move(finer);
    return true;
  };
  for (bool refined = true; refined;) {
    refined = refine_by(&FrictionGrid::forces, is_coarse_in_force);
    refined = refine_by(&FrictionGrid::speeds, is_coarse_in_speed) || refined;
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

/// Reason why there is no friction in the torque; none if there is.
std::optional<Warning> lacking_friction(const Case& c, const LoadCase& pattern) {
  Case one = c;
  one.load_cases = {pattern};
  const std::vector<Problem> problems = missing(one, Command::slip);
  if (problems.empty()) return {};
  return Warning{problems.front().path, "no_friction",
                 fmt::format("{}; the torque is that of a screw without friction", problems.front().message)};
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
                  SystemCurves& curves) {
  if (!pattern.speed && !c.operation && options.speed) pattern.speed = options.speed;
  if (std::optional<Warning> lacking = lacking_friction(c, pattern)) {
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
  FrictionTorque torque(parts.conditions, contacts, pattern, parts.oils);
  curves.friction =
      friction_table(torque, force, options.speed.value_or(largest_speed(c)),
                     c.friction->facts().changes_with_speed || c.carrier.is_oiled(), curves.lead, curves.torque_error);
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
  Errors errors;
  if (c.preload) {
    add_preloaded_branches(c, contacts, force, errors, curves);
  } else {
    curves.load_case = pattern.name;
    add_loaded_branches(c, contacts, pattern, force, options, errors, curves);
  }
  curves.force_error = errors.force;
  curves.stiffness_error = errors.stiffness;
  add_friction(c, contacts, pattern, force, options, curves);
  return curves;
}

}  // namespace prs
