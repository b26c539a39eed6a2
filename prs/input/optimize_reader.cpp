#include "prs/input/optimize_reader.h"

#include <algorithm>
#include <numeric>

#include "prs/indices.h"
#include "prs/input/reader.h"
#include "prs/input/varied_input.h"

namespace prs::input {
namespace {

/// Reads the variables of one optimization.
class VariableReader : VariedInput {
 public:
  /// `base`: the document without studies and optimization, `file` read from it.
  VariableReader(const OptimizeItem& item, const Source& source, const Node& root, Node& base, CaseFile& file,
                 ErrorList& errors)
      : VariedInput(source, root, base, errors), item_(item), file_(file), fields_(echo(file, base)) {}

  Factor read(std::size_t index) {
    const std::string at = path_ = fmt::format("optimize.variables[{}]", index);
    const VariableItem& item = item_.variables[index];
    Factor variable;
    variable.path = item.path;
    variable.label = item.label.value_or(item.path);
    if (!check_outside("path", item.path)) return variable;
    if (item.values)
      read_levels(variable, *item.values);
    else
      read_range(variable, item);
    for (const auto k : indices(item.companions)) {
      path_ = fmt::format("{}.with[{}]", at, k);
      if (std::optional<Factor> linked = read_linked(item.companions[k], variable))
        variable.companions.push_back(std::move(*linked));
    }
    return variable;
  }

 private:
  /// Value of a path in the file, or the default, in the unit of the variable.
  std::optional<Level> base_of(const Factor& variable) const {
    const std::optional<Node> node = base_value(variable.path, fields_);
    if (!node) return std::nullopt;
    const std::string text = flow_text(*node);
    return Level{text, number_in(text, variable.unit)};
  }

  void read_levels(Factor& variable, const std::vector<std::string>& values) {
    const std::optional<NumberAndUnit> first = split_unit(values[0]);
    if (first) variable.unit = first->unit;
    bool is_number = first.has_value();
    for (const std::string& text : values) {
      variable.levels.push_back({text, first ? number_in(text, variable.unit) : std::nullopt});
      is_number = is_number && variable.levels.back().number;
    }
    if (!is_number) {
      variable.unit.clear();
      for (Level& level : variable.levels) level.number.reset();
    }
    variable.base = base_of(variable);
    for (const Node& value : find_path(root_, path_ + ".values")->children)
      if (!check_in_place(variable.path, value)) return;
  }

  std::optional<Factor> read_linked(const LinkedInputItem& item, const Factor& variable) {
    Factor linked;
    linked.path = linked.label = item.path;
    if (!check_outside("path", item.path)) return std::nullopt;
    read_levels(linked, item.values);
    if (linked.levels.size() == variable.levels.size()) return linked;
    refuse_at("values", fmt::format("got {} values; expected {}, one for each of the variable; "
                                    "write as many",
                                    linked.levels.size(), variable.levels.size()));
    return std::nullopt;
  }

  void read_range(Factor& variable, const VariableItem& item) {
    const std::optional<Ends> ends = read_ends("", *item.from, *item.to, true);
    if (!ends) return;
    const auto& [from, to] = *ends;
    variable.unit = from.unit;
    variable.base = base_of(variable);
    for (const char* end : {".from", ".to"})
      if (!check_in_place(variable.path, *find_path(root_, path_ + end))) return;
    const Slot slot = find_slot(file_, variable.path);
    if (slot.kind == Slot::Kind::number) {
      variable.distribution = {Distribution::Kind::uniform, from.number, to.number};
      variable.continuous = true;
    } else if (slot.kind == Slot::Kind::whole) {
      read_whole(variable, from.number, to.number);
    } else {
      refuse_at("path", fmt::format("got {}; expected the path of a number; write what it may "
                                    "be as a list, `values: [.., ..]`",
                                    shown(variable.path)));
    }
  }

  void read_whole(Factor& variable, double from, double to) {
    if (to - from + 1.0 > static_cast<double>(kMostLevels))
      return refuse_at("to", fmt::format("got a range of {:.0f} numbers; expected at most {}; "
                                         "write a smaller one",
                                         to - from + 1.0, kMostLevels));
    for (double value = from; value <= to; value += 1.0)
      variable.levels.push_back({fmt::format("{:.0f}", value), value});
  }

