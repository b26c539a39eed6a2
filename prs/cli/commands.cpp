#include "prs/cli/commands.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "prs/cli/deliver.h"
#include "prs/cli/starting_case.h"
#include "prs/figures/figure_json.h"
#include "prs/input/schema.h"
#include "prs/output/document_schema.h"
#include "prs/output/measures_table.h"
#include "prs/quantities/measures_json.h"
#include "prs/quantities/results_schema.h"

namespace prs::cli {

int run_case(const CommandRow& row, const Options& options) {
  const input::Source source = input::load_source(options.file, options.overrides);
  return deliver(run(row, source), document_info(source, row.command), options);
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

int schema(const Options& options) {
  const std::string& of = options.schema_of;
  const std::string document = json_text(of == "input"     ? input::schema()
                                         : of == "results" ? results_schema()
                                         : of == "figures" ? figure_schema()
                                                           : document_schema(of));
  if (options.output)
    write_files(*options.output,
                {{of == "input" ? "prs.schema.json" : fmt::format("prs.{}.json", of), document}});
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
