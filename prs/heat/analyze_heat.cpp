#include "prs/heat/analyze_heat.h"

#include "prs/life/contact_loads.h"
#include "prs/model/quantity_text.h"
#include "prs/slip/running.h"

namespace prs {
namespace {

/// Oils and hardened flanks of bearing steel last up to about 200 degC [K].
constexpr double kHotParts = 473.15;

HeatResult result_of(const SteadyHeat& found, bool has_oil) {
  HeatResult heat;
  heat.status = found.status;
  heat.reason = found.reason;
  heat.evaluations = found.evaluations;
  heat.others = found.others;
  heat.temperature = per_part(found.temperature);
  if (has_oil) heat.oil = oil_temperatures(found.temperature);
  heat.heat = per_part(found.heat);
  return heat;
}

void warn(const HeatResult& heat, std::vector<Warning>& warnings) {
  if (!heat.converged()) {
    warnings.push_back(no_steady_state(heat.status, heat.reason));
    return;
  }
  if (heat.others)
    warnings.push_back({"heat", "several_steady_states",
                        "there are several steady states; this is the one that the parts reach from the "
                        "temperature of their surroundings, hotter ones hold once they are reached"});
  for (const Part p : kParts)
    if (heat.temperature[p] > kHotParts)
      warnings.push_back(Warning{"heat", fmt::format("hot_{}", name(p)),
                                 fmt::format("{} at {:.0f} degC: above {} oils and hardened flanks do not last",
                                             name(p), heat.temperature[p] - 273.15, celsius(kHotParts))}
                             .with(heat.temperature[p], kHotParts, text_unit::kelvin));
}

/// Forces of one sense up to this number are solved one by one; of more, heat is interpolated over
/// the force through that many of Chebyshev's extreme points.
constexpr std::size_t kForces = 12;

/// Loads whose heat is the same function of the force.
struct Kind {
  Direction direction = Direction::tension;
  DrivenBy driven_by = DrivenBy::screw;

