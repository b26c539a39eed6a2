#include "prs/heat/duty_cycle.h"

#include <Eigen/LU>
#include <boost/math/tools/toms748_solve.hpp>

#include "prs/model/quantity_text.h"

namespace prs {
namespace {

constexpr double kStepTolerance = 1e-8;    // Tolerance of a step [K].
constexpr double kPeriodTolerance = 1e-8;  // Tolerance between start and end of the cycle [K].
constexpr double kTellTable = 1e-6;        // Error of a table above which a warning is given.
constexpr double kTellMission = 1e-4;      // Error in a mission.
constexpr double kLeastPoints = 200;       // Number of points of a cycle, for its picture.
constexpr int kColumns = 6;                // Columns of the extrapolation.
constexpr double kShortest = 1e-6;         // Step over the fastest time constant.
constexpr double kNoOutput = 1e-9;         // Share of the energy input that counts as no output.
constexpr double kRoughMargin = 0.25;      // Margin of rough tables around the cycle [K].
constexpr double kMargin = 0.02;           // Margin of good ones, some times the error of a cycle with rough ones [K].
constexpr double kKeptMargin = 3.0;        // Margin of tables that serve other cycles too [K].
constexpr double kFirstReach = 40.0;       // Rise up to which losses of a mission are first tabulated [K].

constexpr int kMostCorrections = 4;  // Corrections of a table along paths, after which it is made over their range.
constexpr int kMostOnPath = 300;     // Exact losses of a correction.
/// Effort to find the range of temperatures, and then over it; with solved shares the exact losses cost twenty times
/// those of equal ones.
constexpr LossTable::Effort kRoughTable{1e-3, 200}, kTable{1e-9, 6000}, kSolvedTable{3e-9, 1500};
/// A mission visits ten times the range of a cycle, and nothing is iterated on its end.
constexpr LossTable::Effort kMissionTable{3e-7, 600}, kSolvedMissionTable{1e-5, 150};

double largest_of(const OfParts& v) { return v.lpNorm<Eigen::Infinity>(); }

/// Temperatures of the parts, the integrals over time of their rise above ambient [K s], and the
/// energies lost, in and out [J].
using State = Eigen::Vector<double, 9>;

State starting_at(const OfParts& t) {
  State x = State::Zero();
  x.head<3>() = t;
  return x;
}

/// The lumped parts under one table of losses.
struct Warming {
  const ThermalNetwork& network;
  const OfParts& capacity;
  const LossTable& table;

  /// One extrapolated step; none if it does not reach the tolerance.
  std::optional<State> step(const State& from, double h, int& columns) const {
    const auto [losses, by_temperature] = table.at(from.head<3>());
    const State rate = rate_at(from, losses);
    Derivative derivative;
    derivative << capacity.cwiseInverse().asDiagonal() * (by_temperature.topRows<3>() - network.conductance),
        Eigen::Matrix3d::Identity(), by_temperature.topRows<3>().colwise().sum(), by_temperature.bottomRows<2>();
    std::array<State, kColumns> row;
    for (int j = 0; j < kColumns; ++j) {
      State next = steps(from, rate, derivative, h, j + 1);
      // Aitken and Neville: row[k] becomes T_{j,k}.
      for (int k = 0; k < j; ++k) {
        const State before = std::exchange(row[static_cast<std::size_t>(k)], next);
        next += (next - before) / ((j + 1.0) / (j - k) - 1.0);
      }
      row[static_cast<std::size_t>(j)] = next;
      if (j == 0) continue;
      const double error = largest_of((next - row[static_cast<std::size_t>(j - 1)]).head<3>());
      if (!std::isfinite(error)) return std::nullopt;
      if (error <= kStepTolerance) {
        columns = j + 1;
        return next;
      }
    }
    return std::nullopt;
  }

  /// Highest temperatures of the parts in a step, and their times from its start.
  struct Peak {
    OfParts greatest, time;
  };
  /// Peaks in a step of h: inside it for parts that warm at its start and cool at its end.
  Peak peak_within(const State& from, const State& to, double h) const {
    const auto rate = [&](const State& x) { return rate_at(x, table.value_at(x.head<3>())); };
    const State first = rate(from), last = rate(to);
    Peak peak{from.head<3>().cwiseMax(to.head<3>()), OfParts::Constant(h)};
    for (int p = 0; p < 3; ++p) {
      if (!(first[p] > 0.0 && last[p] < 0.0)) continue;
      const auto slope = [&](double time) {
        int columns = 0;
        const std::optional<State> then = step(from, time, columns);
        if (!then) return 0.0;
        if ((*then)[p] > peak.greatest[p]) peak.greatest[p] = (*then)[p], peak.time[p] = time;
        return rate(*then)[p];
      };
      std::uintmax_t most = 8;
      boost::math::tools::toms748_solve(slope, 0.0, h, first[p], last[p], boost::math::tools::eps_tolerance<double>(20),
                                        most);
    }
    return peak;
  }

