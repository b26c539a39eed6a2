#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "prs/model/command.h"

namespace prs {

/// How the measures of a design over two factors are combined into one, and the designs that are chosen by it (Jung
/// 2017, chapters 7 and 8). m_i is a measure, n_i its normalisation, w_i its weight:
///   product   E = prod (m_i / n_i)^w_i
///   sum       E = sum w_i m_i / n_i
/// Jung's weighted product w_1 m_1 w_2 m_2 .. only rescales E; weights are exponents here. Measures to minimise have a
/// negative weight.
struct Envelope {
  enum class Combine { product, sum };

  /// n_i, over all values of the measure in the grid:
  enum class Normalise {
    rms,   ///< their root mean square, sqrt(mean m^2) (Jung 2017, section 7.2),
    max,   ///< the largest magnitude,
    none,  ///< none: 1, in the unit of the measure.
  };

  struct Measure {
    std::string response;  ///< Path, see `response`.
    double weight = 1.0;
  };

  /// Wanted value of a response, in the unit of its path.
  struct Target {
    std::string response;
    double value = 0.0;
  };

  /// A design in the grid: given by its two factors, found by targets, or else the best.
  struct Point {
    std::string name;
    std::optional<std::array<double, 2>> at;  ///< Values of the factors, in their units.
    /// One target: the best of the places where a line of the grid meets it. Two: the place where both are met.
    std::vector<Target> reach;
  };

  Combine combine = Combine::product;
  Normalise normalise = Normalise::rms;
  std::vector<Measure> measures;
  std::vector<Point> points;
};

/// How a study chooses its designs from its factors.
enum class Plan {
  one_at_a_time,    ///< Each value of each factor alone, all others as in the file.
  grid,             ///< Every combination of the values, the last factor fastest.
  latin_hypercube,  ///< Each factor's range in as many strata as samples, one sample in each.
  sobol,            ///< Sobol's sequence, scrambled by a digital shift of the seed.
  monte_carlo,      ///< Independent draws.
  sobol_indices,    ///< Saltelli's design for first and total indices of variance.
  derivatives,      ///< The base case with the derivatives by every factor.
  tolerances,       ///< Independent draws, and a second set with each factor's deviation halved.
};

/// One value of a factor: its text in the file, and its place on an axis.
struct Level {
  std::string text;              ///< YAML: `30 mm`, `{convex: 6 mm}`
  std::optional<double> number;  ///< Value in the factor's unit; absent for words.
};

/// Distribution from which a sampled plan draws a factor's values, in the factor's unit.
struct Distribution {
  enum class Kind {
    levels,       ///< One of the levels, equally likely.
    uniform,      ///< Between `first` and `second`.
    log_uniform,  ///< Between `first` and `second`, uniform in the logarithm.
    normal,       ///< Mean `first`, standard deviation `second`.
  };
  Kind kind = Kind::levels;
  double first = 0.0;
  double second = 0.0;
};

/// An input that a study varies.
struct Factor {
  std::string path;   ///< `mechanism.pitch_diameter.screw`
  std::string label;  ///< Name shown to people; the path if none is given.
  std::string unit;   ///< Unit of the numbers; empty for numbers without unit.
  std::vector<Level> levels;
  std::optional<Level> base;  ///< Value in the file; absent if the file has none.
  bool logarithmic = false;   ///< The levels are equidistant in their logarithm.
  Distribution distribution = {};
  /// Whether it is an entry of a list drawn entry by entry, such as pitch errors.
  bool entry_of_list = false;
  bool with_previous = false;  ///< Whether it counts as one factor with the previous entry of the list.
  bool kept = false;           ///< Whether a plan of tolerances draws it but never halves it.
  /// Whether any number between two levels is allowed: a quantity, not a word or a whole number.
  bool continuous = false;
  /// Inputs that change with this factor: as many levels, no companions of their own.
  std::vector<Factor> companions = {};