  auto operator<=>(const Kind&) const = default;
};

/// Shares of time by the force.
using Shares = std::map<double, double>;

/// The same mean of every polynomial through the points, on few forces.
Shares on_points(const Shares& shares) {
  if (shares.size() <= kForces) return shares;
  const double least = shares.begin()->first, greatest = shares.rbegin()->first;
  std::vector<double> force(kForces), weight(kForces);
  for (std::size_t n = 0; n < kForces; ++n) {
    const double along = std::cos(std::numbers::pi * static_cast<double>(n) / (kForces - 1));
    force[n] = 0.5 * (least + greatest) - 0.5 * (greatest - least) * along;
    weight[n] = (n % 2 == 0 ? 1.0 : -1.0) * (n == 0 || n + 1 == kForces ? 0.5 : 1.0);
  }
  force.front() = least, force.back() = greatest;
  Shares found;
  for (const auto& [f, share] : shares) {
    // Lagrange's polynomials in barycentric form.
    const auto at = std::ranges::find(force, f);
    double sum = 0.0;
    for (std::size_t n = 0; n < kForces; ++n) sum += weight[n] / (f - force[n]);
    for (std::size_t n = 0; n < kForces; ++n) {
      const double basis = at != force.end() ? (*at == force[n] ? 1.0 : 0.0) : weight[n] / (f - force[n]) / sum;
      found[force[n]] += share * basis;
    }
  }
  return found;
}

/// The loads of a spectrum and their shares of time. With a clock, a history's rests have theirs.
std::vector<TimedLoad> timed_loads(const Conditions& c, double lead, const std::optional<LoadHistory>& history) {
  const double speed = std::abs(c.operation->speed);
  const std::vector<LoadStep> steps = load_steps(*c.life, history, lead, speed);
  std::vector<double> time(steps.size());
  double total = 0.0;
  const std::optional<double> clock = history ? duration(*history) : std::nullopt;
  for (std::size_t k = 0; k < steps.size(); ++k) time[k] = steps[k].revolutions;
  if (clock) time = moving_times(*history, lead, speed);
  for (const double t : time) total += t;
  if (clock) total = *clock;

  std::map<Kind, Shares> kinds;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const LoadStep& step = steps[k];
    if (!(time[k] > 0.0) || (step.axial_force == 0.0 && !c.preload)) continue;
    const Direction d = step.axial_force < 0.0 ? Direction::compression : Direction::tension;
    const double by_load = step.revolutions > 0.0 ? step.driven_by_load / step.revolutions : 0.0;
    for (const auto& [by, part] : {std::pair(DrivenBy::screw, 1.0 - by_load), std::pair(DrivenBy::load, by_load)})
      if (part > 0.0) kinds[{d, by}][std::abs(step.axial_force)] += part * time[k] / total;
  }
  std::vector<TimedLoad> loads;
  for (const auto& [kind, shares] : kinds)
    for (const auto& [force, share] : on_points(shares)) {
      LoadCase load = driven_load_case(c, lead, kind.direction, kind.driven_by);
      load.axial_force = force;
      loads.push_back({std::move(load), share});
    }
  return loads;
}

/// The case with its parts, and what films they have, at these temperatures.
Conditions warm(const Conditions& c, const PerPart<double>& temperature) {
  Conditions at = c;
  at.deviations.temperature = temperature;
  return at;
}

Conditions with_coarse_patches(Conditions c) {
  c.model.patch_points = std::min(c.model.patch_points, kFewestPatchPoints);
  return c;
}

constexpr int kMostPoints = 9;       // Along a coordinate: 3, 5, 9, each within the next.
constexpr int kMostOfAPanel = 250;   // Beyond that a panel is halved.
constexpr double kNarrowest = 0.02;  // Of a panel [K].
/// Places at which a panel is checked, between its points on [-1, 1].
constexpr double kChecks[][3] = {{0.55, -0.19, -0.83}, {-0.85, 0.53, 0.21}};

/// T_0 .. T_{n-1} at x, or their derivatives.
using Basis = std::array<double, kMostPoints>;

void chebyshev(double x, int n, Basis& value, Basis& slope) {
  value = {1.0, x};
  slope = {0.0, 1.0};
  for (std::size_t k = 2; k < static_cast<std::size_t>(n); ++k) {
    value[k] = 2.0 * x * value[k - 1] - value[k - 2];
    slope[k] = 2.0 * value[k - 1] + 2.0 * x * slope[k - 1] - slope[k - 2];
  }
}

/// Extreme point j of T_{n-1} on [-1, 1]; the middle where n = 1.
double extreme_point(int j, int n) { return n == 1 ? 0.0 : std::cos(std::numbers::pi * j / (n - 1)); }

/// Its number among `kMostPoints`.
int on_finest(int j, int n) { return n == 1 ? (kMostPoints - 1) / 2 : j * ((kMostPoints - 1) / (n - 1)); }

/// What the value at point j of n adds to coefficient k.
double coefficient_weight(int j, int k, int n) {
  if (n == 1) return 1.0;
  const auto end = [n](int i) { return i == 0 || i == n - 1 ? 0.5 : 1.0; };
  return end(j) * end(k) * 2.0 / (n - 1) * std::cos(std::numbers::pi * j * k / (n - 1));
}

/// What n coefficients of these sizes leave out: the last one, which may vanish by parity, and what
/// follows on the last but one, as that followed on the one two before.
double left_out(const Basis& size, std::size_t n) {
  const double before = n > 4 ? size[n - 4] : 0.0;
  const double falls = before > size[n - 2] ? size[n - 2] / before : 1.0;
  return std::max(size[n - 1], falls * size[n - 2]);
}

Flows flows_of(const Losses& losses) {
  Flows f;
  f << losses.heat, losses.input, losses.output;
  return f;
}

/// The temperatures of the parts that have these coordinates.
OfParts temperatures(const OfParts& c) {
  const double screw_oil = c[0] + 0.5 * c[1], nut_oil = c[0] - 0.5 * c[1], rollers = c[0] + c[2];
  return {2.0 * screw_oil - rollers, rollers, 2.0 * nut_oil - rollers};
}

/// d(table_coordinates)/d(temperature)
Eigen::Matrix3d coordinates_by_parts() {
  Eigen::Matrix3d m;
  m << 0.25, 0.5, 0.25, 0.5, 0.0, -0.5, -0.25, 0.5, -0.25;
  return m;
}

}  // namespace

