#include "prs/optimize/optimizer.h"

#include <algorithm>

#include "prs/components/search.h"
#include "prs/optimize/front.h"
#include "prs/study/sampling.h"

namespace prs {
namespace {

struct Interrupted {};

/// Answers to the designs in the order in which they are asked for, those of the journal first.
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
      // Records follow each other; what came after damage does not.
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
    while (block_.first + block_.rows <= asked_)
      block_ = journal_.block(journal_.records()[next_record_++]);
    return row(block_, asked_++ - block_.first, draws);
  }

  void compute(const std::vector<std::vector<Draw>>& designs,
               std::vector<EvaluatedDesign>& answered) {
    if (options_.interrupted && options_.interrupted()) throw Interrupted{};
    const std::vector<std::vector<Draw>> rest(
        designs.begin() + static_cast<std::ptrdiff_t>(answered.size()), designs.end());
    RowBlock block = evaluate_(rest);
    block.first = asked_;
    journal_.append(encode(block));
    for (std::size_t k = 0; k < rest.size(); ++k) answered.push_back(row(block, k, rest[k]));
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
  std::size_t asked_ = 0;        ///< Designs so far.
  std::size_t found_ = 0;        ///< Designs that the journal held in the beginning.
  std::size_t next_record_ = 0;  ///< After that of `block_`.
  RowBlock block_;
};

std::vector<Draw> draws_at(const Optimization& optimization, const std::vector<double>& x) {
  std::vector<Draw> draws;
  for (std::size_t i = 0; i < x.size(); ++i)
    draws.push_back(draw_at(optimization.study.factors[i], x[i]));
  return draws;
}

/// A Latin hypercube in the unit cube. The first design is that of the file, where the variables
/// have it.
Points first_population(const Optimization& optimization, std::uint64_t seed) {
  const std::vector<Factor>& variables = optimization.study.factors;
  Points points(optimization.population, std::vector<double>(variables.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
    for (std::size_t i = 0; i < variables.size(); ++i)
      points[k][i] = latin_hypercube_number(seed, i, k, points.size());
  std::vector<double> base;
  for (const Factor& variable : variables)
    if (const std::optional<double> x = place_of_base(variable)) base.push_back(*x);
  if (base.size() == variables.size()) points[0] = base;
  return points;
}

Search search(const Optimization& optimization, Algorithm algorithm, std::uint64_t seed,
              const Fitness& fitness, Answers& answers) {
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
      {algorithm, optimization.objectives.size(), optimization.generations, seed},
      first_population(optimization, seed), evaluate);
  search.front = front_of(optimization, search.designs);
  return search;
}

/// The design with an answer that violates least.
std::optional<std::size_t> nearest(const OptimizationResult& result) {
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < result.design_count(); ++k)
    if (result.design(k).violation < least) {
      least = result.design(k).violation;
      nearest = k;
    }
  return nearest;
}

OptimizationResult run(const Optimization& optimization, Answers& answers) {
  // The check has random numbers of its own.
  OptimizationResult result{optimization, {}, {}, {}, {}};
  const std::vector<Draw> as_in_file(optimization.study.factors.size());
  result.initial = answers({as_in_file}).front();
  const Fitness fitness(optimization, result.initial);
  fitness.assess(result.initial);
  result.search = search(optimization, optimization.algorithm, optimization.seed, fitness, answers);
  if (optimization.check) {
    result.check = search(optimization, *optimization.check, optimization.seed + kGoldenStep,
                          fitness, answers);
    result.comparison = compare_fronts(optimization, result.initial, result.search, *result.check);
  }
  result.front = joint_front(result);
  result.compromise = compromise_of(result);
  if (!result.compromise) result.nearest = nearest(result);
  return result;
}

/// To a power of ten, at most a millionth of the range.
double rounded(double value, double range) {
  constexpr int kMostDecimals = 22;  // Powers of ten up to here are exact.
  const int decimals = 6 - static_cast<int>(std::floor(std::log10(range)));
  if (std::abs(decimals) > kMostDecimals) return value;
  const double power = std::pow(10.0, std::abs(decimals));
  return decimals >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
}

/// Designs that a thread takes at once: as many as the other threads do, at most what the engine
/// takes.
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

std::optional<double> place_of_base(const Factor& variable) {
  if (!variable.base) return std::nullopt;
  const auto& [kind, from, to] = variable.distribution;
  const std::optional<double>& number = variable.base->number;
  if (kind != Distribution::Kind::levels) {
    if (!number || *number < from || *number > to) return std::nullopt;
    return (*number - from) / (to - from);
  }
  for (std::size_t k = 0; k < variable.levels.size(); ++k) {
    const Level& level = variable.levels[k];
    if (level.text == variable.base->text || (level.number && level.number == number))
      return (static_cast<double>(k) + 0.5) / static_cast<double>(variable.levels.size());
  }
  return std::nullopt;
}

std::optional<OptimizationResult> optimize(const Optimization& optimization,
                                           const EvaluateDesigns& evaluate, Journal& journal,
                                           const OptimizeOptions& options) {
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
    run_in_order((designs.size() + piece - 1) / piece, threads,
                 [&](std::size_t k) -> std::function<void()> {
                   const auto from = designs.begin() + static_cast<std::ptrdiff_t>(k * piece);
                   const std::size_t count = std::min(piece, designs.size() - k * piece);
                   auto block = std::make_shared<RowBlock>(
                       engine.evaluate({from, from + static_cast<std::ptrdiff_t>(count)}));
                   return [&all, block] { append(all, std::move(*block)); };
                 });
    return all;
  };
}

}  // namespace prs
