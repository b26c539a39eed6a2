#include "prs/run/commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "modules/module.h"
#include "prs/compare/compare_models.h"
#include "prs/figures/pictures.h"
#include "prs/heat/analyze_heat.h"
#include "prs/input/assumptions.h"
#include "prs/input/compute_from.h"
#include "prs/input/force_history.h"
#include "prs/input/optimize_reader.h"
#include "prs/input/resolved_input.h"
#include "prs/input/study_reader.h"
#include "prs/life/analyze_life.h"
#include "prs/loads/analyze.h"
#include "prs/loads/load_case_result.h"
#include "prs/measures/analyze_measures.h"
#include "prs/model/case_error.h"
#include "prs/model/void_inputs.h"
#include "prs/output/check.h"
#include "prs/output/comparison.h"
#include "prs/output/contact_table.h"
#include "prs/output/csv.h"
#include "prs/output/heat_csv.h"
#include "prs/output/life_files.h"
#include "prs/output/life_table.h"
#include "prs/output/measures_table.h"
#include "prs/output/preload_files.h"
#include "prs/output/preload_table.h"
#include "prs/output/slip_csv.h"
#include "prs/output/slip_table.h"
#include "prs/output/table.h"
#include "prs/output/warnings.h"
#include "prs/preload/analyze_preload.h"
#include "prs/quantities/case_groups.h"
#include "prs/quantities/comparison_quantities.h"
#include "prs/quantities/factorization.h"
#include "prs/quantities/life_json.h"
#include "prs/quantities/load_case_stream.h"
#include "prs/quantities/measures_json.h"
#include "prs/quantities/preload_json.h"
#include "prs/quantities/verdict.h"
#include "prs/sha256.h"
#include "prs/text.h"
#include "prs/threads/geometry_warnings.h"
#include "prs/version.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

/// What one command makes of its result.
template <class R>
struct Forms {
  const char* file;  ///< Name of the document.
  Json (*document)(const R&, const DocumentInfo&);
  std::string (*table)(const R&);
  std::vector<std::string> (*notes)(const R&);
  std::string (*full_table)(const R&) = nullptr;
  std::vector<OutputFile> (*files)(const R&, const CsvStyle&) = nullptr;
  Pictures (*pictures)(const R&, const Case&) = nullptr;
  std::vector<std::string> (*without_figure)(const R&) = nullptr;
  bool (*converged)(const R&) = nullptr;
  Json (*outline)(const R&, const DocumentInfo&) = nullptr;  ///< The document without load cases.
  std::optional<Json> (*load_case)(const R&, std::size_t) = nullptr;
  void (*facts)(const R&, VerdictFacts&) = nullptr;
};

template <class R>
std::vector<Warning>& warnings_of(R& result) {
  return result.warnings;
}
std::vector<Warning>& warnings_of(CheckResult& result) { return result.geometry.warnings; }
std::vector<Warning>& warnings_of(MeasuresResult& result) { return result.analysis.warnings; }

template <class R>
std::vector<Warning> all_warnings(const R& result) {
  return result.warnings;
}
std::vector<Warning> all_warnings(const CheckResult& r) { return r.geometry.warnings; }
std::vector<Warning> all_warnings(const MeasuresResult& r) { return prs::all_warnings(r.analysis); }
std::vector<Warning> all_warnings(const ModelComparison& r) {
  return prs::all_warnings(r.warnings, r.best().load_cases);
}

/// Warnings on single values; what they bring about has no warning of its own.
void put_first(const std::vector<Warning>& values, std::vector<Warning>& warnings) {
  for (const Warning& value : values)
    std::erase_if(warnings, [&](const Warning& w) { return w.path == value.path; });
  warnings.insert(warnings.begin(), values.begin(), values.end());
}