void add_new(std::vector<Warning> found, std::vector<Warning>& warnings) {
  for (Warning& warning : found)
    if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(std::move(warning));
}

Warning no_steady_state(HeatStatus status, const std::string& reason) {
  return {"heat", "no_steady_state", fmt::format("{}: {}", name(status), reason)};
}

HeatSource mean_heat(const std::vector<LossShare>& exact, const std::vector<LossShare>& equal, bool may_grow) {
  const auto sum = [](const std::vector<LossShare>& parts, auto heat_of) -> std::optional<OfParts> {
    OfParts all = OfParts::Zero();
    for (const LossShare& part : parts) {
      const std::optional<OfParts> heat = heat_of(part);
      if (!heat) return std::nullopt;
      all += part.share * *heat;
    }
    return all;
  };
  const auto failure = std::make_shared<std::string>();
  return {[=](const OfParts& t) {
            return sum(exact, [&](const LossShare& part) -> std::optional<OfParts> {
              const std::optional<Losses> losses = part.losses->at(t);
              if (losses) return losses->heat;
              *failure = part.failure();
              return std::nullopt;
            });
          },
          [=] { return *failure; },
          [=](const PerInterface<double>& oil) {
            return sum(equal, [&](const LossShare& part) { return part.losses->estimate(oil); });
          },
          [=](const PerInterface<double>& oil) {
            return sum(equal, [&](const LossShare& part) { return part.losses->rough_estimate(oil); });
          },
          may_grow};
}

SteadyHeat steady_heat_of(const Conditions& c, const Contacts& contacts, std::span<const TimedLoad> loads) {
  const ThermalNetwork network = thermal_network(*c.heat);
  const auto shares_of = [&](const Conditions& conditions, std::optional<LoadCase::Share> in_place) {
    std::vector<LossShare> shares;
    for (const TimedLoad& l : loads)
      if (l.share > 0.0)
        shares.push_back(
            {l.share, std::make_shared<CaseLosses>(conditions, contacts, l.load, in_place.value_or(l.load.share)), {}});
    return shares;
  };
  const std::vector<LossShare> equal = shares_of(c, LoadCase::Share::equal);
  SteadyHeat found = find_steady_heat(network, mean_heat(equal, equal, heat_may_grow(c)));
  const bool solved =
      std::ranges::any_of(loads, [](const TimedLoad& l) { return l.load.share == LoadCase::Share::solved; });
  if (!solved || !found.converged()) return found;
  const bool others = found.others;
  const Conditions fitted = has_both_flanks(c, LoadCase::Share::solved) ? with_interference(c, contacts) : c;
  found = find_steady_heat(network, mean_heat(shares_of(fitted, {}), equal, false), found.temperature);
  found.others = found.others || others;
  return found;
}

namespace {

/// Load cases with the temperatures at which their losses flow off, with a duty those of its mean. Loads and losses
/// stay.
Result with_temperatures(Result result, const Conditions& c) {
  const ThermalNetwork network = thermal_network(*c.heat);
  double cycle = 0.0;
  for (const Heat::DutyStep& step : c.heat->duty) cycle += step.time();
  for (LoadCaseResult& r : result.load_cases) {
    SteadyHeat found;
    bool known = true;
    const auto take = [&](const LoadCaseResult& loaded, double share) {
      known = known && loaded.slip && loaded.slip->converged();
      if (known) found.heat += share * heat_of(loaded.slip->power);
    };
    if (c.heat->duty.empty()) take(r, 1.0);
    for (const Heat::DutyStep& step : c.heat->duty)
      for (const LoadCaseResult& other : result.load_cases)
        if (step.load_case == other.load_case.name) take(other, step.time() / cycle);
    found.temperature = network.steady(found.heat);
    found.status = known ? HeatStatus::converged : HeatStatus::no_steady_state;
    if (!known) found.reason = "there is no slip";
    r.heat = result_of(found, false);  // The oil has the temperature that the case states.
  }
  return result;
}

}  // namespace

