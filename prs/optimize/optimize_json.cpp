#include "prs/optimize/optimize_json.h"

#include "prs/study/study_json.h"

namespace prs {
namespace {

/// A design of a result, by its place among those of both searches.
struct DesignAt {
  const OptimizationResult* result = nullptr;
  const EvaluatedDesign* design = nullptr;
  std::size_t index = 0;

  const Study& study() const { return result->optimization.study; }
  std::size_t number() const { return index + 1; }
  bool is_feasible() const { return design->is_feasible(); }
};

struct ConstraintOf {
  const DesignAt* of = nullptr;
  const Constraint* constraint = nullptr;
};

struct SearchOf {
  const OptimizationResult* result = nullptr;
  const Search* search = nullptr;
  std::size_t first = 0;
};

struct Best {
  const OptimizationResult* result = nullptr;
  std::size_t objective = 0;
};

std::optional<DesignAt> design_at(const OptimizationResult& result,
                                  const std::optional<std::size_t>& index) {
  return index ? std::optional(DesignAt{&result, &result.design(*index), *index}) : std::nullopt;
}

// What was asked for.

constexpr auto is_listed = [](const Factor& variable) {
  return variable.distribution.kind == Distribution::Kind::levels;
};
template <double Distribution::*end>
constexpr auto of_end = of<[](const Factor& variable) { return variable.distribution.*end; },
                           [](const Factor& variable) { return !is_listed(variable); }>;

constexpr Quantity<Factor> kVariableRows[] = {
    {"path", always<&Factor::path>},
    {"label", always<&Factor::label>},
    {"unit", filled<&Factor::unit>},
    {"values", of<[](auto& variable) { return each(variable.levels, &Level::text); }, is_listed>},
    {"from", of_end<&Distribution::first>},
    {"to", of_end<&Distribution::second>},
    {"with", filled<[](auto& variable) { return each(variable.companions, &Factor::path); }>},
};

using Goal = Within<Optimization, Objective>;
template <bool maximize>
constexpr auto goal = of<[](const Goal& g) { return g.whole->study.responses[g.item->response]; },
                         [](const Goal& g) { return g.item->maximize == maximize; }>;

constexpr Quantity<Goal> kObjectiveRows[] = {
    {"minimize", goal<false>},
    {"maximize", goal<true>},
};

template <Compromise::By by>
constexpr auto is_by = [](const Optimization& o) { return o.compromise.by == by; };

constexpr Quantity<Optimization> kCompromiseRows[] = {
    {"by", always<[](auto& o) {
       constexpr std::array kNames{"ideal", "knee", "weights", "best"};
       return kNames.at(static_cast<std::size_t>(o.compromise.by));
     }>,
     "ideal | knee | weights | best"},
    {"weights",
     always<[](auto& o) { return o.compromise.weights; }, is_by<Compromise::By::weights>>},
    {"of",
     of<[](auto& o) { return o.study.responses[o.objectives[o.compromise.objective].response]; },
        is_by<Compromise::By::best>>},
};

constexpr Quantity<Optimization> kOptimizationRows[] = {
    {"command", always<[](auto& o) { return name(o.study.command); }>},
    {"variables",
     always_table<kVariableRows,
                  [](auto& o) -> const std::vector<Factor>& { return o.study.factors; }>},
    {"objectives", always_table<kObjectiveRows, [](auto& o) { return within(o, o.objectives); }>},
    {"algorithm", always<&Optimization::algorithm>},
    {"check", of<&Optimization::check>},
    {"population", always<&Optimization::population>},
    {"generations", always<&Optimization::generations>},
    {"seed", always<&Optimization::seed>},
    {"compromise", always_table<kCompromiseRows>},
};

// Designs.

constexpr Quantity<DesignAt> kDesignRows[] = {
    {"variables", always<[](auto& d) {
       ByKey<Level> values;
       for (const DrawnInput& drawn : drawn_inputs(d.study()))
         if (const auto value = value_in(*drawn.input, d.design->draws[drawn.factor]))
           values.emplace_back(drawn.input->path, *value);
       return values;
     }>,
     "by the paths of the inputs"},
    {"status", always<[](auto& d) { return d.design->status.name; }>},
    {"reason", filled<[](auto& d) { return d.design->status.reason; }>},
    {"feasible", always<&DesignAt::is_feasible>},
    {"violation", of<[](auto& d) { return d.design->violation; }>},
    {"responses", always<[](auto& d) { return by_key(d.study().responses, d.design->responses); }>,
     "by their paths"},
};

constexpr Quantity<ConstraintOf> kConstraintRows[] = {
    {"name", always<[](auto& c) { return c.constraint->name; }>},
    {"constraint", always<[](auto& c) { return constraint_text(*c.of->result, *c.constraint); }>},
    {"value", of<[](auto& c) { return c.of->design->responses[c.constraint->response]; }>},
    {"limit",
     of<[](auto& c) { return limit_of(*c.constraint, *c.of->design, c.of->result->initial); }>},
    {"satisfied",
     always<[](auto& c) { return keeps(*c.constraint, *c.of->design, c.of->result->initial); }>},
};

constexpr auto constraints_of = [](const DesignAt& d) {
  return each(d.result->optimization.constraints, [&](const Constraint& c) {
    return ConstraintOf{&d, &c};
  });
};

constexpr Quantity<DesignAt> kInitialRows[] = {
    {"", always_table<kDesignRows>},
    {"constraints", always_table<kConstraintRows, constraints_of>},
};

constexpr Quantity<DesignAt> kNumberedRows[] = {
    {"design", always<&DesignAt::number>, "its number in history.csv"},
    {"", always_table<kDesignRows>},
};

constexpr Quantity<DesignAt> kChosenRows[] = {
    {"design", always<&DesignAt::number>, "its number in history.csv"},
    {"algorithm", always<[](auto& d) { return d.result->search_of(d.index).algorithm; }>,
     "that found it"},
    {"", always_table<kDesignRows>},
    as_shown<DesignAt>({"change_percent", always<[](auto& d) {
                          std::vector<std::optional<double>> changes;
                          for (std::size_t k = 0; k < d.design->responses.size(); ++k)
                            changes.push_back(change_percent(d.design->responses[k],
                                                             d.result->initial.responses[k]));
                          return by_key(d.study().responses, changes);
                        }>,
                        "against the file's own design"}),
    {"constraints", always_table<kConstraintRows, constraints_of>},
    {"set", always<[](auto& d) { return settings_of(d.result->optimization, *d.design); }>,
     "what `--set` takes for it"},
};

constexpr Quantity<SearchOf> kSearchRows[] = {
    {"algorithm", always<[](auto& s) { return s.search->algorithm; }>},
    {"designs", always<[](auto& s) { return count(*s.search).designs; }>},
    {"feasible", always<[](auto& s) { return count(*s.search).feasible; }>},
    {"without_answer", always<[](auto& s) { return count(*s.search).without_answer; }>},
    {"front", always_table<kNumberedRows,
                           [](auto& s) {
                             return each(s.search->front, [&](std::size_t k) {
                               return DesignAt{s.result, &s.search->designs[k], s.first + k};
                             });
                           }>},
};

constexpr Quantity<Best> kBestRows[] = {
    {"objective", always<[](auto& b) {
       const Optimization& o = b.result->optimization;
       return o.study.responses[o.objectives[b.objective].response];
     }>},
    {"value", of<[](auto& b) { return b.result->comparison->best[b.objective]; }>},
    {"check_value", of<[](auto& b) { return b.result->comparison->check_best[b.objective]; }>},
    as_shown<Best>({"difference_percent", of<[](auto& b) {
                      const FrontComparison& c = *b.result->comparison;
                      return change_percent(c.check_best[b.objective], c.best[b.objective]);
                    }>}),
};

constexpr Quantity<OptimizationResult> kComparisonRows[] = {
    {"hypervolume", always<[](auto& r) { return r.comparison->hypervolume; }>},
    {"check_hypervolume", always<[](auto& r) { return r.comparison->check_hypervolume; }>},
    {"best", always_table<kBestRows,
                          [](auto& r) {
                            std::vector<Best> all;
                            for (std::size_t k = 0; k < r.comparison->best.size(); ++k)
                              all.push_back({&r, k});
                            return all;
                          }>},
};

constexpr Quantity<OptimizationResult> kResultRows[] = {
    {"optimize", always_table<kOptimizationRows, &OptimizationResult::optimization>},
    {"initial", always_table<kInitialRows,
                             [](auto& r) {
                               return DesignAt{&r, &r.initial};
                             }>},
    {"compromise", of_table<kChosenRows, [](auto& r) { return design_at(r, r.compromise); }>},
    {"nearest", of_table<kChosenRows, [](auto& r) { return design_at(r, r.nearest); }>},
    {"front", always<[](auto& r) { return each(r.front, [](std::size_t k) { return k + 1; }); }>,
     "numbers in history.csv"},
    {"search", always_table<kSearchRows,
                            [](auto& r) {
                              return SearchOf{&r, &r.search};
                            }>},
    {"check", of_table<kSearchRows,
                       [](auto& r) {
                         return r.check ? std::optional(
                                              SearchOf{&r, &*r.check, r.search.designs.size()})
                                        : std::nullopt;
                       }>},
    {"comparison",
     of_table<kComparisonRows, std::identity{}, [](auto& r) { return r.comparison.has_value(); }>},
};

}  // namespace

Record<OptimizationResult> record_of(Type<OptimizationResult>) {
  return {"Optimization", "What was asked for, and the best designs.", kResultRows};
}

nlohmann::ordered_json optimize_json(const OptimizationResult& result, const DocumentInfo& info) {
  nlohmann::ordered_json document = document_head(info, {});
  put_object(document, result);
  return document;
}

}  // namespace prs