  /// Time from the start of a step until a part reaches `limit`, which it does up to the time `peak`.
  double time_to(double limit, int part, const State& from, double peak) const {
    if (from[part] >= limit) return 0.0;
    const auto excess = [&](double time) {
      int columns = 0;
      const std::optional<State> then = step(from, time, columns);
      return then ? (*then)[part] - limit : 0.0;
    };
    std::uintmax_t most = 60;
    const auto [early, late] =
        boost::math::tools::toms748_solve(excess, 0.0, peak, from[part] - limit, std::max(excess(peak), 0.0),
                                          boost::math::tools::eps_tolerance<double>(50), most);
    return 0.5 * (early + late);
  }

  using Derivative = Eigen::Matrix<double, 9, 3>;

  State rate_at(const State& x, const Flows& losses) const {
    const OfParts rise = (x.head<3>().array() - network.ambient).matrix();
    State rate;
    rate << (losses.head<3>() - network.conductance * rise).cwiseQuotient(capacity), rise, losses.head<3>().sum(),
        losses.tail<2>();
    return rate;
  }

  /// State after n linearly implicit Euler steps of h/n in total.
  State steps(const State& from, State rate, const Derivative& derivative, double h, int n) const {
    const double small = h / n;
    const Eigen::Matrix3d inverse = (Eigen::Matrix3d::Identity() - small * derivative.topRows<3>()).inverse();
    State x = from;
    for (int i = 0; i < n; ++i) {
      if (i > 0) rate = rate_at(x, table.value_at(x.head<3>()));
      const OfParts change = inverse * (small * rate.head<3>());
      x += small * (rate + derivative * change);
    }
    return x;
  }
};

/// The duty in the form for lumped parts.
class RepeatedCycle {
 public:
  RepeatedCycle(const ThermalNetwork& network, const OfParts& capacity, std::span<const DutySegment> segments)
      : network_(network), capacity_(capacity), segments_(segments) {
    for (const DutySegment& s : segments_) period_ += s.duration;
  }

  double period() const { return period_; }

  /// Integrates over the cycle; calls `visit(table, time, state, step)` at every step's end, where step(use) calls
  /// `use(warming, state before, duration)` for more about the step. Returns false if steps become too small or
  /// temperatures leave all bounds.
  template <class Visit>
  bool run(const std::vector<LossTable>& tables, State& state, Visit visit) const {
    const double longest = period_ / kLeastPoints;
    const double shortest = kShortest * capacity_.cwiseQuotient(network_.conductance.diagonal()).minCoeff();
    double start = 0.0, h = longest;
    for (const DutySegment& segment : segments_) {
      const Warming warming{network_, capacity_, tables[segment.table]};
      double done = 0.0;
      while (done < segment.duration) {
        const double left = segment.duration - done;
        // Equal steps to the end, to avoid a tiny last one.
        const double here = left / std::ceil(left / std::min({h, longest, left}) - 1e-9);
        int columns = 0;
        const std::optional<State> next = warming.step(state, here, columns);
        if (!next) {
          h = 0.5 * here;
          if (h < std::min(shortest, 1e-9 * segment.duration)) return false;
          continue;
        }
        const State before = std::exchange(state, *next);
        const OfParts t = state.head<3>();
        if (!(t.minCoeff() > 0.0 && t.maxCoeff() < 2.0 * kHottest)) return false;
        done = here >= left * (1.0 - 1e-12) ? segment.duration : done + here;
        if (columns < kColumns - 1) h = std::max(h, 2.0 * here);
        visit(segment.table, start + done, state, [&](auto use) { use(warming, before, here); });
      }
      start += segment.duration;
    }
    return true;
  }

