#include "prs/optimize/optimizer.h"

#include <algorithm>
#include <numeric>

#include "prs/indices.h"

namespace prs {
namespace {

struct Interrupted {};

/// Results of the designs in the order of requests, those of the journal first.
class Answers {
 public:
  Answers(const Optimization& optimization, const EvaluateDesigns& evaluate, Journal& journal,
          const OptimizeOptions& options)
      : evaluate_(evaluate),
        journal_(journal),
        options_(options),
        width_(optimization.study.responses.size()),
        total_(design_count(optimization)) {
    for (const Journal::Record& record : journal.records()) {
      // Records must be contiguous; those after damage are ignored.
      if (record.designs.first != found_) break;
      found_ = record.designs.end();
    }
  }

  std::vector<EvaluatedDesign> operator()(const std::vector<std::vector<Draw>>& designs) {
    std::vector<EvaluatedDesign> answered;
    while (answered.size() < designs.size() && asked_ < found_)
      answered.push_back(next_of_journal(designs[answered.size()]));
    if (answered.size() < designs.size()) compute(designs, answered);
    return answered;
  }

 private:
  EvaluatedDesign next_of_journal(const std::vector<Draw>& draws) {
    while (block_.first + block_.rows <= asked_) block_ = journal_.block(journal_.records()[next_record_++]);
    return row(block_, asked_++ - block_.first, draws);
  }

  void compute(const std::vector<std::vector<Draw>>& designs, std::vector<EvaluatedDesign>& answered) {
    if (options_.interrupted && options_.interrupted()) throw Interrupted{};
    const std::vector<std::vector<Draw>> rest(designs.begin() + static_cast<std::ptrdiff_t>(answered.size()),
                                              designs.end());
    RowBlock block = evaluate_(rest);
    block.first = asked_;
    journal_.append(encode(block));
    for (const auto k : indices(rest)) answered.push_back(row(block, k, rest[k]));
    asked_ += rest.size();
    if (options_.progress) options_.progress({asked_, found_, total_});
  }

  EvaluatedDesign row(const RowBlock& block, std::size_t k, const std::vector<Draw>& draws) const {
    const auto from = block.responses.begin() + static_cast<std::ptrdiff_t>(k * width_);
    EvaluatedDesign design{draws, {from, from + static_cast<std::ptrdiff_t>(width_)}, {}, 0.0};
    const auto failure = std::ranges::find(block.failures, k, &RowBlock::Failure::row);
    if (failure != block.failures.end()) design.status = failure->status;
    return design;
  }

