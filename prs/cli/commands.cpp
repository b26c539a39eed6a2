#include "prs/cli/commands.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "prs/cli/deliver.h"
#include "prs/cli/starting_case.h"
#include "prs/figures/figure_json.h"
#include "prs/input/schema.h"
#include "prs/output/lists.h"
#include "prs/output/measures_table.h"
#include "prs/quantities/measures_json.h"
#include "prs/quantities/results_schema.h"
#include "prs/run/responses.h"

namespace prs::cli {

int run_case(const CommandRow& row, const Options& options) {
  const input::Source source = input::load_source(options.file, options.overrides);
  return deliver(run(row, source), document_info(source), options);
}

int explain_measures(const Options& options) {
  print(options.json ? json_text(measure_explanations_json()) : measure_explanations());
  return kDone;
}

int list_commands(const Options& options) {
  std::optional<input::CaseInput> in;
  if (!options.file.empty())
    in =
        input::read_case_input(input::load_source(options.file, options.overrides), Command::check);
  for (const CommandRow& row : commands())
    if (!in || input::missing(*in, row.command).empty())
      print(fmt::format("{}\n", name(row.command)));
  return kDone;
}

int list_lubricants(const Options& options) {
  print(options.json ? json_text(lubricants_json()) : lubricants_table());
  return kDone;
}

int list_units(const Options& options) {
  print(options.json ? json_text(units_json()) : units_table());
  return kDone;
}

int list_responses(const Options& options) {
  const std::vector<std::string> paths =
      options.file.empty() ? known_responses()
                           : responses_of(input::load_source(options.file, options.overrides));
  print(options.json ? json_text(responses_json(paths)) : responses_table(paths));
  return kDone;
}

int schema(const Options& options) {
  const bool of_results = options.schema_of == "results",
             of_figures = options.schema_of == "figures";
  const std::string document = json_text(of_results   ? results_schema()
                                         : of_figures ? figure_schema()
                                                      : input::schema());
  if (options.output)
    write_files(*options.output, {{of_results   ? "prs.results.json"
                                   : of_figures ? "prs.figures.json"
                                                : "prs.schema.json",
                                   document}});
  if (!options.quiet || options.json) print(document);
  return kDone;
}

int new_case(const Options& options) {
  const std::string text(options.standard ? kStandardCase : kInvertedCase);
  if (options.file.empty()) {
    print(text);
    return kDone;
  }
  if (std::filesystem::exists(options.file)) {
    say(fmt::format("{}: error: the file exists already; give another name\n", options.file));
    return kWrongInput;
  }
  write_case(options.file, text);
  note(options,
       fmt::format("{}: written; `prs check {}` is the next step", options.file, options.file));
  return kDone;
}

}  // namespace prs::cli