/// What `run` finds wrong with the case is reported where it stands.
template <class R, class Run>
Delivery delivered(const input::Source& source, const input::CaseInput& in, const Run& run,
                   const Forms<R>& forms) {
  R computed = input::compute_from(source, [&] { return run(source, in); });
  put_first(in.warnings, warnings_of(computed));
  const auto result = std::make_shared<const R>(std::move(computed));
  Delivery d{forms.file, [=](const DocumentInfo& info) { return forms.document(*result, info); },
             [=] { return forms.table(*result); }, forms.notes(*result),
             [=] { return all_warnings(*result); }};
  if (forms.full_table) d.full_table = [=] { return forms.full_table(*result); };
  if (forms.files) d.files = [=](const CsvStyle& style) { return forms.files(*result, style); };
  if (forms.pictures)
    d.pictures = [=, c = std::make_shared<const Case>(in.values)] {
      return forms.pictures(*result, *c);
    };
  if (forms.without_figure) d.without_figure = forms.without_figure(*result);
  if (forms.converged) d.converged = forms.converged(*result);
  if (forms.outline) {
    d.outline = [=](const DocumentInfo& info) { return forms.outline(*result, info); };
    d.write = [=](const Json& outline, const TextSink& sink) {
      write_with_load_cases(
          outline, [&](std::size_t k) { return forms.load_case(*result, k); }, sink);
    };
  }
  if (forms.facts) d.facts = [=](VerdictFacts& facts) { forms.facts(*result, facts); };
  return d;
}

template <class R>
CommandRow row(Command command, std::string_view help,
               R (*run)(const input::Source&, const input::CaseInput&), const Forms<R>& forms) {
  return {command, help, [=](const input::Source& source, const input::CaseInput& in) {
            return delivered(source, in, run, forms);
          }};
}

// What each computes, with the warnings that belong to the command.

LifeResult life_of(const input::Source& source, const input::CaseInput& in);

/// What `solve` finds unusual about the largest loads, and `life` about those of its block.
std::vector<Warning> solved_load_warnings(const input::Source& source, const input::CaseInput& in,
                                          double largest) {
  Case c = in.values;
  std::erase_if(c.load_cases,
                [&](const LoadCase& load) { return std::abs(load.axial_force) < largest; });
  std::vector<Warning> warnings = prs::all_warnings({}, analyze(c).load_cases);
  if (input::unmet(in, Command::life).empty())
    std::ranges::move(life_of(source, in).warnings, std::back_inserter(warnings));
  return warnings;
}

/// With equal shares, the least that its most loaded threads carry.
std::vector<Warning> equal_share_warnings(const LoadCase& load, const Contacts& contacts) {
  if (!contacts.interfaces.screw.has_hertz() || !contacts.interfaces.nut.has_hertz()) return {};
  LoadCaseResult loaded = equal_share_result(load, contacts);
  add_warnings(loaded, contacts);
  for (Warning& warning : loaded.warnings) warning.what += ", even with equal shares";
  return prs::all_warnings({}, {std::move(loaded)});
}

/// Where solving takes no more than the share of one roller, those of `solve` and `life`.
void warn_of_loads(const input::Source& source, const input::CaseInput& in, Result& geometry) {
  const Case& c = in.values;
  const auto force = [](const LoadCase& load) { return std::abs(load.axial_force); };
  const auto largest = std::ranges::max_element(c.load_cases, {}, force);
  const bool is_quick = c.model.mechanism == ModelOptions::Mechanism::sector &&
                        c.model.bodies != ModelOptions::Bodies::influence;
  std::vector<Warning> warnings;
  try {
    if (is_quick && input::unmet(in, Command::solve).empty())
      warnings = solved_load_warnings(source, in, force(*largest));
    else if (largest != c.load_cases.end())
      warnings = equal_share_warnings(*largest, geometry.contacts);
  } catch (const CaseError&) {  // The command that cannot run says why.
  } catch (const input::InputError&) {
  }
  for (Warning& warning : warnings)
    if (std::ranges::find(geometry.warnings, warning) == geometry.warnings.end())
      geometry.warnings.push_back(std::move(warning));
}