  const EvaluateDesigns& evaluate_;
  Journal& journal_;
  const OptimizeOptions& options_;
  std::size_t width_;
  std::size_t total_;
  std::size_t asked_ = 0;        ///< Number of designs requested.
  std::size_t found_ = 0;        ///< Number of designs in the journal at the start.
  std::size_t next_record_ = 0;  ///< Index of the record after that of `block_`.
  RowBlock block_;
};

std::vector<Draw> draws_at(const Optimization& optimization, const std::vector<double>& x) {
  std::vector<Draw> draws;
  for (const auto i : indices(x)) draws.push_back(draw_at(optimization.study.factors[i], x[i]));
  return draws;
}

/// Position of the file's own value, for which `draw_at` gives that value; absent if the variable does not have it.
std::optional<double> place_of_base(const Factor& variable) {
  if (!variable.base) return std::nullopt;
  const auto& [kind, from, to] = variable.distribution;
  const std::optional<double>& number = variable.base->number;
  if (kind != Distribution::Kind::levels) {
    if (!number || *number < from || *number > to) return std::nullopt;
    return (*number - from) / (to - from);
  }
  for (const auto k : indices(variable.levels)) {
    const Level& level = variable.levels[k];
    if (level.text == variable.base->text || (level.number && level.number == number))
      return (static_cast<double>(k) + 0.5) / static_cast<double>(variable.levels.size());
  }
  return std::nullopt;
}

/// A Latin hypercube in the unit cube. The first design is that of the file, if the variables have its values.
Points first_population(const Optimization& optimization, std::uint64_t seed) {
  const std::vector<Factor>& variables = optimization.study.factors;
  Points points(optimization.population, std::vector<double>(variables.size()));
  for (const auto k : indices(points))
    for (const auto i : indices(variables)) points[k][i] = latin_hypercube_number(seed, i, k, points.size());
  std::vector<double> base;
  for (const Factor& variable : variables)
    if (const std::optional<double> x = place_of_base(variable)) base.push_back(*x);
  if (base.size() == variables.size()) points[0] = base;
  return points;
}

/// The front of the feasible designs.
std::vector<std::size_t> front_of(const Optimization& optimization, const std::vector<EvaluatedDesign>& designs) {
  std::vector<std::size_t> feasible;
  Points points;
  for (const auto k : indices(designs)) {
    if (!designs[k].is_feasible()) continue;
    feasible.push_back(k);
    points.push_back(costs(optimization, designs[k]));
  }
  std::vector<std::size_t> front = non_dominated(points);
  for (std::size_t& k : front) k = feasible[k];
  return front;
}

Search search(const Optimization& optimization, Algorithm algorithm, std::uint64_t seed, const Fitness& fitness,
              Answers& answers) {
  Search search{algorithm, {}, {}};
  const EvaluatePoints evaluate = [&](const Points& points) {
    std::vector<std::vector<Draw>> designs;
    for (const std::vector<double>& x : points) designs.push_back(draws_at(optimization, x));
    Points values;
    for (EvaluatedDesign& design : answers(designs)) {
      fitness.assess(design);
      values.push_back(fitness(design));
      search.designs.push_back(std::move(design));
    }
    return values;
  };
  modules::loaded<SearchModule>().search_cube(
      {algorithm, optimization.objectives.size(), optimization.generations, seed}, first_population(optimization, seed),
      evaluate);
  search.front = front_of(optimization, search.designs);
  return search;
}

/// Index of the design with a result and the smallest violation.
std::optional<std::size_t> nearest(const OptimizationResult& result) {
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const auto k : up_to(result.design_count()))
    if (result.design(k).violation < least) {
      least = result.design(k).violation;
      nearest = k;
    }
  return nearest;
}

OptimizationResult run(const Optimization& optimization, Answers& answers) {
  // The check has a separate seed.
  OptimizationResult result{optimization, {}, {}, {}, {}};
  const std::vector<Draw> as_in_file(optimization.study.factors.size());
  result.initial = answers({as_in_file}).front();
  const Fitness fitness(optimization, result.initial);
  fitness.assess(result.initial);
  result.search = search(optimization, optimization.algorithm, optimization.seed, fitness, answers);
  if (optimization.check) {
    result.check = search(optimization, *optimization.check, optimization.seed + kGoldenStep, fitness, answers);
    result.comparison = compare_fronts(optimization, result.initial, result.search, *result.check);
  }
  result.front = joint_front(result);
  result.compromise = compromise_of(result);
  if (!result.compromise) result.nearest = nearest(result);
  return result;
}

/// Value rounded to a power of ten, at most a millionth of the range.
double rounded(double value, double range) {
  constexpr int kMostDecimals = 22;  // Largest exact power of ten.
  const int decimals = 6 - static_cast<int>(std::floor(std::log10(range)));
  if (std::abs(decimals) > kMostDecimals) return value;
  const double power = std::pow(10.0, std::abs(decimals));
  return decimals >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
}

/// Number of designs that a thread takes at once: an equal share, at most the engine's limit.
std::size_t piece_of(const DesignEngine& engine, std::size_t designs, std::size_t threads) {
  return std::clamp<std::size_t>((designs + threads - 1) / threads, 1, engine.chunk());
}

void append(RowBlock& all, RowBlock block) {
  for (RowBlock::Failure& failure : block.failures) {
    failure.row += all.rows;
    all.failures.push_back(std::move(failure));
  }
  all.responses.insert(all.responses.end(), block.responses.begin(), block.responses.end());
  all.rows += block.rows;
}

}  // namespace

