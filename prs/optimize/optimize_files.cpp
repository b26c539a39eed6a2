#include "prs/optimize/optimize_files.h"

#include <ranges>

#include "prs/indices.h"
#include "prs/loads/case_table.h"
#include "prs/record/table_layout.h"
#include "prs/study/study_files.h"
#include "prs/study/study_pictures.h"

namespace prs {
namespace {

/// A design of a result, by its index among those of both searches.
struct DesignAt {
  const OptimizationResult* result = nullptr;
  const EvaluatedDesign* design = nullptr;
  std::size_t index = 0;

  const Study& study() const { return result->optimization.study; }
  std::size_t number() const { return index + 1; }
  bool is_feasible() const { return design->is_feasible(); }
};

using ConstraintOf = Within<DesignAt, Constraint>;
using SearchOf = Within<OptimizationResult, Search>;

struct Best {
  const OptimizationResult* result = nullptr;
  std::size_t objective = 0;
};

std::optional<DesignAt> design_at(const OptimizationResult& result, const std::optional<std::size_t>& index) {
  return index ? std::optional(DesignAt{&result, &result.design(*index), *index}) : std::nullopt;
}

// Whether a variable has listed values.

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
    {"weights", always<[](auto& o) { return o.compromise.weights; }, is_by<Compromise::By::weights>>},
    {"of", of<[](auto& o) { return o.study.responses[o.objectives[o.compromise.objective].response]; },
              is_by<Compromise::By::best>>},
};

constexpr Quantity<Optimization> kOptimizationRows[] = {
    {"command", always<[](auto& o) { return name(o.study.command); }>},
    {"variables", always_table<kVariableRows, [](auto& o) -> const std::vector<Factor>& { return o.study.factors; }>},
    {"objectives", always_table<kObjectiveRows, [](auto& o) { return within(o, o.objectives); }>},
    {"algorithm", always<&Optimization::algorithm>},
    {"check", of<&Optimization::check>},
    {"population", always<&Optimization::population>},
    {"generations", always<&Optimization::generations>},
    {"seed", always<&Optimization::seed>},
    {"compromise", always_table<kCompromiseRows>},
};

// Columns of designs.

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
    {"responses", always<[](auto& d) { return by_key(d.study().responses, d.design->responses); }>, "by their paths"},
};

constexpr Quantity<ConstraintOf> kConstraintRows[] = {
    {"name", always<its<&Constraint::name>>},
    {"constraint", always<[](auto& c) { return constraint_text(*c.whole->result, *c.item); }>},
    {"value", of<[](auto& c) { return c.whole->design->responses[c.item->response]; }>},
    {"limit", of<[](auto& c) { return limit_of(*c.item, *c.whole->design, c.whole->result->initial); }>},
    {"satisfied", always<[](auto& c) { return keeps(*c.item, *c.whole->design, c.whole->result->initial); }>},
};

constexpr auto constraints_of = [](const DesignAt& d) { return within(d, d.result->optimization.constraints); };

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
    {"algorithm", always<[](auto& d) { return d.result->search_of(d.index).algorithm; }>, "that found it"},
    {"", always_table<kDesignRows>},
    as_shown<DesignAt>({"change_percent", always<[](auto& d) {
                          std::vector<std::optional<double>> changes;
                          for (const auto k : indices(d.design->responses))
                            changes.push_back(change_percent(d.design->responses[k], d.result->initial.responses[k]));
                          return by_key(d.study().responses, changes);
                        }>,
                        "against the file's own design"}),
    {"constraints", always_table<kConstraintRows, constraints_of>},
    {"set", always<[](auto& d) { return settings_of(d.result->optimization, *d.design); }>,
     "what `--set` takes for it"},
};

