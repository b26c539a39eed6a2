#include "prs/optimize/optimize_csv.h"

#include "prs/optimize/optimize_designs.h"
#include "prs/record/csv_writer.h"
#include "prs/study/study_columns.h"

namespace prs {
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