  /// Temperatures that are equal at the start and the end, from a guess. Newton's matrix is reused while it converges.
  using Factors = std::optional<Eigen::PartialPivLU<Eigen::Matrix3d>>;
  std::optional<OfParts> periodic(const std::vector<LossTable>& tables, OfParts t, Factors& factors) const {
    const auto after = [&](const OfParts& from) -> std::optional<OfParts> {
      State x = starting_at(from);
      if (!run(tables, x, [](std::size_t, double, const State&, const auto&) {})) return std::nullopt;
      return x.head<3>();
    };
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 50; ++i) {
      const std::optional<OfParts> end = after(t);
      if (!end) return std::nullopt;
      if (!factors) {
        constexpr double kDelta = 0.25;
        Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
        for (int p = 0; p < 3; ++p) {
          const std::optional<OfParts> moved = after(t + kDelta * OfParts::Unit(p));
          if (!moved) return std::nullopt;
          map.col(p) -= (*moved - *end) / kDelta;
        }
        factors.emplace(map);
      }
      const OfParts step = factors->solve(*end - t);
      const double size = largest_of(step);
      t += step;
      if (size <= kPeriodTolerance) return t;
      if (size > 0.3 * before) factors.reset();
      before = size;
    }
    return std::nullopt;
  }

 private:
  const ThermalNetwork& network_;
  const OfParts& capacity_;
  std::span<const DutySegment> segments_;
  double period_ = 0.0;
};

/// A load case named in the duty.
struct DutyCase : LossShare {
  /// Losses with equal shares, if the load case's shares depend on the temperatures.
  std::unique_ptr<CaseLosses> equal;

  LossTable::Effort equal_effort = kTable, effort = kSolvedTable;

  double accuracy() const { return (equal ? effort : equal_effort).accuracy; }
};

struct Duty {
  std::vector<DutyCase> cases;  ///< Load cases without repetition.
  /// Segments of the cycle, or of all cycles of a mission. Table 0 is that of rests, 1 that of the first load case.
  std::vector<DutySegment> segments;
  /// Start of a mission.
  std::optional<OfParts> start;
};

Duty duty_of(const Conditions& c, const Contacts& contacts) {
  Duty duty;
  for (const Heat::DutyStep& step : c.heat->duty) {
    if (!step.load_case) {
      duty.segments.push_back({0, step.time()});
      continue;
    }
    const auto known = std::ranges::find(duty.cases, *step.load_case, &DutyCase::name);
    const auto index = static_cast<std::size_t>(known - duty.cases.begin());
    if (known == duty.cases.end()) {
      const LoadCase& load = *std::ranges::find(c.load_cases, *step.load_case, &LoadCase::name);
      const auto with = [&](LoadCase::Share share) { return std::make_unique<CaseLosses>(c, contacts, load, share); };
      duty.cases.push_back({{0.0, with(load.share), load.name},
                            load.share == LoadCase::Share::solved ? with(LoadCase::Share::equal) : nullptr});
    }
    duty.cases[index].share += step.time();
    duty.segments.push_back({index + 1, step.time()});
  }
  for (DutyCase& known : duty.cases) known.share /= c.heat->period();
  if (!c.heat->cycles) return duty;
  duty.start = of_parts(c.heat->start_temperature());
  for (DutyCase& known : duty.cases) known.equal_effort = kMissionTable, known.effort = kSolvedMissionTable;
  const std::size_t once = duty.segments.size();
  duty.segments.reserve(once * static_cast<std::size_t>(*c.heat->cycles));
  for (int cycle = 1; cycle < *c.heat->cycles; ++cycle)
    std::copy_n(duty.segments.begin(), once, std::back_inserter(duty.segments));
  return duty;
}

/// Share of each load case in the power that all bring in or lose over the cycle, at these temperatures: the weight of
/// an error of its table; 1 in a mission.
std::vector<double> shares_of_power(const Duty& duty, const std::vector<LossTable>& tables, const OfParts& at) {
  std::vector<double> shares;
  if (duty.start) return std::vector<double>(duty.cases.size(), 1.0);
  double sum = 0.0;
  for (std::size_t k = 0; k < duty.cases.size(); ++k)
    sum += shares.emplace_back(duty.cases[k].share * tables[k + 1].value_at(at).lpNorm<Eigen::Infinity>());
  for (double& share : shares) share = sum > 0.0 ? share / sum : 1.0;
  return shares;
}

/// Losses of a load case with an error whose share of the cycle's power is `weight` times as large. With solved shares
/// equal ones come first: they cost little, and the difference is small.
std::optional<LossTable> table_over(const TemperatureBox& box, const DutyCase& load, bool good, double weight) {
  const auto of = [&](CaseLosses& losses, bool by_rollers, LossTable::Effort effort, LossTable rough) {
    effort.accuracy = std::min(effort.accuracy / weight, kRoughTable.accuracy);
    return LossTable::over(
        box, [&losses](const OfParts& t) { return losses.at(t); }, by_rollers, good ? effort : kRoughTable,
        std::move(rough));
  };
  if (!load.equal) return of(*load.losses, false, load.equal_effort, {});
  const std::optional<LossTable> equal = of(*load.equal, false, load.equal_effort, {});
  return of(*load.losses, true, load.effort, equal.value_or(LossTable{}));
}

/// Temperatures, as coordinates of tables, one after the other while a load case acts.
using Path = std::vector<OfParts>;

/// Path of each load case in a cycle from `start`.
std::vector<Path> paths_from(const OfParts& start, const RepeatedCycle& cycle, const std::vector<LossTable>& tables) {
  std::vector<Path> paths(tables.size());
  State state = starting_at(start);
  std::size_t last = 0;
  OfParts before = start;
  cycle.run(tables, state, [&](std::size_t table, double, const State& at, const auto&) {
    const OfParts t = at.head<3>();
    if (table != last) paths[table].push_back(table_coordinates(before));
    paths[table].push_back(table_coordinates(t));
    last = table, before = t;
  });
  for (Path& path : paths)
    if (path.empty()) path = {table_coordinates(start)};
  return paths;
}

std::vector<TemperatureBox> ranges_of(const std::vector<Path>& paths) {
  std::vector<TemperatureBox> boxes;
  for (const Path& path : paths) boxes.push_back(around(path));
  return boxes;
}

/// A rough table that is corrected along the path of its load case alone.
class Corrected {
 public:
  enum class Outcome { holds, corrected, fails };