/// Reads and checks the study and the optimization of the source too.
CheckResult checked(const input::Source& source, const input::CaseInput& in) {
  if (in.study) input::read_study_input(source);
  if (in.optimize) input::read_optimize_input(source);
  const Case& c = in.values;
  CheckResult result{in.fields, input::assumptions(in.fields, source), {}, {}};
  for (const CommandRow& row : commands())
    result.commands.push_back({row.command, input::unmet(in, row.command)});
  Result& geometry = result.geometry;
  geometry.contacts = find_contacts(c.mechanism, c.materials);
  geometry.warnings = geometry_warnings(c, geometry.contacts, c.load_cases);
  // What odd values bring about is not told again.
  if (in.warnings.empty()) warn_of_loads(source, in, geometry);
  if (std::optional<Warning> note = unknown_film_ratio(c))
    geometry.warnings.push_back(std::move(*note));
  for (Warning& note : void_input_warnings(c)) geometry.warnings.push_back(std::move(note));
  return result;
}

/// The same with the verdict, for which it runs what the case is ready for. `measures` has what
/// `solve` gives.
CheckResult checked_with_verdict(const input::Source& source, const input::CaseInput& in) {
  CheckResult result = checked(source, in);
  std::vector<Attempt> attempts;
  std::vector<std::unique_ptr<const Delivery>> deliveries;
  const bool takes_long = in.values.model.bodies == ModelOptions::Bodies::influence;
  const auto attempt = [&](Command command) {
    if (!input::unmet(in, command).empty()) return false;
    if (takes_long) {
      attempts.push_back({command, nullptr, "`influence` takes long: see `prs report`"});
      return true;
    }
    try {
      deliveries.push_back(std::make_unique<const Delivery>(row_of(command).run(source, in)));
      attempts.push_back({command, deliveries.back().get()});
    } catch (const input::InputError& error) {
      attempts.push_back({command, nullptr, error.what()});
    } catch (const modules::Missing& error) {
      attempts.push_back({command, nullptr, error.what()});
    }
    return attempts.back().delivery != nullptr;
  };
  if (!attempt(Command::measures) || takes_long) attempt(Command::solve);
  for (const Command command : {Command::slip, Command::life}) attempt(command);
  result.verdict = verdict_by(in, attempts);
  return result;
}

template <const Result* VerdictFacts::*loads>
void put_loads(const Result& result, VerdictFacts& facts) {
  facts.*loads = &result;
  facts.contacts = &result.contacts;
}

Result run_contact(const input::Source&, const input::CaseInput& in) {
  return analyze_contacts(in.values);
}

/// Load cases are solved one by one, each on the contacts that it closes.
void warn_of_preload(const Case& c, std::vector<Warning>& warnings) {
  if (c.preload)
    warnings.push_back({"preload", "without_preload", "the load cases are solved without preload",
                        "`prs preload` takes the block `preload`"});
}

void warn_of_heat(const Case& c, std::vector<Warning>& warnings) {
  if (c.heat)
    warnings.push_back({"heat", "without_heat",
                        "the load cases are solved with all parts at the reference temperature",
                        "`prs slip` takes the block `heat`"});
}

Result solved(const input::CaseInput& in, AnalysisOptions options) {
  Result result = analyze(in.values, options);
  warn_of_heat(in.values, result.warnings);
  warn_of_preload(in.values, result.warnings);
  return result;
}

Result run_solve(const input::Source&, const input::CaseInput& in) { return solved(in, {}); }

ModelComparison run_compare(const input::Source&, const input::CaseInput& in) {
  ModelComparison result = compare_models(in.values);
  warn_of_preload(in.values, result.warnings);
  return result;
}

Result run_slip(const input::Source&, const input::CaseInput& in) {
  Result result = analyze_heat(in.values);
  warn_of_preload(in.values, result.warnings);
  if (in.values.friction->of_film())
    if (std::optional<Warning> estimated = estimated_lubricant(*in.values.lubricant))
      result.warnings.push_back(std::move(*estimated));
  return result;
}

PreloadResult run_preload(const input::Source&, const input::CaseInput& in) {
  return analyze_preload(in.values);
}