Draw draw_at(const Factor& variable, double x) {
  const auto& [kind, from, to] = variable.distribution;
  if (kind == Distribution::Kind::levels) {
    const auto count = static_cast<double>(variable.levels.size());
    const auto level = static_cast<std::size_t>(std::max(0.0, x) * count);
    return {.kind = Draw::Kind::level, .level = std::min(level, variable.levels.size() - 1)};
  }
  const double value = rounded(from + (to - from) * x, to - from);
  return {.kind = Draw::Kind::number, .number = std::clamp(value, from, to)};
}

std::optional<OptimizationResult> optimize(const Optimization& optimization, const EvaluateDesigns& evaluate,
                                           Journal& journal, const OptimizeOptions& options) {
  Answers answers(optimization, evaluate, journal, options);
  try {
    return run(optimization, answers);
  } catch (const Interrupted&) {
    journal.sync();
    return std::nullopt;
  }
}

EvaluateDesigns evaluate_in_parallel(const DesignEngine& engine, std::size_t threads) {
  return [&engine, threads](const std::vector<std::vector<Draw>>& designs) {
    const std::size_t piece = piece_of(engine, designs.size(), threads);
    if (threads == 1 || designs.size() <= piece) return engine.evaluate(designs);
    RowBlock all;
    run_in_order((designs.size() + piece - 1) / piece, threads, [&](std::size_t k) -> std::function<void()> {
      const auto from = designs.begin() + static_cast<std::ptrdiff_t>(k * piece);
      const std::size_t count = std::min(piece, designs.size() - k * piece);
      auto block = std::make_shared<RowBlock>(engine.evaluate({from, from + static_cast<std::ptrdiff_t>(count)}));
      return [&all, block] { append(all, std::move(*block)); };
    });
    return all;
  };
}

std::size_t OptimizationResult::design_count() const {
  return search.designs.size() + (check ? check->designs.size() : 0);
}

const Search& OptimizationResult::search_of(std::size_t index) const {
  return index < search.designs.size() ? search : *check;
}

const EvaluatedDesign& OptimizationResult::design(std::size_t index) const {
  const std::size_t own = search.designs.size();
  return index < own ? search.designs[index] : check->designs[index - own];
}

const EvaluatedDesign* OptimizationResult::chosen() const {
  if (compromise) return &design(*compromise);
  return nearest ? &design(*nearest) : nullptr;
}

double limit_of(const Constraint& constraint, const EvaluatedDesign& design, const EvaluatedDesign& initial) {
  switch (constraint.limit.kind) {
    case Limit::Kind::initial:
      return constraint.limit.value * initial.responses[constraint.response];
    case Limit::Kind::response:
      return design.responses[constraint.limit.response];
    case Limit::Kind::number:
      break;
  }
  return constraint.limit.value;
}

std::optional<double> change_percent(double value, double initial) {
  const double change = 100.0 * (value / initial - 1.0);
  // Relative to a rounded zero a change has no meaning.
  return std::abs(change) < 1e9 ? std::optional(change) : std::nullopt;
}

std::vector<std::string> settings_of(const Optimization& optimization, const EvaluatedDesign& design) {
  return overrides(optimization.study, design.draws);
}

std::string constraint_text(const OptimizationResult& result, const Constraint& constraint) {
  const std::vector<std::string>& responses = result.optimization.study.responses;
  const std::string_view sign = constraint.sense == Constraint::Sense::at_least ? ">=" : "<=";
  const std::string& path = responses[constraint.response];
  switch (constraint.limit.kind) {
    case Limit::Kind::initial:
      return fmt::format("{} {} {} x initial", path, sign, constraint.limit.value);
    case Limit::Kind::response:
      return fmt::format("{} {} {}", path, sign, responses[constraint.limit.response]);
    case Limit::Kind::number:
      break;
  }
  return fmt::format("{} {} {}", path, sign, constraint.limit.value);
}

bool keeps(const Constraint& constraint, const EvaluatedDesign& design, const EvaluatedDesign& initial) {
  const double value = design.responses[constraint.response];
  const double limit = limit_of(constraint, design, initial);
  return constraint.sense == Constraint::Sense::at_least ? value >= limit : value <= limit;
}

SearchCounts count(const Search& search) {
  SearchCounts counts{search.designs.size(), 0, 0};
  for (const EvaluatedDesign& design : search.designs) {
    if (design.is_feasible()) ++counts.feasible;
    if (!design.status.converged()) ++counts.without_answer;
  }
  return counts;
}