  bool is_begun() const { return rough_.has_value(); }
  /// Corrects the table along a path, unless it holds there with this error. Fails where corrections do not become
  /// small from path to path, and where a path comes back to temperatures.
  Outcome follow(const Path& path, CaseLosses& losses, double accuracy, LossTable& table) {
    if (is_begun() && holds(path, losses, accuracy, table)) return Outcome::holds;
    if (!is_begun()) rough_ = table;
    if (++corrections_ > kMostCorrections) return Outcome::fails;
    std::optional<LossTable> next = LossTable::along(
        path, [&](const OfParts& t) { return losses.at(t); }, {accuracy, kMostOnPath}, *rough_);
    if (!next) return Outcome::fails;
    table = std::move(*next);
    return Outcome::corrected;
  }

 private:
  /// Whether the losses at three places of the path are those of the table.
  static bool holds(const Path& path, CaseLosses& losses, double accuracy, const LossTable& table) {
    for (const std::size_t sixth : {1U, 3U, 5U}) {
      const OfParts t = temperatures_of(path[(path.size() - 1) * sixth / 6]);
      const std::optional<Losses> exact = losses.at(t);
      if (!exact || table.distance(t, *exact) > accuracy) return false;
    }
    return true;
  }

  std::optional<LossTable> rough_;
  int corrections_ = 0;
};

/// The periodic cycle, or a mission.
struct FoundCycle : DutyLosses {
  HeatStatus status = HeatStatus::converged;
  std::string reason = {};
};

bool contain(const std::vector<TemperatureBox>& covered, const std::vector<TemperatureBox>& visited) {
  for (std::size_t k = 0; k < covered.size(); ++k)
    if (!covered[k].contains(visited[k + 1])) return false;
  return true;
}

/// The cycle with known tables; none if it leaves their range.
std::optional<FoundCycle> repeated(const RepeatedCycle& cycle, const DutyLosses& known) {
  FoundCycle found{known};
  RepeatedCycle::Factors factors;
  const std::optional<OfParts> start = cycle.periodic(found.tables, found.start, factors);
  if (!start || !contain(found.covered, ranges_of(paths_from(*start, cycle, found.tables)))) return std::nullopt;
  found.start = *start;
  return found;
}

/// A box without temperatures that are further than `reach` [K] from `start`: constant losses overestimate.
TemperatureBox within_reach(const TemperatureBox& box, const OfParts& start, double reach) {
  const OfParts least = table_coordinates(start).array() - reach, greatest = table_coordinates(start).array() + reach;
  return {box.least.cwiseMax(least).cwiseMin(greatest), box.greatest.cwiseMin(greatest).cwiseMax(least)};
}

/// Iteration: each round makes tables over the temperatures of the previous one and a margin around them: rough ones,
/// and good ones after the range is known. Rough tables of solved shares, whose losses take long, are corrected along
/// the path of the temperatures alone, in each round until a table holds on the next path; if none does, good ones
/// follow. In a mission the range grows from the start. `kept`: whether the tables serve other cycles too, in which
/// other load cases may weigh more.
FoundCycle find_cycle(const RepeatedCycle& cycle, const Duty& duty, const OfParts& guess, bool kept) {
  constexpr int kMostRounds = 12;
  const std::size_t cases = duty.cases.size();
  FoundCycle found{{std::vector<LossTable>(cases + 1), std::vector<TemperatureBox>(cases), guess}};
  for (std::size_t k = 0; k < cases; ++k)
    if (const std::optional<Losses> losses = duty.cases[k].losses->at(guess)) found.tables[k + 1] = LossTable(*losses);
  const std::vector<double> weights =
      kept ? std::vector<double>(cases, 1.0) : shares_of_power(duty, found.tables, guess);

  const bool wide = kept || duty.start;
  bool good = false;
  RepeatedCycle::Factors factors;
  std::vector<TemperatureBox>& covered = found.covered;
  std::vector<Corrected> corrected(cases);
  std::vector<bool> whole(cases, false);  // Whether a table is good over its range.
  double reach = kFirstReach;
  for (int round = 0; round < kMostRounds; ++round, reach *= 2.0) {
    if (!duty.start) {
      const std::optional<OfParts> start = cycle.periodic(found.tables, found.start, factors);
      if (!start)
        return ended(found, HeatStatus::no_steady_state,
                     "the temperatures of the cycle do not become periodic; give the "
                     "parts more conductance, less load or more rest");
      found.start = *start;
    }
    const std::vector<Path> paths = paths_from(found.start, cycle, found.tables);
    std::vector<TemperatureBox> visited = ranges_of(paths);
    if (duty.start)
      for (TemperatureBox& box : visited)
        box = within_reach(box, found.start, std::min(reach, kHottest - found.start.maxCoeff()));
    const auto is_covered = [&](std::size_t k) { return round > 0 && covered[k].contains(visited[k + 1]); };
    const bool was_good = std::exchange(good, good || (round > 0 && contain(covered, visited)));
    bool is_settled = good;
    for (std::size_t k = 0; k < cases; ++k) {
      LossTable& table = found.tables[k + 1];
      const DutyCase& load = duty.cases[k];
      if (good && is_covered(k)) {
        const double accuracy = std::min(load.accuracy() / weights[k], kRoughTable.accuracy);
        const bool is_fine = !wide && !corrected[k].is_begun() && table.error() <= accuracy;
        if (whole[k] || is_fine) continue;
        if (load.equal && !wide) {
          const Corrected::Outcome outcome = corrected[k].follow(paths[k + 1], *load.losses, accuracy, table);
          is_settled = is_settled && outcome == Corrected::Outcome::holds;
          if (outcome != Corrected::Outcome::fails) continue;
        }
      }
      is_settled = false;
      // Constant losses overestimate, so that their temperatures are not kept.
      TemperatureBox box = visited[k + 1];
      if (round > 1 && good == was_good) box.include(covered[k].least), box.include(covered[k].greatest);
      covered[k] = box.widened(kept ? kKeptMargin : good && !wide ? kMargin : kRoughMargin);
      std::optional<LossTable> next = table_over(covered[k], load, good, weights[k]);
      if (!next) return ended(found, HeatStatus::no_steady_state, load.failure() + " at temperatures of the cycle");
      table = std::move(*next);
      whole[k] = good;
    }
    if (is_settled) return found;
  }
  return ended(found, HeatStatus::iteration_limit,
               fmt::format("the range of temperatures of the cycle is not settled after {} rounds", kMostRounds));
}

}  // namespace