/// Reads the force history that the case refers to.
LifeResult life_of(const input::Source& source, const input::CaseInput& in) {
  std::optional<LoadHistory> history;
  if (in.values.life->history)
    history = input::read_force_history(*in.values.life->history, source);
  return analyze_life(in.values, std::move(history));
}

LifeResult run_life(const input::Source& source, const input::CaseInput& in) {
  LifeResult result = life_of(source, in);
  warn_of_heat(in.values, result.warnings);
  return result;
}

MeasuresResult run_measures(const input::Source&, const input::CaseInput& in) {
  MeasuresResult result = analyze_measures(in.values);
  result.slips = input::unmet(in, Command::slip).empty();
  result.lives = input::unmet(in, Command::life).empty();
  warn_of_preload(in.values, result.analysis.warnings);
  return result;
}

// The forms of their results.

template <class R>
std::vector<std::string> as_warnings(const R& result) {
  std::vector<std::string> notes = sentences(all_warnings(result));
  for (std::string& note : notes) note.insert(0, "warning: ");
  return notes;
}

template <class R>
std::vector<std::string> summary(const R& result) {
  std::string text = warning_summary(all_warnings(result));
  return text.empty() ? std::vector<std::string>{} : std::vector{std::move(text)};
}

bool all_converged(const Result& result) {
  return std::ranges::all_of(result.load_cases, &LoadCaseResult::converged);
}

/// A terminal shows a load case thread by thread, but not the points of a range.
constexpr std::size_t kMostCharts = 1;

std::string solve_text(const Result& result) {
  std::string text = load_case_table(result);
  if (result.load_cases.size() <= kMostCharts)
    for (const LoadCaseResult& r : result.load_cases)
      text.append("\n").append(load_distribution_chart(r));
  return text;
}

std::string full_solve_text(const Result& result) {
  std::map<std::string, std::vector<std::string>> cases;
  for (const LoadCaseResult& r : result.load_cases)
    if (const auto name = factorization(r)) cases[*name].push_back(printable(r.load_case.name));
  std::string text = solve_text(result) + "\n";
  for (const auto& [name, names] : cases)
    text += fmt::format("factorized by {}{}\n", name,
                        cases.size() > 1 ? " in " + folded_names(names) : "");
  return text;
}

std::vector<OutputFile> solve_files(const Result& result, const CsvStyle& style) {
  return {{"load_cases.csv", load_cases_csv(result, style)},
          {"load_distribution.csv", load_distribution_csv(result, style)}};
}

template <bool all>
std::string slip_text(const Result& result) {
  std::string text = slip_table(result, all);
  if (result.load_cases.size() <= kMostCharts)
    for (const LoadCaseResult& r : result.load_cases)
      if (r.load_case.share == LoadCase::Share::solved) text.append("\n").append(slip_chart(r));
  return text;
}

std::vector<OutputFile> slip_files(const Result& result, const CsvStyle& style) {
  std::vector<OutputFile> files = solve_files(result, style);
  files.push_back({"slip.csv", slip_csv(result, style)});
  files.push_back({"slip_threads.csv", slip_threads_csv(result, style)});
  if (std::ranges::any_of(result.load_cases,
                          [](const LoadCaseResult& r) { return r.heat.has_value(); }))
    files.push_back({"heat.csv", heat_csv(result, style)});
  if (result.heat_cycle && result.heat_cycle->converged())
    files.push_back({"heat_cycle.csv", heat_cycle_csv(*result.heat_cycle, style)});
  return files;
}

bool has_converged_slip(const LoadCaseResult& r) { return r.slip && r.slip->converged(); }

std::vector<std::string> contacts_without_figure(const Result& result) {
  std::vector<std::string> notes;
  for (const Interface i : kInterfaces)
    if (!result.contacts.interfaces[i].geometry.ok())
      notes.push_back(fmt::format(
          "pictures of the contacts were not drawn: the {} threads have no contact point ({})",
          label(i), failure(result.contacts, i).message));
  return notes;
}