constexpr Quantity<SearchOf> kSearchRows[] = {
    {"algorithm", always<its<&Search::algorithm>>},
    {"designs", always<[](auto& s) { return count(*s.item).designs; }>},
    {"feasible", always<[](auto& s) { return count(*s.item).feasible; }>},
    {"without_answer", always<[](auto& s) { return count(*s.item).without_answer; }>},
    {"front", always_table<kNumberedRows,
                           [](auto& s) {
                             const std::size_t first = s.item == &s.whole->search ? 0 : s.whole->search.designs.size();
                             return each(s.item->front, [&](std::size_t k) {
                               return DesignAt{s.whole, &s.item->designs[k], first + k};
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
                            for (const auto k : indices(r.comparison->best)) all.push_back({&r, k});
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
                         return r.check ? std::optional(SearchOf{&r, &*r.check}) : std::nullopt;
                       }>},
    {"comparison", of_table<kComparisonRows, std::identity{}, [](auto& r) { return r.comparison.has_value(); }>},
};

constexpr std::size_t kMaxName = 48;
constexpr std::size_t kValue = 16;
constexpr std::size_t kChange = 10;
constexpr std::size_t kMostReasons = 4;

struct Row {
  std::string name, initial, chosen, change;
};

std::string number(double value) { return digits(value, 6); }

std::string change(std::optional<double> from, std::optional<double> to) {
  const std::optional<double> percent = from && to ? change_percent(*to, *from) : std::nullopt;
  return percent ? fixed_change(*percent, 2) + " %" : "";
}

std::string text_of(const std::optional<Level>& level, const Factor& input) {
  return level ? level_text(*level, input.unit) : std::string(kAbsent);
}

std::vector<Row> variable_rows(const OptimizationResult& result, const EvaluatedDesign& chosen) {
  std::vector<Row> rows;
  for (const DrawnInput& drawn : drawn_inputs(result.optimization.study)) {
    const Factor& input = *drawn.input;
    const std::optional<Level> from = input.base, to = value_in(input, chosen.draws[drawn.factor]);
    rows.push_back({factor_title(input), text_of(from, input), text_of(to, input),
                    from && to ? change(from->number, to->number) : ""});
  }
  return rows;
}

std::vector<Row> response_rows(const OptimizationResult& result, const EvaluatedDesign& chosen) {
  const Optimization& optimization = result.optimization;
  std::vector<Row> rows;
  for (const auto k : indices(optimization.study.responses)) {
    const auto objective = std::ranges::find(optimization.objectives, k, &Objective::response);
    const bool wanted = objective != optimization.objectives.end();
    const char* aim = !wanted ? "" : objective->maximize ? "max. " : "min. ";
    const TableResponse response = table_response(optimization.study.responses[k]);
    const double from = result.initial.responses[k], to = chosen.responses[k];
    rows.push_back({fmt::format("{}{}", aim, response.text()), number(response.factor * from),
                    number(response.factor * to), change(from, to)});
  }
  return rows;
}

std::string lines_of(const std::vector<Row>& rows, std::size_t name_width) {
  std::string lines;
  for (const Row& row : rows)
    lines += fmt::format("{}  {}  {}  {}\n", fitted(printable(row.name), name_width, true), fitted(row.initial, kValue),
                         fitted(row.chosen, kValue), padded(row.change, kChange, false));
  return lines;
}

std::string design_table(const OptimizationResult& result, const EvaluatedDesign& chosen) {
  const std::vector<Row> variables = variable_rows(result, chosen);
  const std::vector<Row> responses = response_rows(result, chosen);
  std::size_t name_width = 0;
  for (const std::vector<Row>* rows : {&variables, &responses})
    for (const Row& row : *rows) name_width = std::max(name_width, width(printable(row.name)));
  name_width = std::min(name_width, kMaxName);
  const Row head{"", "as in the file", result.compromise ? "compromise" : "nearest", "change"};
  return lines_of({head}, name_width) + lines_of(variables, name_width) + '\n' + lines_of(responses, name_width);
}

std::string head(const OptimizationResult& result) {
  const Optimization& o = result.optimization;
  const SearchCounts counts = count(result.search);
  std::string text = fmt::format("{}: {} generations of {} designs, seed {}: {} feasible", name(o.algorithm),
                                 o.generations, o.population, o.seed, counts.feasible);
  if (counts.without_answer > 0) text += fmt::format(", {} without an answer", counts.without_answer);
  if (o.objectives.size() > 1) text += fmt::format(", {} on the front", result.search.front.size());
  return text + "\n\n";
}

std::string constraints(const OptimizationResult& result, const EvaluatedDesign& chosen) {
  const std::vector<Constraint>& all = result.optimization.constraints;
  if (all.empty()) return "";
  std::string violated;
  std::size_t kept = 0, kept_before = 0;
  for (const Constraint& constraint : all) {
    if (keeps(constraint, result.initial, result.initial)) ++kept_before;
    if (keeps(constraint, chosen, result.initial)) {
      ++kept;
      continue;
    }
    const TableResponse response = table_response(result.optimization.study.responses[constraint.response]);
    const std::string& unit = response.title.unit;
    violated += wrapped(fmt::format("violated: {}: {} against {}{}{}", printable(constraint.name),
                                    number(response.factor * chosen.responses[constraint.response]),
                                    number(response.factor * limit_of(constraint, chosen, result.initial)),
                                    unit.empty() ? "" : " ", unit),
                        "  ", kTableWidth);
  }
  return fmt::format("\n{} of {} constraints are kept, {} by the design in the file\n{}", kept, all.size(), kept_before,
                     violated);
}

/// A line that says so if the check found the shown design.
std::string from_check(const OptimizationResult& result) {
  const auto shown = result.compromise ? result.compromise : result.nearest;
  if (!shown || *shown < result.search.designs.size()) return "";
  return fmt::format("  the {} above is a design of {}\n", result.compromise ? "compromise" : "nearest design",
                     name(result.check->algorithm));
}

std::string comparison(const OptimizationResult& result) {
  if (!result.check) return "";
  const SearchCounts counts = count(*result.check);
  std::string text = fmt::format("\nCheck by {}: {} feasible, {} on the front", name(result.check->algorithm),
                                 counts.feasible, result.check->front.size());
  const FrontComparison& c = *result.comparison;
  if (c.best.empty()) return text + '\n' + from_check(result);
  text += fmt::format("; hypervolume {:.4f} against {:.4f}\n", c.check_hypervolume, c.hypervolume);
  for (const auto k : indices(c.best)) {
    const Objective& objective = result.optimization.objectives[k];
    const TableResponse response = table_response(result.optimization.study.responses[objective.response]);
    text +=
        wrapped(fmt::format("best {}: {} against {} ({})", response.text(), number(response.factor * c.check_best[k]),
                            number(response.factor * c.best[k]), change(c.best[k], c.check_best[k])),
                "  ", kTableWidth);
  }
  return text + from_check(result);
}

/// Kind of failure; for refused designs by the key of the input, wherever it is in the file, for others by their
/// status.
std::string kind_of(const DesignStatus& status) {
  if (status.name != "refused") return status.name;
  constexpr std::string_view kPlaceEnds = ": error: ";
  const std::size_t place = status.reason.find(kPlaceEnds);
  const std::size_t key = place == std::string::npos ? 0 : place + kPlaceEnds.size();
  return status.reason.substr(key, status.reason.find(": ", key) - key);
}

/// Reasons why designs have no result: the most frequent kinds, each by its first.
std::string failures(const OptimizationResult& result) {
  struct Reason {
    std::string kind, first;
    std::size_t designs = 0;
  };
  std::vector<Reason> reasons;
  for (const EvaluatedDesign& design : result.search.designs) {
    if (design.status.converged()) continue;
    const std::string kind = kind_of(design.status);
    auto reason = std::ranges::find(reasons, kind, &Reason::kind);
    if (reason == reasons.end()) reason = reasons.insert(reason, {kind, design.status.reason, 0});
    ++reason->designs;
  }
  std::ranges::stable_sort(reasons, std::ranges::greater{}, &Reason::designs);
  std::string text;
  for (const Reason& reason : std::span(reasons).first(std::min(kMostReasons, reasons.size())))
    text += wrapped(fmt::format("{} without an answer, the first: {}", reason.designs, printable(reason.first)), "",
                    kTableWidth);
  if (reasons.size() > kMostReasons)
    text += fmt::format("… and {} other reasons; {}\n", reasons.size() - kMostReasons, all_in("history.csv"));
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

PRS_RECORD(OptimizationResult, "Optimization", "The request and the best designs.", kResultRows);

nlohmann::ordered_json optimize_json(const OptimizationResult& result, const DocumentInfo& info) {
  nlohmann::ordered_json document = document_head(info, {});
  put_object(document, result);
  return document;
}

std::string optimize_failure(const OptimizationResult& result) {
  if (result.compromise) return "";
  if (!result.chosen()) return "No design has an answer.\n" + failures(result);
  return "No design keeps all constraints; the document has the nearest one.\n";
}

std::string optimize_table(const OptimizationResult& result) {
  const EvaluatedDesign* chosen = result.chosen();
  std::string text = head(result);
  if (!chosen) return text + optimize_failure(result);
  if (!result.compromise) text += "No design keeps all constraints; the nearest one:\n\n";
  return text + design_table(result, *chosen) + constraints(result, *chosen) + comparison(result) + failures(result);
}

namespace {

void design_header(CsvWriter& csv, const Study& study) {
  for (const DrawnInput& drawn : drawn_inputs(study)) {
    const std::string& unit = drawn.input->unit;
    csv.text(unit.empty() ? drawn.input->path : drawn.input->path + "_" + unit_key(unit));
  }
  csv.row(study.responses);
}

void design_fields(CsvWriter& csv, const Study& study, const EvaluatedDesign& design) {
  for (const DrawnInput& drawn : drawn_inputs(study)) {
    const std::optional<Level> value = value_in(*drawn.input, design.draws[drawn.factor]);
    if (value && value->number)
      csv.number(value->number);
    else
      csv.text(value ? value->text : "");
  }
  csv.row(design.responses);
}

}  // namespace

std::string front_csv(const OptimizationResult& result, const CsvStyle& style) {
  const Study& study = result.optimization.study;
  CsvWriter csv(style);
  csv.fields("design", "compromise");
  design_header(csv, study);
  for (const std::size_t k : result.front) {
    csv.fields(k + 1, result.compromise == k);
    design_fields(csv, study, result.design(k));
  }
  return csv.take();
}

std::string history_csv(const OptimizationResult& result, const CsvStyle& style) {
  const Optimization& optimization = result.optimization;
  CsvWriter csv(style);
  csv.fields("design", "algorithm", "generation", "feasible", "violation", "status", "reason");
  design_header(csv, optimization.study);
  std::size_t number = 0;
  const auto add = [&](std::string_view algorithm, std::optional<std::size_t> generation,
                       const EvaluatedDesign& design) {
    csv.fields(number++, algorithm, generation, design.is_feasible(), design.violation, design.status.name,
               design.status.reason);
    design_fields(csv, optimization.study, design);
  };
  add("initial", std::nullopt, result.initial);
  for (const Search* search : {&result.search, result.check ? &*result.check : nullptr})
    for (std::size_t k = 0; search && k < search->designs.size(); ++k)
      add(name(search->algorithm), k / optimization.population + 1, search->designs[k]);
  return csv.take();
}

namespace {

using input::ErrorList;
using input::Node;
using input::Source;

Node document_of(const Source& source) {
  ErrorList errors(source);
  Node root = input::read_document(source, errors);
  errors.throw_if_any();
  return root;
}

/// The document as text, the keys of its maps in alphabetic order.
std::string in_order(Node node) {
  const auto sort = [](const auto& self, Node& map) -> void {
    for (Node& child : map.children) self(self, child);
    if (map.kind == Node::Kind::map) std::ranges::sort(map.children, {}, &Node::key);
  };
  sort(sort, node);
  return input::flow_text(node);
}

/// A piece of the text and its replacement.
struct Edit {
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string text = {};
};

/// `b: {c: value}` for `b.c`.
std::string nested(std::string_view rest, const std::string& value) {
  const std::size_t dot = rest.find('.');
  if (dot == std::string_view::npos) return fmt::format("{}: {}", rest, value);
  return fmt::format("{}: {{{}}}", rest.substr(0, dot), nested(rest.substr(dot + 1), value));
}

/// Adds a key to the map that has the longest part of the path: at the end of the file, else before
/// the first key of the map.
std::optional<Edit> insertion(const std::string& text, const Node& root, const std::string& path,
                              const std::string& value) {
  std::size_t dot = path.rfind('.');
  while (dot != std::string::npos && !input::find_path(root, path.substr(0, dot)))
    dot = dot == 0 ? std::string::npos : path.rfind('.', dot - 1);
  if (dot == std::string::npos) {
    const bool ended = text.empty() || text.back() == '\n';
    return Edit{text.size(), 0, fmt::format("{}{}\n", ended ? "" : "\n", nested(path, value))};
  }
  const Node& map = *input::find_path(root, path.substr(0, dot));
  if (map.kind != Node::Kind::map || map.children.empty()) return std::nullopt;
  const std::size_t at = map.children[0].key_place.offset;
  const std::size_t line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  const std::string before = text.substr(line, at - line);
  const bool own_line = before.find_first_not_of(' ') == std::string::npos;
  return Edit{at, 0, nested(path.substr(dot + 1), value) + (own_line ? "\n" + before : ", ")};
}

/// The text with each override in place of the scalar that it replaces, or added; none if an override has no such
/// place.
std::optional<std::string> edited(const Source& source) {
  std::map<std::string, std::string> last;  // Later overrides of a path win.
  for (const std::string& override : source.overrides)
    last[override.substr(0, override.find('='))] = override.substr(override.find('=') + 1);
  std::string text = source.text;
  for (const auto& [path, value] : last) {
    const Node root = document_of({source.name, text, {}});
    std::optional<Edit> edit;
    if (const Node* node = input::find_path(root, path); !node)
      edit = insertion(text, root, path, value);
    else if (const std::size_t at = node->place.offset;
             node->kind == Node::Kind::scalar && !node->quoted && text.compare(at, node->text.size(), node->text) == 0)
      edit = {at, node->text.size(), value};
    if (!edit) return std::nullopt;
    text.replace(edit->offset, edit->length, edit->text);
  }
  return text;
}

/// Maps and lists of maps over lines, the rest on one line each.
void write_block(const Node& node, std::size_t indent, std::string& text) {
  for (const Node& child : node.children) {
    text += fmt::format("{:{}}{}:", "", indent, child.key);
    if (child.kind == Node::Kind::map && !child.children.empty()) {
      text += '\n';
      write_block(child, indent + 2, text);
    } else if (child.kind == Node::Kind::sequence && !child.children.empty() &&
               child.children[0].kind == Node::Kind::map) {
      text += '\n';
      for (const Node& item : child.children)
        text += fmt::format("{:{}}- {}\n", "", indent + 2, input::flow_text(item));
    } else {
      text += fmt::format(" {}\n", input::flow_text(child));
    }
  }
}

}  // namespace

std::string case_with(const Source& source, const std::vector<std::string>& overrides, const std::string& remark) {
  Source changed = source;
  changed.overrides.insert(changed.overrides.end(), overrides.begin(), overrides.end());
  const Node wanted = document_of(changed);
  const std::string expected = in_order(wanted);
  const std::string head = fmt::format("# {}\n", printable(remark));
  try {
    if (const std::optional<std::string> text = edited(changed);
        text && in_order(document_of({source.name, *text, {}})) == expected)
      return head + *text;
  } catch (const input::InputError&) {
    // The document is then rewritten.
  }
  std::string text = head;
  write_block(wanted, 0, text);
  return text;
}

}  // namespace prs