  /// Whether every value has a place on an axis.
  bool is_numeric() const;
};

/// Factors that are varied, the plan, and the responses recorded for each design.
struct Study {
  Command command = Command::slip;  ///< contact, solve, slip or life: the chain of each design.
  Plan plan = Plan::one_at_a_time;
  std::vector<Factor> factors;
  std::vector<std::string> responses;  ///< Paths, see `response`; empty: the command's own.
  std::size_t samples = 0;             ///< Number of samples of sampled plans; per matrix for `sobol_indices`.
  std::uint64_t seed = 1;
  std::optional<Envelope> envelope = {};  ///< Only for `grid` with two factors.
};

/// Indices of the first factor of each block; a block is a set of factors that count as one.
std::vector<std::size_t> blocks_of(const Study& study);

/// Whether the designs are drawn at random rather than listed.
bool is_sampled(Plan plan);

/// An input that designs set: a factor or a companion of one.
struct DrawnInput {
  std::size_t factor = 0;         ///< Index of the factor whose draw sets the input.
  const Factor* input = nullptr;  ///< Input within the study.
};

/// Every factor, followed by its companions.
std::vector<DrawnInput> drawn_inputs(const Study& study);

/// A factor that differs from the file, with its value and those of its companions.
struct Setting {
  std::size_t factor = 0;
  Level level;
  std::vector<Level> companions = {};
};

/// One case of a study: the file with these settings; none for the base case.
struct Design {
  std::vector<Setting> settings;
};

/// Value of one factor in one design, without its text. A level sets the companions too.
struct Draw {
  enum class Kind { as_in_file, level, number };
  Kind kind = Kind::as_in_file;
  std::size_t level = 0;  ///< Index among the factor's levels.
  double number = 0.0;    ///< Value in the factor's unit.
};

inline constexpr std::size_t kMostDesigns = 1'000'000'000;
/// Largest number of values in the maps of one study: nodes x responses.
inline constexpr std::size_t kMostMapValues = 8'000'000;
inline constexpr std::size_t kMostSobolDimensions = 3667;
inline constexpr std::size_t kMostLevels = 100'000;

/// A factor of a grid as an axis of its maps, numbers ascending.
struct MapAxis {
  std::size_t factor = 0;           ///< Index among the study's factors.
  std::vector<std::size_t> levels;  ///< Indices of the factor's levels, one per node.
  std::vector<double> numbers;      ///< Numbers of the levels, in the factor's unit.
  bool logarithmic = false;         ///< Equidistant in their logarithm.
  /// Whether factor and companions have values between two nodes: quantities, not words or whole
  /// numbers.
  bool continuous = false;

  std::size_t nodes() const { return numbers.size(); }
  /// The factor's number at a place from 0, the first node, to nodes - 1: linear between two nodes,
  /// or linear in the logarithm.
  double number(double place) const;
  /// The place of a number; absent outside of the nodes.
  std::optional<double> place(double number) const;
};

/// A place on one axis: a node and the fraction of the distance to the next one.
struct Between {
  std::size_t node = 0;
  double share = 0.0;
};
Between between(double place, std::size_t nodes);

/// Interpolation between two numbers, linear, or linear in the logarithm.
double interpolated(double from, double to, double share, bool logarithmic);

/// The axes of the maps of a study: a grid over two factors of at least two different numbers each.
/// Absent for any other study.
std::optional<std::array<MapAxis, 2>> map_axes(const Study& study);

/// Search algorithms. The first three take several objectives, the others one.
enum class Algorithm {
  nsga2,  ///< Non-dominated sorting genetic algorithm II (Deb et al. 2002).
  nspso,  ///< Non-dominated sorting particle swarm (Li 2003).
  moead,  ///< Decomposition with differential evolution, MOEA/D-DE (Li & Zhang 2009).
  sade,   ///< Self-adaptive differential evolution.
  pso,    ///< Particle swarm.
  cmaes,  ///< Covariance matrix adaptation.
};

/// Name in a case file: `nsga2`.
std::string_view name(Algorithm algorithm);

bool takes_several_objectives(Algorithm algorithm);

/// A response to minimise or maximise.
struct Objective {
  std::size_t response = 0;  ///< Index among the study's responses.
  bool maximize = false;
};

/// Bound on a response, in its unit.
struct Limit {
  enum class Kind {
    number,    ///< `value`
    initial,   ///< `value` times that of the file's own design.
    response,  ///< Another response of the same design.
  };
  Kind kind = Kind::number;
  double value = 0.0;
  std::size_t response = 0;
};

struct Constraint {
  enum class Sense { at_least, at_most };

  std::string name;  ///< Name shown to people.
  std::size_t response = 0;
  Sense sense = Sense::at_least;
  Limit limit;
};

/// Choice of one design on the front. u: objectives scaled by the front's extent, 0 best and 1 worst of the front.
struct Compromise {
  enum class By {
    ideal,    ///< Least |u|: nearest to the best value of every objective.
    knee,     ///< Least sum of u: farthest from the plane through the ends of the front (Das 1999).
    weights,  ///< Least weighted sum of u.
    best,     ///< Best value of one objective.
  };
  By by = By::ideal;
  std::vector<double> weights;  ///< One per objective.
  std::size_t objective = 0;
};

/// Factors, objectives, constraints and settings of a search.
struct Optimization {
  /// Factors are the variables: numbers between the ends of a uniform distribution, or levels. The
  /// responses are those of objectives and constraints.
  Study study;
  std::vector<Objective> objectives;
  std::vector<Constraint> constraints;
  Algorithm algorithm = Algorithm::nsga2;
  std::optional<Algorithm> check;  ///< Algorithm of a second search, for comparison.
  std::size_t population = 40;     ///< Designs per generation.
  std::size_t generations = 50;    ///< Generations, including the first, random one.
  std::uint64_t seed = 1;
  Compromise compromise;
};

/// Number of designs to evaluate: the file's own and those of the searches.
std::size_t design_count(const Optimization& optimization);

}  // namespace prs
