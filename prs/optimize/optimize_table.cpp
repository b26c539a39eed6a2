#include "prs/optimize/optimize_table.h"

#include <ranges>

#include "prs/loads/case_table.h"
#include "prs/record/table_units.h"
#include "prs/study/study_csv.h"
#include "prs/study/study_parts.h"

namespace prs {
namespace {

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
  for (std::size_t k = 0; k < optimization.study.responses.size(); ++k) {
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
    lines += fmt::format("{}  {}  {}  {}\n", fitted(printable(row.name), name_width, true),
                         fitted(row.initial, kValue), fitted(row.chosen, kValue),
                         padded(row.change, kChange, false));
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
  return lines_of({head}, name_width) + lines_of(variables, name_width) + '\n' +
         lines_of(responses, name_width);
}

std::string head(const OptimizationResult& result) {
  const Optimization& o = result.optimization;
  const SearchCounts counts = count(result.search);
  std::string text =
      fmt::format("{}: {} generations of {} designs, seed {}: {} feasible", name(o.algorithm),
                  o.generations, o.population, o.seed, counts.feasible);
  if (counts.without_answer > 0)
    text += fmt::format(", {} without an answer", counts.without_answer);
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
    const TableResponse response =
        table_response(result.optimization.study.responses[constraint.response]);
    const std::string& unit = response.title.unit;
    violated +=
        wrapped(fmt::format("violated: {}: {} against {}{}{}", printable(constraint.name),
                            number(response.factor * chosen.responses[constraint.response]),
                            number(response.factor * limit_of(constraint, chosen, result.initial)),
                            unit.empty() ? "" : " ", unit),
                "  ", kTableWidth);
  }
  return fmt::format("\n{} of {} constraints are kept, {} by the design in the file\n{}", kept,
                     all.size(), kept_before, violated);
}

/// A line that says so where the check found the design that is shown.
std::string from_check(const OptimizationResult& result) {
  const auto shown = result.compromise ? result.compromise : result.nearest;
  if (!shown || *shown < result.search.designs.size()) return "";
  return fmt::format("  the {} above is a design of {}\n",
                     result.compromise ? "compromise" : "nearest design",
                     name(result.check->algorithm));
}

std::string comparison(const OptimizationResult& result) {
  if (!result.check) return "";
  const SearchCounts counts = count(*result.check);
  std::string text =
      fmt::format("\nCheck by {}: {} feasible, {} on the front", name(result.check->algorithm),
                  counts.feasible, result.check->front.size());
  const FrontComparison& c = *result.comparison;
  if (c.best.empty()) return text + '\n' + from_check(result);
  text += fmt::format("; hypervolume {:.4f} against {:.4f}\n", c.check_hypervolume, c.hypervolume);
  for (std::size_t k = 0; k < c.best.size(); ++k) {
    const Objective& objective = result.optimization.objectives[k];
    const TableResponse response =
        table_response(result.optimization.study.responses[objective.response]);
    text += wrapped(
        fmt::format("best {}: {} against {} ({})", response.text(),
                    number(response.factor * c.check_best[k]), number(response.factor * c.best[k]),
                    change(c.best[k], c.check_best[k])),
        "  ", kTableWidth);
  }
  return text + from_check(result);
}

/// A reason without its numbers, which differ from design to design.
std::string without_numbers(const std::string& reason) {
  std::string text;
  for (const char c : reason)
    if ((c < '0' || c > '9') && c != '.' && c != '-') text += c;
  return text;
}

/// Why designs have no answer: the most frequent kinds of reasons, each by its first.
std::string failures(const OptimizationResult& result) {
  struct Reason {
    std::string kind, first;
    std::size_t designs = 0;
  };
  std::vector<Reason> reasons;
  for (const EvaluatedDesign& design : result.search.designs) {
    if (design.status.converged()) continue;
    const std::string kind = without_numbers(design.status.reason);
    auto reason = std::ranges::find(reasons, kind, &Reason::kind);
    if (reason == reasons.end()) reason = reasons.insert(reason, {kind, design.status.reason, 0});
    ++reason->designs;
  }
  std::ranges::stable_sort(reasons, std::ranges::greater{}, &Reason::designs);
  std::string text;
  for (const Reason& reason : std::span(reasons).first(std::min(kMostReasons, reasons.size())))
    text += wrapped(
        fmt::format("{} without an answer, the first: {}", reason.designs, printable(reason.first)),
        "", kTableWidth);
  if (reasons.size() > kMostReasons)
    text += fmt::format("… and {} other reasons; {}\n", reasons.size() - kMostReasons,
                        all_in("history.csv"));
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

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
  return text + design_table(result, *chosen) + constraints(result, *chosen) + comparison(result) +
         failures(result);
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
    csv.fields(number++, algorithm, generation, design.is_feasible(), design.violation,
               design.status.name, design.status.reason);
    design_fields(csv, optimization.study, design);
  };
  add("initial", std::nullopt, result.initial);
  for (const Search* search : {&result.search, result.check ? &*result.check : nullptr})
    for (std::size_t k = 0; search && k < search->designs.size(); ++k)
      add(name(search->algorithm), k / optimization.population + 1, search->designs[k]);
  return csv.take();
}

}  // namespace prs
