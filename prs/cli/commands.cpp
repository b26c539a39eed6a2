#include "prs/cli/commands.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "prs/cli/deliver.h"
#include "prs/cli/option_values.h"
#include "prs/input/schema.h"
#include "prs/output/run_files.h"
#include "prs/record/figure_json.h"
#include "prs/run/compare_cases.h"
#include "prs/run/document_schema.h"
#include "prs/run/results_schema.h"

namespace prs::cli {

std::string case_name(const Options& options) {
  return options.file == kStandardInput ? "<stdin>" : options.file;
}

input::Source case_source(const Options& options) {
  if (options.file.empty()) throw UsageError("FILE is missing; expected a case, a YAML file");
  if (options.file != kStandardInput) return input::load_source(options.file, options.overrides);
  input::Source source = input::read_source(std::cin, case_name(options), options.overrides);
  if (std::ferror(stdin) != 0)
    throw input::InputError(
        fmt::format("{}:1:1: error: got a standard input that cannot be read; expected a case; "
                    "pipe a file into `prs .. -`",
                    case_name(options)));
  record_case(source.text, source.overrides);
  return source;
}

int run_case(const AnyAnalysis& row, const Options& options) {
  if (options.explain) return explain(options);
  const input::Source source = case_source(options);
  return deliver(run(row, source), document_info(source, row.command), options);
}

int compare(const Options& options) {
  if (options.other.empty()) return run_case(analysis_of(Command::compare), options);
  if (options.other == kStandardInput)
    throw UsageError("OTHER: got -; expected a file; standard input may be the first of the two");
  const input::Source source = case_source(options);
  Options second = options;
  second.file = options.other;
  return deliver(compare_cases(source, case_source(second)),
                 document_info(source, Command::compare), options);
}

int schema(const Options& options) {
  const std::string of = options.what.empty() ? "input" : options.what;
  const auto other = std::ranges::find(other_files(), of, &OtherFile::name);
  const std::string document = json_text(other != other_files().end() ? other->schema()
                                         : of == "input"              ? input::schema()
                                         : of == "results"            ? results_schema()
                                         : of == "figures"            ? figure_schema()
                                                                      : document_schema(of));
  if (options.output)
    write_files(*options.output,
                {{of == "input" ? "prs.schema.json" : fmt::format("prs.{}.json", of), document}});
  if (!options.quiet || options.json) print(document);
  return kDone;
}

}  // namespace prs::cli