  const OptimizeItem& item_;
  CaseFile& file_;
  std::vector<EchoEntry> fields_;
};

/// Reads objectives and constraints.
class AimReader {
 public:
  AimReader(const OptimizeItem& item, const Node& root, const std::vector<LoadCaseItem>& load_cases,
            OptimizeInput& input, ErrorList& errors)
      : item_(item), root_(root), load_cases_(load_cases), input_(input), errors_(errors) {}

  void read_objectives() {
    std::vector<std::string> before;
    for (const auto k : indices(item_.objectives)) {
      const ObjectiveItem& item = item_.objectives[k];
      const std::string at = fmt::format("optimize.objectives[{}].{}", k, item.minimize ? "minimize" : "maximize");
      const std::string& path = item.minimize ? *item.minimize : *item.maximize;
      if (item.minimize && item.maximize)
        refuse(at,
               "got minimize and maximize; expected one of the two; make two objectives of "
               "them");
      if (contains(before, path))
        refuse(at, fmt::format("got {} a second time; expected each objective once; delete one", shown(path)));
      before.push_back(path);
      input_.optimization.objectives.push_back({response(path, at), item.maximize.has_value()});
    }
  }

  void read_constraints() {
    for (const auto k : indices(item_.constraints)) {
      const ConstraintItem& item = item_.constraints[k];
      const std::string at = fmt::format("optimize.constraints[{}]", k);
      const std::size_t index = response(item.response, at + ".response");
      const auto add = [&](const char* key, Constraint::Sense sense) {
        const std::optional<Limit> limit = limit_at(fmt::format("{}.{}", at, key));
        if (!limit) return;
        input_.optimization.constraints.push_back({item.name.value_or(item.response), index, sense, *limit});
        refuse_contradiction(fmt::format("{}.{}", at, key));
      };
      if (item.at_least) add("at_least", Constraint::Sense::at_least);
      if (item.at_most) add("at_most", Constraint::Sense::at_most);
    }
  }

  /// Refuses the last constraint if no number meets it and one before.
  void refuse_contradiction(const std::string& at) {
    const Constraint& last = input_.optimization.constraints.back();
    for (const Constraint& before : input_.optimization.constraints) {
      if (before.response != last.response || before.sense == last.sense) continue;
      if (before.limit.kind != Limit::Kind::number || last.limit.kind != Limit::Kind::number) continue;
      const bool above = last.sense == Constraint::Sense::at_least;
      const double room = above ? before.limit.value - last.limit.value : last.limit.value - before.limit.value;
      if (room < 0.0)
        return refuse(at, fmt::format("got {0:.10g} beside {1} {2:.10g}; expected limits between which a design can "
                                      "be; exchange or widen them",
                                      last.limit.value, above ? "at_most" : "at_least", before.limit.value));
    }
  }

  /// Constraints of Yao et al. 2023, (51), (56) and (60).
  void read_thread_constraints(const Mechanism& mechanism) {
    const std::string at = "optimize.thread_constraints";
    using enum Constraint::Sense;
    const auto add = [&](std::string name, const std::string& path, Constraint::Sense sense, Limit limit) {
      input_.optimization.constraints.push_back({std::move(name), response(path, at), sense, limit});
    };
    for (const VariableItem& variable : item_.variables)
      for (const std::string_view block : {"mechanism.lead", "mechanism.starts", "mechanism.pitch"})
        if (variable.path == block || is_part_of(variable.path, block))
          return refuse(at, fmt::format("got true with the variable {}; expected a pitch that "
                                        "stays as it is; delete one of the two",
                                        shown(variable.path)));
    const double pitch = 1e3 * std::abs(mechanism.lead) / mechanism.starts.screw;
    const auto pitch_of = [&](const std::optional<double>& own) { return own ? 1e3 * *own : pitch; };
    const std::array parts{std::pair{"screw", pitch_of(mechanism.pitch.screw)},
                           std::pair{"roller", pitch_of(mechanism.pitch.roller)},
                           std::pair{"nut", pitch_of(mechanism.pitch.nut)}};
    for (const auto& [part, own_pitch] : parts) {
      const std::string threads = fmt::format("threads.{}.", part);
      add(fmt::format("{} crest not sharp (51)", part), threads + "crest_width_mm", at_least,
          {Limit::Kind::number, 0.0, 0});
      add(fmt::format("{} roots apart (51)", part), threads + "root_width_mm", at_most,
          {Limit::Kind::number, own_pitch, 0});
    }
    for (const char* side : {"screw", "nut"}) {
      const std::string contact = fmt::format("contact.{}.", side);
      const std::string flank = contact + "flank_clearance_mm";
      add(fmt::format("{} flanks apart (56)", side), flank, at_least, {Limit::Kind::number, 0.0, 0});
      const Limit beyond_flank{Limit::Kind::response, 0.0, response(flank, at)};
      add(fmt::format("{} crest clear (60)", side), contact + "body_crest_clearance_mm", at_least, beyond_flank);
      add(fmt::format("roller crest clear of {} (60)", side), contact + "roller_crest_clearance_mm", at_least,
          beyond_flank);
    }
  }