OfParts heat_capacities(const Conditions& c, const Mechanism& m) {
  const Heat& heat = *c.heat;
  if (heat.capacity) return {heat.capacity->screw, heat.capacity->rollers, heat.capacity->nut};
  const Structure& s = *c.structure;
  const PerPart<double> volume{screw_body(m, s.screw, s.nut.length).volume, m.rollers * roller_body(m, s.roller).volume,
                               nut_body(m, s.nut).volume};
  PerPart<double> capacity;
  for (const Part p : kParts) capacity[p] = *heat.specific_heat * *(*c.materials)[p].density * volume[p];
  return of_parts(capacity);
}

HeatCycle warming(const ThermalNetwork& network, const OfParts& capacity, std::span<const DutySegment> segments,
                  const std::vector<LossTable>& tables, const OfParts& start, std::optional<double> limit) {
  const RepeatedCycle cycle(network, capacity, segments);
  HeatCycle result;
  result.period = cycle.period();
  OfParts peak = start;
  State state = starting_at(start);
  const auto keep = [&](double time) {
    result.time.push_back(time);
    for (const Part p : kParts) result.temperature[p].push_back(state[static_cast<int>(p)]);
  };
  keep(0.0);
  const bool ends = cycle.run(tables, state, [&](std::size_t, double time, const State&, const auto& step) {
    step([&](const Warming& warming, const State& before, double duration) {
      const Warming::Peak within = warming.peak_within(before, state, duration);
      peak = peak.cwiseMax(within.greatest);
      for (const Part part : kParts) {
        const int p = static_cast<int>(part);
        if (limit && !result.time_to_limit[part] && within.greatest[p] >= *limit)
          result.time_to_limit[part] = time - duration + warming.time_to(*limit, p, before, within.time[p]);
      }
    });
    keep(time);
  });
  result.peak = per_part(peak);
  result.mean = per_part((state.segment<3>(3).array() / result.period + network.ambient).matrix());
  result.energy_lost = state[6];
  result.energy_in = state[7];
  if (state[8] > kNoOutput * state[7]) result.efficiency = state[8] / state[7];
  result.start = per_part(start), result.end = per_part(state.head<3>());
  if (ends && peak.maxCoeff() < kHottest) return ended(result, HeatStatus::converged, {});
  return ended(result, HeatStatus::no_steady_state,
               fmt::format("the parts pass {} within {:.4g} s; give them more conductance, less load, less speed or "
                           "less time",
                           celsius(kHottest), result.time.back()));
}

