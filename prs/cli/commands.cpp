#include "prs/cli/commands.h"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "prs/cli/deliver.h"
#include "prs/cli/explain.h"
#include "prs/cli/starting_case.h"
#include "prs/cli/usage_error.h"
#include "prs/figures/figure_json.h"
#include "prs/input/schema.h"
#include "prs/output/run_files.h"
#include "prs/quantities/results_schema.h"

namespace prs::cli {

std::string case_name(const Options& options) {
  return options.file == kStandardInput ? "<stdin>" : options.file;
}

input::Source case_source(const Options& options) {
  if (options.file.empty()) throw UsageError("FILE is missing; expected a case, a YAML file");
  if (options.file != kStandardInput) return input::load_source(options.file, options.overrides);
  input::Source source = input::read_source(std::cin, case_name(options), options.overrides);
  record_case(source.text, source.overrides);
  return source;
}

int run_case(const CommandRow& row, const Options& options) {
  if (options.explain) return explain(options);
  const input::Source source = case_source(options);
  return deliver(run(row, source), document_info(source), options);
}

int schema(const Options& options) {
  const bool of_results = options.what == "results", of_figures = options.what == "figures";
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
  const std::string text(options.type == "standard" ? kStandardCase : kInvertedCase);
  if (options.file.empty()) {
    print(text);
    return kDone;
  }
  if (std::filesystem::exists(options.file))
    throw UsageError(
        fmt::format("{}: the file exists already; give another name", input::shown(options.file)));
  write_case(options.file, text);
  note(options,
       fmt::format("{}: written; `prs check {}` is the next step", options.file, options.file));
  return kDone;
}

}  // namespace prs::cli