  void read_compromise() {
    const CompromiseItem& item = item_.compromise;
    Compromise& compromise = input_.optimization.compromise;
    compromise.by = item.by;
    compromise.weights = item.weights;
    const std::size_t objectives = item_.objectives.size();
    if (item.by == Compromise::By::weights && item.weights.size() != objectives)
      refuse("optimize.compromise.weights",
             fmt::format("got {} weights; expected {}, one for each objective; write as many", item.weights.size(),
                         objectives));
    const double sum = std::accumulate(item.weights.begin(), item.weights.end(), 0.0);
    if (item.by == Compromise::By::weights && !(sum > 0.0 && std::isfinite(sum)))
      refuse("optimize.compromise.weights",
             fmt::format("got weights whose sum is {}; expected a sum above 0; write for example "
                         "`weights: [2, 1]`",
                         sum));
    if (item.by != Compromise::By::best) return;
    for (const auto k : up_to(objectives))
      if (item_.objectives[k].minimize == item.of || item_.objectives[k].maximize == item.of) {
        compromise.objective = k;
        return;
      }
    refuse("optimize.compromise.of",
           fmt::format("got {}; expected the path of an objective; write for example `of: {}`", shown(item.of),
                       item_.objectives[0].minimize ? *item_.objectives[0].minimize
                                                    : item_.objectives[0].maximize.value_or("..")));
  }

  void read_algorithms() {
    Optimization& o = input_.optimization;
    const bool several = item_.objectives.size() > 1;
    o.algorithm = item_.algorithm.value_or(several ? Algorithm::nsga2 : Algorithm::sade);
    o.check = item_.check;
    check_algorithm(o.algorithm, "optimize.algorithm", several);
    if (o.check) check_algorithm(*o.check, "optimize.check", several);
    const bool genetic = o.algorithm == Algorithm::nsga2 || o.check == Algorithm::nsga2;
    if (genetic && item_.population % 4 != 0)
      refuse("optimize.population",
             fmt::format("got {}; expected a multiple of 4, as nsga2 pairs four at a time; write "
                         "{}",
                         item_.population, (item_.population / 4 + 1) * 4));
    o.population = static_cast<std::size_t>(item_.population);
    o.generations = static_cast<std::size_t>(item_.generations);
    o.seed = static_cast<std::uint64_t>(item_.seed);
    if (o.check == o.algorithm)
      refuse("optimize.check", fmt::format("got {}, which searches already; expected another one; "
                                           "write {}",
                                           name(*o.check), several ? "moead" : "pso"));
  }

 private:
  void refuse(const std::string& at, const std::string& message) { input::refuse(root_, at, message, errors_); }

  void check_algorithm(Algorithm algorithm, const std::string& at, bool several) {
    if (takes_several_objectives(algorithm) == several) return;
    refuse(at, fmt::format("got {} with {} objective{}; expected one for {}; write {}", name(algorithm),
                           item_.objectives.size(), several ? "s" : "", several ? "several" : "a single one",
                           several ? "nsga2, nspso or moead" : "sade, pso or cmaes"));
  }