Result analyze_heat(const Conditions& c, Contacts contacts, AnalysisOptions options) {
  if (!c.heat) return analyze_slip(c, std::move(contacts), options);
  if (!warms(c.heat)) return with_temperatures(analyze_slip(c, std::move(contacts), options), c);
  require_rolling(c, contacts);
  Result result;
  result.model = c.model;
  for (const LoadCase& load : c.load_cases) {
    const TimedLoad all_the_time[] = {{load}};
    const SteadyHeat found = steady_heat_of(c, contacts, all_the_time);
    const OfParts temperature = found.converged() ? found.temperature : OfParts::Constant(c.heat->ambient);
    const Oils oils = warm_oils(c, oil_temperatures(temperature));
    Result one = analyze_slip(at_temperatures(c, load, temperature), contacts, options, oils);
    LoadCaseResult& loaded = one.load_cases.front();
    loaded.heat = result_of(found, c.lubricant.has_value());
    if (!found.converged()) loaded.slip.reset();
    if (options.detail == Detail::complete) warn(*loaded.heat, loaded.warnings);
    result.load_cases.push_back(std::move(loaded));
    add_new(std::move(one.warnings), result.warnings);
  }
  if (!c.heat->duty.empty()) {
    result.heat_cycle = periodic_heat_cycle(c, contacts, result.warnings);
    if (!result.heat_cycle->converged())
      result.warnings.push_back(
          {"heat.duty", "no_cycle", fmt::format("{}: {}", name(result.heat_cycle->status), result.heat_cycle->reason)});
  }
  result.contacts = std::move(contacts);
  return result;
}

PreloadResult analyze_warm_preload(const Conditions& c, Contacts contacts) {
  if (!warms(c.heat)) return analyze_preload(c, std::move(contacts));
  require_rolling(c, contacts);
  const auto named = std::ranges::find_if(
      c.load_cases, [&](const LoadCase& load) { return !c.preload->load_case || load.name == *c.preload->load_case; });
  const TimedLoad all_the_time[] = {{*named}};
  const SteadyHeat heat = steady_heat_of(c, contacts, all_the_time);
  PreloadResult result = analyze_preload(
      warm(c, per_part(heat.converged() ? heat.temperature : OfParts::Constant(c.heat->ambient))), std::move(contacts));
  result.load_case = named->name;
  result.heat_status = heat.status;
  if (!heat.converged()) result.warnings.push_back(no_steady_state(heat.status, heat.reason));
  return result;
}

LifeResult analyze_warm_life(const Conditions& c, Contacts contacts, std::optional<LoadHistory> history) {
  if (!c.life->takes_heat(warms(c.heat))) return analyze_life(c, std::move(contacts), std::move(history));
  require_rolling(c, contacts);
  HeatStatus status = HeatStatus::converged;
  std::string reason;
  PerPart<double> temperature;
  std::vector<Warning> warnings;
  if (c.heat->duty.empty()) {
    const SteadyHeat heat = steady_heat_of(c, contacts, timed_loads(c, contacts.mechanism.lead, history));
    status = heat.status, reason = heat.reason;
    temperature = per_part(heat.temperature);
  } else {
    const HeatCycle cycle = periodic_heat_cycle(c, contacts, warnings);
    status = cycle.status, reason = cycle.reason;
    temperature = cycle.mean;
  }
  if (status != HeatStatus::converged) {
    temperature = per_part(OfParts::Constant(c.heat->ambient));
    warnings.push_back(no_steady_state(status, reason));
  }
  const Oils oils = warm_oils(c, oil_temperatures(of_parts(temperature)));
  LifeResult result = analyze_life(warm(c, temperature), std::move(contacts), std::move(history), oils);
  result.temperature_status = status;
  if (status == HeatStatus::converged)
    result.temperature = temperature;
  else if (!result.failure)
    result.failure = std::string(name(status)) + ": " + reason;
  result.warnings.insert(result.warnings.end(), warnings.begin(), warnings.end());
  return result;
}

Conditions at_temperatures(const Conditions& c, const LoadCase& load, const OfParts& temperature) {
  Conditions warm = c;
  warm.load_cases = {load};
  warm.deviations.temperature = per_part(temperature);
  return warm;
}

Oils warm_oils(const Conditions& c, const PerInterface<double>& oil) {
  return c.lubricant ? oils_at(*c.lubricant, oil) : Oils{};
}

bool heat_may_grow(const Conditions& c) { return c.friction->is(contact::Lubrication::mixed); }

