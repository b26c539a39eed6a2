#include "prs/compare/compare_analysis.h"

#include <algorithm>

#include "prs/compare/comparison_record.h"
#include "prs/compare/comparison_table.h"
#include "prs/loads/load_analysis.h"
#include "prs/loads/warnings.h"
#include "prs/model/void_inputs.h"

namespace prs {

Figures loads_by_model(const ModelComparison& result, const FigureOptions& options);

namespace {

ModelComparison compared(const input::Source&, const input::CaseInput& in) {
  ModelComparison result = compare_models(in.values);
  add_preload_note(in.values, result.warnings);
  return result;
}

std::vector<Warning> warnings_of(const ModelComparison& r) {
  return all_warnings(r.warnings, r.best().load_cases);
}

std::vector<std::string> notes(const ModelComparison& r) {
  std::string text = warning_summary(warnings_of(r));
  return text.empty() ? std::vector<std::string>{} : std::vector{std::move(text)};
}

}  // namespace

const Analysis<ModelComparison>& compare_analysis() {
  static const std::vector<Place> places =
      with_contacts({{"comparison", describe<ModelComparison>}});
  static const Analysis<ModelComparison> analysis{
      .command = Command::compare,
      .help = "The models of the bodies side by side, or two cases",
      .file = "comparison.json",
      .run = compared,
      .places = places,
      .put =
          [](nlohmann::ordered_json& document, const ModelComparison& r) {
            put_contacts(document, r.best().contacts);
            document["comparison"] = object_of(r);
          },
      .table = comparison_table,
      .notes = notes,
      .files =
          [](const ModelComparison& r, const CsvStyle& style) {
            return std::vector<OutputFile>{{"comparison.csv", comparison_csv(r, style)}};
          },
      .pictures = [](const ModelComparison& r, const Case&) -> Pictures {
        return {{"loads_by_model", "a load case that converged with every model",
                 of_result(r, loads_by_model)}};
      },
      .converged =
          [](const ModelComparison& r) { return std::ranges::all_of(r.models, all_converged); },
      .all_warnings = warnings_of,
      .takes_load_cases_apart = true};
  return analysis;
}

}  // namespace prs
