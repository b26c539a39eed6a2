#include "prs/cli/commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "prs/cli/printing.h"
#include "prs/cli/starting_case.h"
#include "prs/quantities/json.h"
#include "prs/quantities/life_json.h"
#include "prs/quantities/measures_json.h"
#include "prs/quantities/preload_json.h"
#include "prs/input/reader.h"
#include "prs/input/schema.h"
#include "prs/output/check.h"
#include "prs/output/contact_table.h"
#include "prs/output/csv.h"
#include "prs/output/files.h"
#include "prs/figures/life_figures.h"
#include "prs/output/life_files.h"
#include "prs/output/life_table.h"
#include "prs/figures/measures_figures.h"
#include "prs/output/measures_table.h"
#include "prs/output/plots.h"
#include "prs/figures/preload_figures.h"
#include "prs/output/preload_files.h"
#include "prs/output/preload_table.h"
#include "prs/output/slip_csv.h"
#include "prs/output/slip_table.h"
#include "prs/output/table.h"
#include "prs/output/warnings.h"
#include "prs/run/analyses.h"
#include "prs/validation/validate.h"
#include "prs/version.h"
#include "validation/abevi_2015/statements.h"
#include "validation/jung_2017/contribution.h"
#include "validation/jung_2017/recipe.h"
#include "validation/reference_fe/contribution.h"
#include "validation/sandu_2018/contribution.h"
#include "validation/standard_screws/contribution.h"
#include "validation/yao_2023/contribution.h"