CaseLosses::CaseLosses(const Conditions& c, const Contacts& contacts, const LoadCase& load, LoadCase::Share share)
    : conditions_(c),
      contacts_(contacts),
      load_(load),
      models_(c, contacts, Oils{}),
      rough_models_(with_coarse_patches(c), contacts, Oils{}) {
  load_.share = share;
  // The estimate is scaled: under preload without a load any force shows how heat follows the oil.
  if (share == LoadCase::Share::equal && load_.axial_force == 0.0) load_.axial_force = 1e3;
}

std::optional<Losses> CaseLosses::at(const OfParts& temperature) {
  const Oils oils = warm_oils(conditions_, oil_temperatures(temperature));
  OfParts heat = OfParts::Zero();
  PowerFlow flow;
  // Heat and power of the rollers of a nut; false where they have no slip.
  const auto add = [&](const SlipModel& model, const std::optional<SlipEquilibrium>& known) {
    const SlipEquilibrium found = known ? *known : find_slip_equilibrium(model);
    if (!found.ok()) {
      failure_ = fmt::format("slip ends as {}", name(found.status));
      return false;
    }
    slip_ratio_ = found.balance.motion.slip_ratio;
    const PowerFlow of_nut = power_flow(model, found.balance, drive_torques(model, found.balance));
    heat += heat_of(lost_power(model, found.balance));
    flow.shaft += of_nut.shaft;
    flow.load += of_nut.load;
    return true;
  };
  const auto all = [&] {
    return std::optional(Losses{heat, std::max(flow.shaft, 0.0) + std::max(flow.load, 0.0),
                                std::max(-flow.shaft, 0.0) + std::max(-flow.load, 0.0)});
  };
  if (load_.share == LoadCase::Share::equal) return add(models_.equal_shares(load_, &oils), {}) ? all() : std::nullopt;
  const Conditions warm = at_temperatures(conditions_, load_, temperature);
  const SlipModels models(warm, contacts_, oils);
  std::array<std::optional<SlipEquilibrium>, 2> known;
  LoadCaseResult found;
  if (slip_takes_running_loads(conditions_.model, load_.share)) {
    RunningSolver solver(warm, contacts_, models);
    found = solver.solve(load_, Detail::numbers, known[0]);
    known[1] = solver.second_nut();
  } else {
    found = has_both_flanks(conditions_, load_.share) ? FlankSolver(warm, contacts_).solve(load_)
                                                      : analyze(warm, contacts_, kManyDesigns).load_cases.front();
  }
  if (!found.threads)
    failure_ = found.warnings.empty() ? "the loads of the threads do not converge" : sentence(found.warnings.back());
  if (!found.threads) return std::nullopt;
  const std::vector<SlipModel> nuts = models.of_nuts(found);
  for (std::size_t n = 0; n < nuts.size(); ++n)
    if (!add(nuts[n], known[n])) return std::nullopt;
  return all();
}

std::optional<OfParts> CaseLosses::estimate(const SlipModels& models, const PerInterface<double>& oil) const {
  const Oils oils = warm_oils(conditions_, oil);
  const SlipModel model = models.equal_shares(load_, &oils);
  SlipBalance balance;
  if (!balance_at(model, slip_ratio_, balance)) return std::nullopt;
  return heat_of(lost_power(model, balance));
}

void TemperatureBox::include(const OfParts& c) {
  least = least.cwiseMin(c);
  greatest = greatest.cwiseMax(c);
}

bool TemperatureBox::contains(const TemperatureBox& o) const {
  return (least.array() <= o.least.array()).all() && (greatest.array() >= o.greatest.array()).all();
}

TemperatureBox TemperatureBox::widened(double margin) const {
  const OfParts by = (0.1 * (greatest - least).array() + margin).matrix();
  return {least - by, greatest + by};
}

OfParts table_coordinates(const OfParts& t) { return coordinates_by_parts() * t; }

LossTable::LossTable(const Losses& constant) {
  Panel all;
  all.coefficients = {flows_of(constant)};
  layers_ = {{Node{std::move(all)}}};
}

