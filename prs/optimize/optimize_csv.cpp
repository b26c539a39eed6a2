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
  for (const std::string& path : study.responses) csv.text(path);
  csv.end_row();
}

void design_fields(CsvWriter& csv, const Study& study, const EvaluatedDesign& design) {
  for (const DrawnInput& drawn : drawn_inputs(study)) {
    const std::optional<Level> value = value_in(*drawn.input, design.draws[drawn.factor]);
    if (value && value->number)
      csv.number(value->number);
    else
      csv.text(value ? value->text : "");
  }
  for (const double response : design.responses) csv.number(response);
  csv.end_row();
}

void history_row(CsvWriter& csv, const Study& study, std::size_t number, std::string_view algorithm,
                 std::optional<std::size_t> generation, const EvaluatedDesign& design) {
  csv.integer(number);
  csv.text(algorithm);
  csv.integer(generation);
  csv.text(design.is_feasible() ? "true" : "false");
  csv.number(design.violation);
  csv.text(design.status.name);
  csv.text(design.status.reason);
  design_fields(csv, study, design);
}

}  // namespace

std::string front_csv(const OptimizationResult& result, const CsvStyle& style) {
  const Study& study = result.optimization.study;
  CsvWriter csv(style);
  for (const char* key : {"design", "compromise"}) csv.text(key);
  design_header(csv, study);
  for (const std::size_t k : result.front) {
    csv.integer(k + 1);
    csv.text(result.compromise == k ? "true" : "false");
    design_fields(csv, study, result.design(k));
  }
  return csv.take();
}

std::string history_csv(const OptimizationResult& result, const CsvStyle& style) {
  const Optimization& optimization = result.optimization;
  CsvWriter csv(style);
  for (const char* key :
       {"design", "algorithm", "generation", "feasible", "violation", "status", "reason"})
    csv.text(key);
  design_header(csv, optimization.study);
  std::size_t number = 0;
  history_row(csv, optimization.study, number++, "initial", std::nullopt, result.initial);
  const auto add = [&](const Search& search) {
    for (std::size_t k = 0; k < search.designs.size(); ++k)
      history_row(csv, optimization.study, number++, name(search.algorithm),
                  k / optimization.population + 1, search.designs[k]);
  };
  add(result.search);
  if (result.check) add(*result.check);
  return csv.take();
}

}  // namespace prs