  /// Index of a response, which is added if it is new.
  std::size_t response(const std::string& written, const std::string& at) {
    const std::string path = response_path(root_, load_cases_, written);
    std::vector<std::string>& responses = input_.optimization.study.responses;
    const auto found = std::ranges::find(responses, path);
    if (found != responses.end()) return static_cast<std::size_t>(found - responses.begin());
    responses.push_back(path);
    input_.asked_at.push_back(at);
    return responses.size() - 1;
  }

  /// `0.5`, `{initial: 1.1}` or `{response: PATH}`.
  std::optional<Limit> limit_at(const std::string& at) {
    const Node& node = *find_path(root_, at);
    const auto number = [](const Node& n) {
      return n.kind == Node::Kind::scalar && !n.quoted ? parse_number(n.text) : std::nullopt;
    };
    if (const std::optional<double> value = number(node)) return Limit{.value = *value};
    const Node* only = node.kind == Node::Kind::map && node.children.size() == 1 ? &node.children[0] : nullptr;
    if (only && only->key == "initial")
      if (const std::optional<double> value = number(*only))
        return Limit{.kind = Limit::Kind::initial, .value = *value};
    if (only && only->key == "response" && only->kind == Node::Kind::scalar && !only->text.empty())
      return Limit{.kind = Limit::Kind::response, .response = response(only->text, at)};
    refuse(at, fmt::format("got {}; expected a number in the unit of the path, {{initial: number}} "
                           "or {{response: path}}; write for example `{}: {{initial: 1.1}}`",
                           shown(flow_text(node)), at.substr(at.rfind('.') + 1)));
    return std::nullopt;
  }

  const OptimizeItem& item_;
  const Node& root_;
  const std::vector<LoadCaseItem>& load_cases_;
  OptimizeInput& input_;
  ErrorList& errors_;
};

OptimizeItem written_optimization(const CaseFile& file, const Node& root, ErrorList& errors) {
  if (!file.optimize && !find(root, "optimize"))
    errors.add(root.place, "optimize",
               "missing; expected variables and objectives; add for example `optimize: {command: "
               "contact, variables: [{path: mechanism.flank_angle, from: 40 deg, to: 50 deg}], "
               "objectives: [{minimize: screw.peak_pressure_MPa.max}]}`");
  errors.throw_if_any();
  OptimizeItem item = *file.optimize;
  for (VariableItem& variable : item.variables) {
    take_indices(root, variable.path, variable.label);
    for (LinkedInputItem& linked : variable.companions) linked.path = with_indices(root, linked.path);
  }
  return item;
}

}  // namespace

OptimizeInput read_optimize_input(const Source& source) {
  ErrorList errors(source);
  const Node root = read_document(source, errors);
  const CaseFile whole = read_case_file(root, errors);
  const OptimizeItem item = written_optimization(whole, root, errors);
  const Case own = checked_case(whole, root, item.command, errors);
  check_paths(set_paths(item.variables, "optimize.variables"), "variable", false, root, errors);
  errors.throw_if_any();

  OptimizeInput input{{source, root, {}}, {}, {}};
  std::erase_if(input.start.base.children,
                [](const Node& child) { return child.key == "optimize" || child.key == "study"; });
  CaseFile file = read_case_file(input.start.base, errors);
  errors.throw_if_any();
  Study& study = input.optimization.study;
  study.command = item.command;
  study.plan = Plan::monte_carlo;
  VariableReader variables(item, source, root, input.start.base, file, errors);
  for (const auto i : indices(item.variables)) study.factors.push_back(variables.read(i));

  AimReader aims(item, root, whole.load_cases, input, errors);
  aims.read_objectives();
  aims.read_constraints();
  if (item.thread_constraints) aims.read_thread_constraints(own.mechanism);
  aims.read_algorithms();
  aims.read_compromise();
  check_load_cases(study.responses, set_paths(item.variables, "optimize.variables"), root, whole.load_cases, errors);
  errors.throw_if_any();
  input.start.study = study;
  return input;
}

}  // namespace prs::input