HeatCycle duty_cycle(const Conditions& c, const Contacts& contacts, std::vector<Warning>& warnings,
                     const DutyLosses* known, DutyLosses* kept, std::optional<double> temperature_limit) {
  const ThermalNetwork network = thermal_network(*c.heat);
  const OfParts capacity = heat_capacities(c, contacts.mechanism);
  const Duty duty = duty_of(c, contacts);
  const RepeatedCycle cycle(network, capacity, duty.segments);
  const int cycles = c.heat->cycles.value_or(1);
  HeatCycle result;
  result.period = cycle.period() / cycles;
  result.cycles = cycles;
  if (duty.start) result.start = per_part(*duty.start);

  std::optional<FoundCycle> again = known && !duty.start ? repeated(cycle, *known) : std::nullopt;
  if (!again) {
    OfParts guess;
    if (duty.start) {
      guess = *duty.start;
    } else {
      const std::vector<LossShare> shares(duty.cases.begin(), duty.cases.end());
      const SteadyHeat steady =
          find_steady_heat(network, mean_heat(shares, shares, c.friction->is(contact::Lubrication::mixed)));
      if (!steady.converged()) return ended(result, steady.status, steady.reason);
      guess = steady.temperature;
    }
    again = find_cycle(cycle, duty, guess, kept != nullptr);
    if (again->status != HeatStatus::converged) return ended(result, again->status, again->reason);
    if (kept) *kept = *again;
  }
  const FoundCycle& found = *again;
  const std::vector<double> weights = shares_of_power(duty, found.tables, found.start);
  for (std::size_t k = 0; k < duty.cases.size(); ++k)
    if (const double limit = duty.start ? kTellMission : kTellTable, error = weights[k] * found.tables[k + 1].error();
        error > limit)
      warnings.push_back(Warning{"heat.duty", fmt::format("rough_losses_of_{}", duty.cases[k].name),
                                 fmt::format("the losses of `{}` are not smooth over the temperatures of the "
                                             "cycle: interpolated to {{value}} of all",
                                             duty.cases[k].name)}
                             .with(error, limit));
  result = warming(network, capacity, duty.segments, found.tables, found.start,
                   duty.start ? temperature_limit : std::nullopt);
  result.period /= cycles, result.cycles = cycles;
  if (!duty.start) result.start.reset(), result.end.reset();
  return result;
}

}  // namespace prs