std::optional<LossTable> LossTable::over(const TemperatureBox& box, const At& at, bool by_rollers, const Effort& effort,
                                         LossTable rough) {
  int evaluations = 0;
  const auto panel_on = [&](const TemperatureBox& here) {
    return rough.fit(here, at, by_rollers, effort.accuracy, evaluations);
  };
  std::optional<Panel> whole = panel_on(box);
  if (!whole) return std::nullopt;
  Layer layer{Node{std::move(*whole)}};
  while (evaluations < effort.evaluations) {
    std::optional<std::size_t> next;
    for (std::size_t i = 0; i < layer.size(); ++i)
      if (layer[i].along < 0 && layer[i].panel.worst(effort.accuracy) &&
          (!next || layer[i].panel.error > layer[*next].panel.error))
        next = i;
    if (!next) break;
    const int along = *layer[*next].panel.worst(effort.accuracy);
    TemperatureBox below = layer[*next].panel.box, above = below;
    const double middle = 0.5 * (below.least[along] + below.greatest[along]);
    below.greatest[along] = above.least[along] = middle;
    std::optional<Panel> lower = panel_on(below), upper = panel_on(above);
    if (!lower || !upper) return std::nullopt;
    layer[*next] = {{}, along, middle, layer.size()};
    layer.push_back({std::move(*lower)});
    layer.push_back({std::move(*upper)});
  }
  LossTable table = std::move(rough);
  table.error_ = 0.0;
  for (const Node& node : layer) table.error_ = std::max(table.error_, node.panel.error);
  table.layers_.push_back(std::move(layer));
  return table;
}

std::optional<LossTable::Panel> LossTable::fit(const TemperatureBox& box, const At& exact, bool by_rollers,
                                               double accuracy, int& evaluations) const {
  Panel panel;
  panel.box = box;
  const OfParts middle = 0.5 * (box.least + box.greatest);
  const OfParts half = 0.5 * (box.greatest - box.least);
  double largest = 0.0;
  const auto left_at = [&](const OfParts& unit) -> std::optional<Flows> {
    const OfParts t = temperatures(middle + half.cwiseProduct(unit));
    const std::optional<Losses> losses = exact(t);
    ++evaluations;
    if (!losses) return std::nullopt;
    const Flows flows = flows_of(*losses);
    largest = std::max(largest, flows.lpNorm<Eigen::Infinity>());
    return flows - value_at(t);
  };
  std::map<std::array<int, 3>, Flows> known;
  std::array<int, 3> n{3, 3, by_rollers ? 3 : 1};
  while (true) {
    panel.points = n;
    std::vector<Flows> values;
    for (int i = 0; i < n[0]; ++i)
      for (int j = 0; j < n[1]; ++j)
        for (int k = 0; k < n[2]; ++k) {
          const auto [found, is_new] =
              known.try_emplace({on_finest(i, n[0]), on_finest(j, n[1]), on_finest(k, n[2])}, Flows::Zero());
          if (is_new) {
            const std::optional<Flows> left =
                left_at({extreme_point(i, n[0]), extreme_point(j, n[1]), extreme_point(k, n[2])});
            if (!left) return std::nullopt;
            found->second = *left;
          }
          values.push_back(found->second);
        }
    panel.transform(values, largest);
    panel.error = std::ranges::max(panel.last);
    if (panel.error <= accuracy) break;
    // More points where they lack, the worst coordinate first.
    std::array<std::size_t, 3> order{0, 1, 2};
    std::ranges::sort(order, std::greater{}, [&](std::size_t d) { return panel.last[d]; });
    for (const std::size_t d : order) {
      const int more = 2 * n[d] - 1;
      if (panel.last[d] > accuracy && more <= kMostPoints && n[0] * n[1] * n[2] / n[d] * more <= kMostOfAPanel)
        n[d] = more;
    }
    if (n == panel.points) return panel;
  }
  for (const auto& [x, y, z] : kChecks) {
    const OfParts unit(x, y, by_rollers ? z : 0.0);
    const std::optional<Flows> left = left_at(unit);
    if (!left) return std::nullopt;
    Value fitted;
    panel.add(middle + half.cwiseProduct(unit), false, fitted);
    const Flows off = *left - fitted.value;
    if (largest > 0.0) panel.error = std::max(panel.error, off.lpNorm<Eigen::Infinity>() / largest);
  }
  return panel;
}