namespace {

constexpr double kLinear = 1e3;      // Limit up to which an objective is unchanged;
constexpr double kInfeasible = 4e3;  // infeasible designs are above twice that,
constexpr double kNoAnswer = 6e3;    // designs without a result above these.

/// Strictly increasing, smooth function with values between -2000 and 2000.
double compressed(double x) {
  const double size = std::abs(x);
  return size <= kLinear ? x : std::copysign(2.0 * kLinear - kLinear * kLinear / size, x);
}

/// Relative violation of a constraint.
double violation(const Constraint& constraint, const EvaluatedDesign& design, const EvaluatedDesign& initial) {
  const double value = design.responses[constraint.response];
  const double limit = limit_of(constraint, design, initial);
  const double missing = constraint.sense == Constraint::Sense::at_least ? limit - value : value - limit;
  if (!(missing > 0.0)) return std::isnan(missing) ? std::numeric_limits<double>::infinity() : 0.0;
  double scale = std::max(std::abs(limit), std::abs(value));
  if (constraint.limit.kind != Limit::Kind::response) {
    const double usual = std::abs(initial.responses[constraint.response]);
    scale = std::max(std::abs(limit), std::isfinite(usual) ? usual : 0.0);
  }
  return missing / (scale > 0.0 ? scale : 1.0);
}

/// Whether a is nowhere worse than b; equal points cover each other.
bool covers(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, std::ranges::less_equal{});
}

/// Smallest and largest coordinates.
struct Extent {
  std::vector<double> from, to;

  explicit Extent(std::size_t dimensions) : from(dimensions, std::numeric_limits<double>::infinity()), to(from) {
    for (double& x : to) x = -x;
  }
  void include(const std::vector<double>& point) {
    for (const auto k : indices(point)) {
      from[k] = std::min(from[k], point[k]);
      to[k] = std::max(to[k], point[k]);
    }
  }
  /// Coordinates scaled to 0 to 1 over the extent.
  std::vector<double> scaled(const std::vector<double>& point) const {
    std::vector<double> u;
    for (const auto k : indices(point)) u.push_back(to[k] > from[k] ? (point[k] - from[k]) / (to[k] - from[k]) : 0.0);
    return u;
  }
};

Points costs_of_front(const Optimization& optimization, const Search& search) {
  Points points;
  for (const std::size_t k : search.front) points.push_back(costs(optimization, search.designs[k]));
  return points;
}

/// Quantity that is smallest for the chosen design.
double merit(const Compromise& compromise, const std::vector<double>& u) {
  switch (compromise.by) {
    case Compromise::By::ideal:
      return std::inner_product(u.begin(), u.end(), u.begin(), 0.0);
    case Compromise::By::knee:
      return std::accumulate(u.begin(), u.end(), 0.0);
    case Compromise::By::weights:
      return std::inner_product(u.begin(), u.end(), compromise.weights.begin(), 0.0);
    case Compromise::By::best:
      break;
  }
  return u[compromise.objective];
}

std::vector<double> best_values(const Optimization& optimization, const Points& points) {
  std::vector<double> best;
  for (const auto k : indices(optimization.objectives)) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::vector<double>& point : points) least = std::min(least, point[k]);
    best.push_back(optimization.objectives[k].maximize ? -least : least);
  }
  return best;
}

}  // namespace

Fitness::Fitness(const Optimization& optimization, const EvaluatedDesign& initial)
    : optimization_(optimization), initial_(initial) {
  for (const Objective& objective : optimization.objectives) {
    const double size = std::abs(initial.responses[objective.response]);
    scales_.push_back(std::isfinite(size) && size > 0.0 ? size : 1.0);
  }
}

void Fitness::assess(EvaluatedDesign& design) const {
  design.violation = std::numeric_limits<double>::infinity();
  if (!design.status.converged()) return;
  const auto none = std::ranges::find_if(design.responses, [](double y) { return std::isnan(y); });
  if (none != design.responses.end()) {
    const auto index = static_cast<std::size_t>(none - design.responses.begin());
    design.status = {"refused", fmt::format("{} is not defined in this design", optimization_.study.responses[index])};
    return;
  }
  design.violation = 0.0;
  for (const Constraint& constraint : optimization_.constraints)
    design.violation += violation(constraint, design, initial_);
}