std::vector<OutputFile> life_files(const LifeResult& result, const CsvStyle& style) {
  std::vector<OutputFile> files = {{"life_threads.csv", life_threads_csv(result, style)}};
  const bool of_rollers = std::ranges::any_of(kDirections, [&](Direction d) {
    return result.flanks[d] && result.flanks[d]->threads.screw.rollers;
  });
  if (of_rollers) files.push_back({"life_rollers.csv", life_rollers_csv(result, style)});
  if (result.cycles) {
    files.push_back({"cycles.csv", cycles_csv(*result.cycles, style)});
    files.push_back({"cycle_matrix.csv", cycle_matrix_csv(result.cycles->matrix, style)});
  }
  return files;
}

Pictures with_drawings(Pictures pictures, const Case& c, const Result& result) {
  std::ranges::move(drawings(c, result), std::back_inserter(pictures));
  return pictures;
}

Forms<Result> forms_of_solve() {
  return {.file = "result.json",
          .document = to_json,
          .table = solve_text,
          .notes = summary,
          .full_table = full_solve_text,
          .files = solve_files,
          .pictures = [](const Result& r,
                         const Case& c) { return with_drawings(solve_pictures(r), c, r); },
          .converged = all_converged,
          .outline = outline_json,
          .load_case = load_case_json,
          .facts = put_loads<&VerdictFacts::loads>};
}

Forms<CheckResult> forms_of_check() {
  return {
      .file = "check.json",
      .document = check_json,
      .table = check_table,
      .notes = as_warnings,
      .full_table = full_check_table,
      .pictures =
          [](const CheckResult& r, const Case&) {
            Pictures pictures = contact_pictures(r.geometry);
            for (Picture& picture : pictures) picture.drawn = Picture::Drawn::by_name;
            return pictures;
          },
      .facts = [](const CheckResult& r, VerdictFacts& f) { f.contacts = &r.geometry.contacts; }};
}

const std::vector<CommandRow>& table() {
  static const std::vector<CommandRow> rows = {
      row<CheckResult>(Command::check,
                       "Validate a case: what it is ready for, its verdict, what is unusual, "
                       "derived values",
                       checked_with_verdict, forms_of_check()),
      row<Result>(
          Command::contact, "Contact points, backlash, curvatures, ellipses, pictures", run_contact,
          {.file = "contact.json",
           .document = to_json,
           .table = contact_table,
           .notes = summary,
           .pictures = [](const Result& r,
                          const Case& c) { return with_drawings(contact_pictures(r), c, r); },
           .without_figure = contacts_without_figure,
           .outline = outline_json,
           .load_case = load_case_json,
           .facts =
               [](const Result& r, VerdictFacts& f) {
                 f.contacts = &r.contacts;
                 // Equal shares, where nothing is solved.
                 if (!f.loads && !r.load_cases.empty()) f.loads = &r;
               }}),
      row<Result>(Command::solve, "Load distribution, pressures, displacement and stiffness",
                  run_solve, forms_of_solve()),
      row<ModelComparison>(
          Command::compare, "The models of the bodies side by side, or two cases", run_compare,
          {.file = "comparison.json",
           .document = comparison_json,
           .table = comparison_table,
           .notes = summary,
           .files =
               [](const ModelComparison& r, const CsvStyle& style) {
                 return std::vector<OutputFile>{{"comparison.csv", comparison_csv(r, style)}};
               },
           .pictures = [](const ModelComparison& r, const Case&) { return comparison_pictures(r); },
           .converged =
               [](const ModelComparison& r) {
                 return std::ranges::all_of(r.models, all_converged);
               }}),
      row<Result>(
          Command::slip, "Slip, friction, dissipated power, efficiency and torques", run_slip,
          {.file = "slip.json",
           .document = to_json,
           .table = slip_text<false>,
           .notes = summary,
           .full_table = slip_text<true>,
           .files = slip_files,
           .pictures = [](const Result& r, const Case& c) { return slip_pictures(c, r); },
           .converged =
               [](const Result& r) {
                 return all_converged(r) && std::ranges::all_of(r.load_cases, has_converged_slip) &&
                        (!r.heat_cycle || r.heat_cycle->converged());
               },
           .outline = outline_json,
           .load_case = load_case_json,
           .facts = put_loads<&VerdictFacts::slip>}),
      row<PreloadResult>(
          Command::preload, "Preload: curve through zero, lost motion, opening loads", run_preload,
          {.file = "preload.json",
           .document = preload_json,
           .table = preload_table,
           .notes = as_warnings,
           .files =
               [](const PreloadResult& r, const CsvStyle& style) {
                 return std::vector<OutputFile>{{"preload.csv", preload_csv(r, style)}};
               },
           .pictures = [](const PreloadResult& r, const Case&) { return preload_pictures(r); },
           .converged = [](const PreloadResult& r) { return r.converged(); }}),
      row<LifeResult>(
          Command::life, "Life under a load history or spectrum, static safety", run_life,
          {.file = "life.json",
           .document = life_json,
           .table = life_table,
           .notes = as_warnings,
           .full_table = full_life_table,
           .files = life_files,
           .pictures = [](const LifeResult& r, const Case&) { return life_pictures(r); },
           .converged = [](const LifeResult& r) { return r.converged(); },
           .facts = [](const LifeResult& r, VerdictFacts& f) { f.life = &r; }}),
      row<MeasuresResult>(
          Command::measures,
          "Capacity, life, weight, stiffness, inertia and the other design measures", run_measures,
          {.file = "measures.json",
           .document = measures_json,
           .table = measures_table,
           .notes = summary,
           .full_table = full_measures_table,
           .files =
               [](const MeasuresResult& r, const CsvStyle& style) {
                 return std::vector<OutputFile>{{"measures.csv", measures_csv(r, style)},
                                                {"yang.csv", yang_csv(r, style)}};
               },
           .pictures = [](const MeasuresResult& r, const Case&) { return measures_pictures(r); },
           .converged = [](const MeasuresResult& r) { return all_converged(r.analysis); },
           .outline = outline_json,
           .load_case = load_case_json,
           .facts =
               [](const MeasuresResult& r, VerdictFacts& f) {
                 f.measures = &r;
                 put_loads<&VerdictFacts::loads>(r.analysis, f);
               }}),
      {Command::study, "Run the study of the file: many designs, a row each"},
      {Command::optimize, "Search the designs that the file aims at"},
  };
  return rows;
}

}  // namespace