void LossTable::Panel::transform(const std::vector<Flows>& values, double largest) {
  const auto& n = points;
  coefficients.clear();
  last = {};
  std::array<Basis, 3> size{};
  for (int p = 0; p < n[0]; ++p)
    for (int q = 0; q < n[1]; ++q)
      for (int r = 0; r < n[2]; ++r) {
        Flows sum = Flows::Zero();
        std::size_t at = 0;
        for (int i = 0; i < n[0]; ++i)
          for (int j = 0; j < n[1]; ++j) {
            const double ij = coefficient_weight(i, p, n[0]) * coefficient_weight(j, q, n[1]);
            for (int k = 0; k < n[2]; ++k) sum += ij * coefficient_weight(k, r, n[2]) * values[at++];
          }
        coefficients.push_back(sum);
        const std::size_t number[] = {static_cast<std::size_t>(p), static_cast<std::size_t>(q),
                                      static_cast<std::size_t>(r)};
        for (std::size_t d = 0; d < 3; ++d)
          size[d][number[d]] = std::max(size[d][number[d]], sum.lpNorm<Eigen::Infinity>());
      }
  if (largest <= 0.0) return;
  for (std::size_t d = 0; d < 3; ++d)
    if (n[d] > 1) last[d] = left_out(size[d], static_cast<std::size_t>(n[d])) / largest;
}

std::optional<int> LossTable::Panel::worst(double accuracy) const {
  if (error <= accuracy) return std::nullopt;
  std::optional<int> found;
  for (int d = 0; d < 3; ++d) {
    const auto at = static_cast<std::size_t>(d);
    if (points[at] > 1 && box.greatest[d] - box.least[d] > kNarrowest &&
        (!found || last[at] > last[static_cast<std::size_t>(*found)]))
      found = d;
  }
  return found;
}

OfParts LossTable::Panel::unit(const OfParts& c) const {
  const OfParts half = 0.5 * (box.greatest - box.least);
  OfParts x = c - 0.5 * (box.least + box.greatest);
  for (int d = 0; d < 3; ++d) x[d] = half[d] > 0.0 ? x[d] / half[d] : 0.0;
  return x;
}

void LossTable::Panel::add(const OfParts& c, bool with_slopes, Value& sum) const {
  const OfParts x = unit(c);
  std::array<Basis, 3> b, s;
  for (std::size_t d = 0; d < 3; ++d) chebyshev(x[static_cast<int>(d)], points[d], b[d], s[d]);
  ByTemperature slope = ByTemperature::Zero();
  std::size_t at = 0;
  for (std::size_t p = 0; p < static_cast<std::size_t>(points[0]); ++p)
    for (std::size_t q = 0; q < static_cast<std::size_t>(points[1]); ++q) {
      Flows along = Flows::Zero(), slope_along = Flows::Zero();
      for (std::size_t r = 0; r < static_cast<std::size_t>(points[2]); ++r) {
        const Flows& f = coefficients[at++];
        along += b[2][r] * f;
        if (with_slopes) slope_along += s[2][r] * f;
      }
      sum.value += b[0][p] * b[1][q] * along;
      if (!with_slopes) continue;
      slope.col(0) += s[0][p] * b[1][q] * along;
      slope.col(1) += b[0][p] * s[1][q] * along;
      slope.col(2) += b[0][p] * b[1][q] * slope_along;
    }
  if (!with_slopes) return;
  const OfParts half = 0.5 * (box.greatest - box.least);
  for (int d = 0; d < 3; ++d)
    if (half[d] > 0.0) sum.by_temperature += slope.col(d) / half[d] * coordinates_by_parts().row(d);
}

const LossTable::Panel& LossTable::panel_at(const Layer& layer, const OfParts& c) {
  const Node* node = &layer.front();
  while (node->along >= 0) node = &layer[node->below + (c[node->along] > node->halved_at ? 1 : 0)];
  return node->panel;
}

LossTable::Value LossTable::at(const OfParts& t, bool with_slopes) const {
  const OfParts c = table_coordinates(t);
  Value sum;
  for (const Layer& layer : layers_) panel_at(layer, c).add(c, with_slopes, sum);
  return sum;
}

}  // namespace prs