std::vector<double> Fitness::operator()(const EvaluatedDesign& design) const {
  const std::size_t count = optimization_.objectives.size();
  if (!design.status.converged()) return std::vector<double>(count, kNoAnswer);
  if (!design.is_feasible()) {
    const double v = design.violation;
    const double share = std::isfinite(v) ? v / (1.0 + v) : 1.0;
    return std::vector<double>(count, kInfeasible + 1e3 * share);
  }
  std::vector<double> values = costs(optimization_, design);
  for (const auto k : up_to(count)) values[k] = compressed(values[k] / scales_[k]);
  return values;
}

std::vector<double> costs(const Optimization& optimization, const EvaluatedDesign& design) {
  std::vector<double> values;
  for (const Objective& objective : optimization.objectives) {
    const double value = design.responses[objective.response];
    values.push_back(objective.maximize ? -value : value);
  }
  return values;
}

std::vector<std::size_t> non_dominated(const Points& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // In lexicographic order a point is dominated by an earlier one or not at all.
  std::ranges::stable_sort(
      order, {}, [&](std::size_t k) -> const auto& { return points[k]; });
  std::vector<std::size_t> front;
  for (const std::size_t k : order) {
    const auto covers_k = [&](std::size_t other) { return covers(points[other], points[k]); };
    const bool planar = points[k].size() <= 2 && !front.empty();
    const bool dominated = planar ? covers_k(front.back()) : std::ranges::any_of(front, covers_k);
    if (!dominated) front.push_back(k);
  }
  return front;
}

std::vector<std::size_t> joint_front(const OptimizationResult& result) {
  std::vector<std::size_t> candidates = result.search.front;
  if (result.check)
    for (const std::size_t k : result.check->front) candidates.push_back(result.search.designs.size() + k);
  Points points;
  for (const std::size_t k : candidates) points.push_back(costs(result.optimization, result.design(k)));
  std::vector<std::size_t> front = non_dominated(points);
  for (std::size_t& k : front) k = candidates[k];
  return front;
}

std::optional<std::size_t> compromise_of(const OptimizationResult& result) {
  const Optimization& optimization = result.optimization;
  Points points;
  for (const std::size_t k : result.front) points.push_back(costs(optimization, result.design(k)));
  Extent extent(optimization.objectives.size());
  for (const std::vector<double>& point : points) extent.include(point);
  std::optional<std::size_t> chosen;
  double least = std::numeric_limits<double>::infinity();
  for (const auto k : indices(points)) {
    const double value = merit(optimization.compromise, extent.scaled(points[k]));
    if (value >= least) continue;
    least = value;
    chosen = result.front[k];
  }
  return chosen;
}

FrontComparison compare_fronts(const Optimization& optimization, const EvaluatedDesign& initial, const Search& search,
                               const Search& check) {
  constexpr double kMargin = 0.1;  // Margin with which the ends of a front count.
  FrontComparison comparison;
  Points ours = costs_of_front(optimization, search);
  Points theirs = costs_of_front(optimization, check);
  if (ours.empty() || theirs.empty()) return comparison;
  comparison.best = best_values(optimization, ours);
  comparison.check_best = best_values(optimization, theirs);
  Extent extent(optimization.objectives.size());
  for (const Points* points : {&ours, &theirs})
    for (const std::vector<double>& point : *points) extent.include(point);
  if (initial.status.converged()) extent.include(costs(optimization, initial));
  for (Points* points : {&ours, &theirs})
    for (std::vector<double>& point : *points) point = extent.scaled(point);
  const std::vector<double> corner(optimization.objectives.size(), 1.0 + kMargin);
  const double box = std::accumulate(corner.begin(), corner.end(), 1.0, std::multiplies<double>());
  comparison.hypervolume = modules::loaded<SearchModule>().hypervolume(ours, corner) / box;
  comparison.check_hypervolume = modules::loaded<SearchModule>().hypervolume(theirs, corner) / box;
  return comparison;
}

}  // namespace prs