namespace prs::cli {
namespace {

/// The JSON document, where it is asked for.
std::string document_of(const Result& result, const input::Source& source, const Options& options) {
  if (!options.json && !options.output) return {};
  return json_text(to_json(result, document_info(source)));
}

/// One document with the warnings beside it, or the table that `table` makes.
template <class Table>
void print_result(const Result& result, const Options& options, const std::string& document,
                  Table table) {
  if (options.json) {
    print(document);
    const std::string warnings = warning_summary(result);
    if (!warnings.empty()) note(options, warnings);
    return;
  }
  if (options.quiet) return;
  print(table());
  if (options.output) print(fmt::format("\nFiles: {}\n", options.output->string()));
}

/// The cases that a terminal shows thread by thread: not the points of a range.
constexpr std::size_t kMostCharts = 1;

/// The cases whose patches and residue are drawn.
constexpr std::size_t kMostPatches = 4;

std::vector<std::pair<std::size_t, SlipPictures>> pictures_of(const Case& c, const Result& result) {
  std::vector<std::pair<std::size_t, SlipPictures>> pictures;
  for (std::size_t k = 0; k < result.load_cases.size() && pictures.size() < kMostPatches; ++k)
    if (result.load_cases[k].slip && result.load_cases[k].slip->converged())
      pictures.emplace_back(k, slip_pictures(c, result, k));
  return pictures;
}

bool all_converged(const Result& result) {
  return std::ranges::all_of(result.load_cases, &LoadCaseResult::converged);
}

/// The document, and below the name of each source what its code wrote and drew; false where a
/// picture is missing.
bool write_validation(const std::vector<SourceReport>& reports, const std::string& document,
                      const Options& options) {
  bool written = true;
  write_files(*options.output, {{"validation.json", document}});
  for (const SourceReport& report : reports) {
    const std::filesystem::path folder = *options.output / report.name;
    if (!report.files.empty()) write_files(folder, report.files);
    written &= cli::report(draw_figures(report.figures, folder), options);
  }
  return written;
}

}  // namespace

int check(const Options& options) {
  const input::Source source = input::load_source(options.file, options.overrides);
  const CheckResult result = run_check(source, input::read_case_input(source, Command::check));
  const std::string document =
      json_text(check_json(result.fields, result.contacts, result.warnings, document_info(source)));
  if (options.output) write_files(*options.output, {{"check.json", document}});
  if (options.json) {
    print(document);
    for (const std::string& warning : result.warnings) note(options, "warning: " + warning);
  } else if (!options.quiet) {
    print(check_table(result.fields, result.contacts, result.warnings));
  }
  return kDone;
}

int contact(const Options& options) {
  const input::Source source = input::load_source(options.file, options.overrides);
  const input::CaseInput in = input::read_case_input(source, Command::contact);
  const Result result = run_contact(source, in.values);
  const std::string document = document_of(result, source, options);
  bool written = true;
  if (options.output) {
    write_files(*options.output, {{"contact.json", document}});
    written = report(draw_contact_plots(result, *options.output), options);
  }
  print_result(result, options, document, [&] { return contact_table(result); });
  return exit_status(written, true);
}

int solve(const Options& options) {
  const input::Source source = input::load_source(options.file, options.overrides);
  const input::CaseInput in = input::read_case_input(source, Command::solve);
  const Result result = run_solve(source, in.values);
  const std::string document = document_of(result, source, options);
  bool written = true;
  if (options.output) {
    write_files(*options.output, {{"result.json", document},
                                  {"load_cases.csv", load_cases_csv(result)},
                                  {"load_distribution.csv", load_distribution_csv(result)}});
    written = report(draw_plots(result, *options.output), options);
  }
  print_result(result, options, document, [&] {
    std::string text = load_case_table(result);
    if (result.load_cases.size() <= kMostCharts)
      for (const LoadCaseResult& r : result.load_cases)
        text.append("\n").append(load_distribution_chart(r));
    return text;
  });
  return exit_status(written, all_converged(result));
}

int slip(const Options& options) {
  const input::Source source = input::load_source(options.file, options.overrides);
  const input::CaseInput in = input::read_case_input(source, Command::slip);
  const Result result = run_slip(source, in.values);
  const std::string document = document_of(result, source, options);
  bool written = true;
  if (options.output) {
    write_files(*options.output, {{"slip.json", document},
                                  {"load_cases.csv", load_cases_csv(result)},
                                  {"load_distribution.csv", load_distribution_csv(result)},
                                  {"slip.csv", slip_csv(result)},
                                  {"slip_threads.csv", slip_threads_csv(result)}});
    written =
        report(draw_slip_plots(result, pictures_of(in.values, result), *options.output), options);
  }
  print_result(result, options, document, [&] {
    std::string text = slip_table(result);
    if (result.load_cases.size() <= kMostCharts)
      for (const LoadCaseResult& r : result.load_cases)
        if (r.load_case.share == LoadCase::Share::solved) text.append("\n").append(slip_chart(r));
    return text;
  });
  const bool converged = std::ranges::all_of(result.load_cases, [](const LoadCaseResult& r) {
    return r.converged() && r.slip && r.slip->converged();
  });
  return exit_status(written, converged);
}

int preload(const Options& options) {
  const input::Source source = input::load_source(options.file, options.overrides);
  const input::CaseInput in = input::read_case_input(source, Command::preload);
  const PreloadResult result = run_preload(source, in.values);
  std::string document;
  if (options.json || options.output)
    document = json_text(preload_json(result, document_info(source)));
  bool written = true;
  if (options.output) {
    write_files(*options.output,
                {{"preload.json", document}, {"preload.csv", preload_csv(result)}});
    written = report(draw_figures(preload_figures(result), *options.output), options);
  }
  if (options.json) {
    print(document);
    for (const std::string& warning : result.warnings) note(options, "warning: " + warning);
  } else if (!options.quiet) {
    print(preload_table(result));
    if (options.output) print(fmt::format("\nFiles: {}\n", options.output->string()));
  }
  return exit_status(written, result.converged());
}

int life(const Options& options) {
  const input::Source source = input::load_source(options.file, options.overrides);
  const input::CaseInput in = input::read_case_input(source, Command::life);
  const LifeResult result = run_life(source, in.values);
  std::string document;
  if (options.json || options.output)
    document = json_text(life_json(result, document_info(source)));
  bool written = true;
  if (options.output) {
    std::vector<OutputFile> files = {{"life.json", document},
                                     {"life_threads.csv", life_threads_csv(result)}};
    if (result.cycles) {
      files.push_back({"cycles.csv", cycles_csv(*result.cycles)});
      files.push_back({"cycle_matrix.csv", cycle_matrix_csv(result.cycles->matrix)});
    }
    write_files(*options.output, files);
    written = report(draw_figures(life_figures(result), *options.output), options);
  }
  if (options.json) {
    print(document);
    for (const std::string& warning : result.warnings) note(options, "warning: " + warning);
  } else if (!options.quiet) {
    print(life_table(result));
    if (options.output) print(fmt::format("\nFiles: {}\n", options.output->string()));
  }
  return exit_status(written, result.converged());
}

int measures(const Options& options) {
  if (options.explain) {
    print(options.json ? json_text(measure_explanations_json()) : measure_explanations());
    return kDone;
  }
  const input::Source source = input::load_source(options.file, options.overrides);
  const input::CaseInput in = input::read_case_input(source, Command::measures);
  const MeasuresResult result = run_measures(source, in.values);
  std::string document;
  if (options.json || options.output)
    document = json_text(measures_json(result, document_info(source)));
  bool written = true;
  if (options.output) {
    write_files(*options.output, {{"measures.json", document},
                                  {"measures.csv", measures_csv(result)},
                                  {"yang.csv", yang_csv(result)}});
    written = report(draw_figures(measures_figures(result), *options.output), options);
  }
  print_result(result.analysis, options, document, [&] { return measures_table(result); });
  return exit_status(written, all_converged(result.analysis));
}

int schema(const Options& options) {
  const std::string document = json_text(input::schema());
  if (options.output) write_files(*options.output, {{"prs.schema.json", document}});
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

int validate(const Options& options) {
  if (!std::filesystem::is_directory(options.file)) {
    say(fmt::format("{}: error: no such folder; give the folder of the sources as DIR\n",
                    options.file));
    return kWrongInput;
  }
  const std::vector<SourceReport> reports =
      prs::validate(options.file, {{"abevi_2015", abevi_2015::judge_statements},
                                   jung_2017::contribution(),
                                   reference_fe::contribution(),
                                   sandu_2018::contribution(),
                                   standard_screws::contribution(),
                                   yao_2023::contribution()});
  if (reports.empty()) {
    say(fmt::format("{}: error: no folder with a reference.yaml\n", options.file));
    return kWrongInput;
  }
  const std::string document =
      json_text(validation_json(reports, {kVersion, kSchemaVersion, "", {}}));
  const bool written = !options.output || write_validation(reports, document, options);
  if (options.json) {
    print(document);
  } else if (!options.quiet) {
    print(validation_text(reports));
    if (options.output) print(fmt::format("Files: {}\n", options.output->string()));
  }
  for (const SourceReport& report : reports)
    for (const Comparison& comparison : report.comparisons)
      if (comparison.unexpected()) return kFailed;
  return exit_status(written, true);
}

int recipe(const Options& options) {
  const jung_2017::Recipe* recipe = jung_2017::find_recipe(options.recipe.value_or(""));
  if (recipe == nullptr) {
    std::vector<std::string_view> names;
    for (const jung_2017::Recipe& known : jung_2017::recipes()) names.push_back(known.name);
    say(fmt::format("prs validate: error: --recipe: got {}; expected one of {}\n",
                    input::shown(options.recipe.value_or("")), fmt::join(names, ", ")));
    return kWrongInput;
  }
  const std::vector<jung_2017::Diameters> rows =
      jung_2017::read_diameters(options.file, options.diameters);
  const std::string document =
      json_text(jung_2017::recipe_json(*recipe, rows, {kVersion, kSchemaVersion, "", {}}));
  if (options.output)
    write_files(*options.output,
                {{"recipe.json", document}, {"recipe.csv", jung_2017::recipe_csv(*recipe, rows)}});
  if (options.json) {
    print(document);
  } else if (!options.quiet) {
    print(jung_2017::recipe_text(*recipe, rows));
    if (options.output) print(fmt::format("\nFiles: {}\n", options.output->string()));
  }
  return kDone;
}

}  // namespace prs::cli