std::span<const CommandRow> commands() { return table(); }

const CommandRow& row_of(Command command) {
  return *std::ranges::find(table(), command, &CommandRow::command);
}

Delivery run_solve(const input::Source& source, const input::CaseInput& in,
                   AnalysisOptions options) {
  const auto run = [&](const input::Source&, const input::CaseInput& of) {
    return solved(of, options);
  };
  return delivered(source, in, run, forms_of_solve());
}

Delivery run_check(const input::Source& source, const input::CaseInput& in) {
  return delivered(source, in, checked, forms_of_check());
}

CaseVerdict verdict_by(const input::CaseInput& in, std::span<const Attempt> attempts) {
  VerdictFacts facts{in.values, in.limits.value_or(Limits{})};
  const Contacts contacts = find_contacts(in.values.mechanism, in.values.materials);
  facts.contacts = &contacts;
  for (const Command command : {Command::solve, Command::slip, Command::life, Command::measures})
    if (const std::vector<std::string> paths = input::missing(in, command); !paths.empty())
      facts.lacking[command] = fmt::format("add {}", fmt::join(paths, ", "));
  for (const Attempt& attempt : attempts)
    if (!attempt.delivery)
      facts.lacking[attempt.command] = attempt.failure;
    else if (attempt.delivery->facts)
      attempt.delivery->facts(facts);
  return verdict_of(facts);
}

Delivery run(const CommandRow& row, const input::Source& source) {
  return row.run(source, input::read_case_input(source, row.command));
}

DocumentInfo document_info(const input::Source& source, Command command) {
  return {kVersion,
          kSchemaVersion,
          sha256(source.text),
          source.overrides,
          std::string(name(command)),
          source.name,
          [source] { return input::resolved_input(source); }};
}

}  // namespace prs
