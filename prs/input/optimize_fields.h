#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "prs/input/field.h"
#include "prs/model/command.h"
#include "prs/model/optimization.h"

/// `optimize` as case_fields.h describes the rest of the input.
namespace prs::input {

/// An input that changes with a variable, as it is written.
struct LinkedInputItem {
  std::string path;
  std::vector<std::string> values;
};

/// A variable as it is written.
struct VariableItem {
  std::string path;
  std::optional<std::string> label;
  std::optional<std::string> from, to;
  std::optional<std::vector<std::string>> values;
  std::vector<LinkedInputItem> linked;
};

struct ObjectiveItem {
  std::optional<std::string> minimize, maximize;
};

struct ConstraintItem {
  std::string response;
  std::optional<std::string> name;
  std::optional<std::string> at_least, at_most;
};

struct CompromiseItem {
  Compromise::By by = Compromise::By::ideal;
  std::vector<double> weights;
  std::string of;
};

/// An optimization as it is written.
struct OptimizeItem {
  Command command = Command::contact;
  std::vector<VariableItem> variables;
  std::vector<ObjectiveItem> objectives;
  std::vector<ConstraintItem> constraints;
  bool thread_constraints = false;
  std::optional<Algorithm> algorithm;
  std::optional<Algorithm> check;
  int population = 40;
  int generations = 50;
  std::int64_t seed = 1;
  CompromiseItem compromise;
};

/// Examples of what the texts may be.
inline constexpr Text kInputPath{"mechanism.flank_angle.screw"};
inline constexpr Text kResponsePath{"screw.peak_pressure_MPa.max"};
inline constexpr Verbatim kLimit{"{initial: 1.1}"};

template <class Io>
void alternatives(Io& io, Algorithm& a) {
  io.word("nsga2", a, Algorithm::nsga2,
          "non-dominated sorting genetic algorithm; several objectives");
  io.word("nspso", a, Algorithm::nspso, "non-dominated sorting particle swarm; several objectives");
  io.word("moead", a, Algorithm::moead,
          "decomposition with differential evolution; several objectives");
  io.word("sade", a, Algorithm::sade, "self-adaptive differential evolution; one objective");
  io.word("pso", a, Algorithm::pso, "particle swarm; one objective");
  io.word("cmaes", a, Algorithm::cmaes, "covariance matrix adaptation; one objective");
}

template <class Io>
void alternatives(Io& io, Compromise::By& b) {
  io.word("ideal", b, Compromise::By::ideal, "nearest to the best value of every objective");
  io.word("knee", b, Compromise::By::knee, "farthest from the plane through the front's ends");
  io.word("weights", b, Compromise::By::weights, "least weighted sum");
  io.word("best", b, Compromise::By::best, "best value of one objective");
}

template <class Io>
void fields(Io& io, LinkedInputItem& l) {
  io.field("path", l.path, kInputPath, required,
           "What changes with the variable, as `--set` names it");
  io.field("values", l.values, List{Verbatim{}, 2}, required, "One for each value of the variable");
}

template <class Io>
void fields(Io& io, VariableItem& v) {
  io.field("path", v.path, kInputPath, required, "What may change, as `--set` names it");
  io.field("label", v.label, Text{"lead"}, optional, "Its name in tables and figures");
  io.field("values", v.values, List{Verbatim{}, 2}, optional,
           "What it may be, as it would stand in the file");
  const Presence bound = required_only_if(!v.values, "in place of `values`");
  io.field("from", v.from, Verbatim{}, bound, "Least value; of whole numbers all up to `to`");
  io.field("to", v.to, Verbatim{}, bound, "Greatest value, in the same unit");
  io.field("with", v.linked, List{Block{}, 1},
           optional_only_if(v.values.has_value(), "only with `values`"),
           "Inputs that change together with this one, value by value");
}

template <class Io>
void fields(Io& io, ObjectiveItem& o) {
  io.field("minimize", o.minimize, kResponsePath, optional,
           "Path of the response that shall be small: into the first load case of the JSON "
           "document of the command or into the document, of an array `.max`, `.min`, `.mean` or "
           "`[k]`");
  io.field("maximize", o.maximize, kResponsePath,
           required_only_if(!o.minimize, "in place of `minimize`"),
           "Path of the response that shall be large");
}

template <class Io>
void fields(Io& io, ConstraintItem& c) {
  io.field("response", c.response, kResponsePath, required, "Path of a response");
  io.field("at_least", c.at_least, kLimit, optional,
           "A number in the unit of the path, `{initial: 0.9}` for 0.9 times the value of the "
           "file's own design, or `{response: PATH}` for another response of the same design");
  io.field("at_most", c.at_most, kLimit,
           c.at_least ? optional : Presence{true, true, "where there is no `at_least`"},
           "The same from above");
  io.field("name", c.name, Text{"weight"}, optional, "Its name in tables");
}

template <class Io>
void fields(Io& io, CompromiseItem& c) {
  io.field("by", c.by, Choice{}, optional,
           "Which design of the front is chosen, objectives scaled by the extent of the front");
  io.field("weights", c.weights, List{Number{not_negative}, 1},
           required_only_if(c.by == Compromise::By::weights, "only with `by: weights`"),
           "One for each objective");
  io.field("of", c.of, kResponsePath,
           required_only_if(c.by == Compromise::By::best, "only with `by: best`"),
           "The objective's path");
}

template <class Io>
void fields(Io& io, OptimizeItem& o) {
  io.field("command", o.command, Choice{}, required, "What each design runs through");
  io.field("variables", o.variables, List{Block{}, 1}, required, "The inputs that may change");
  io.field("objectives", o.objectives, List{Block{}, 1, 8}, required,
           "What shall be as small or as large as possible");
  io.field("constraints", o.constraints, List{Block{}, 1}, optional, "What a design must keep");
  io.field("thread_constraints", o.thread_constraints, Flag{}, optional,
           "Threads that are neither sharp nor cut into each other and touch on their flanks only, "
           "Yao et al. (51) to (60)");
  io.field("algorithm", o.algorithm, Choice{}, optional,
           "How designs are searched; nsga2, or sade of a single objective by default");
  io.field("check", o.check, Choice{}, optional, "A second search to compare with");
  io.field("population", o.population, Whole{8, 2'000}, optional, "Designs of a generation");
  io.field("generations", o.generations, Whole{1, 10'000}, optional,
           "The first, random one included");
  io.field("seed", o.seed, Whole{0, std::int64_t{1} << 53}, optional,
           "Of the random numbers: the same seed finds the same designs");
  io.field("compromise", o.compromise, Block{}, optional, "Which design of the front is chosen");
}

}  // namespace prs::input
