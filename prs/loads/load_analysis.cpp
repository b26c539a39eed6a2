#include "prs/loads/load_analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "prs/loads/analyze.h"
#include "prs/loads/case_groups.h"
#include "prs/loads/factorization.h"
#include "prs/loads/load_pictures.h"
#include "prs/loads/load_record.h"
#include "prs/loads/load_table.h"
#include "prs/loads/warnings.h"
#include "prs/model/void_inputs.h"
#include "prs/text.h"

namespace prs {
namespace {

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

std::vector<std::string> contacts_without_figure(const Result& result) {
  std::vector<std::string> notes;
  for (const Interface i : kInterfaces)
    if (!result.contacts.interfaces[i].geometry.ok())
      notes.push_back(fmt::format(
          "pictures of the contacts were not drawn: the {} threads have no contact point ({})",
          label(i), failure(result.contacts, i).message));
  return notes;
}

/// Where threads carry more than those of the same screw loaded symmetrically, how much.
std::vector<Headline> overloads(const Result& result) {
  constexpr double kNone = 1.0005;  // What four digits do not show as 1.
  std::vector<Headline> headlines;
  for (const Interface i : kInterfaces) {
    Headline worst{fmt::format("Overload of a thread, {}", name(i)), "overload_factor", kNone};
    for (const LoadCaseResult& load : result.load_cases)
      if (const auto* rollers = load.threads ? &(*load.threads)[i].rollers : nullptr;
          rollers && *rollers && (*rollers)->overload_factor > worst.value)
        worst = {std::move(worst.title), worst.key, (*rollers)->overload_factor,
                 load.load_case.name};
    if (!worst.where.empty()) headlines.push_back(std::move(worst));
  }
  return headlines;
}

constexpr std::string_view kContactResponses[] = {"contact.screw.normal_angle_deg",
                                                  "contact.nut.normal_angle_deg",
                                                  "contact.screw.hertz_constant_N_per_mm1_5",
                                                  "contact.nut.hertz_constant_N_per_mm1_5",
                                                  "screw.peak_pressure_MPa.max",
                                                  "nut.peak_pressure_MPa.max"};
constexpr std::string_view kSolveResponses[] = {
    "axial_displacement_um",     "axial_stiffness_N_per_um",    "screw.load_rate_percent.max",
    "nut.load_rate_percent.max", "screw.peak_pressure_MPa.max", "nut.peak_pressure_MPa.max"};

}  // namespace

std::vector<OutputFile> load_files(const Result& result, const CsvStyle& style) {
  return {{"load_cases.csv", load_cases_csv(result, style)},
          {"load_distribution.csv", load_distribution_csv(result, style)}};
}

bool all_converged(const Result& result) {
  return std::ranges::all_of(result.load_cases, &LoadCaseResult::converged);
}

std::vector<std::string> summary_of_warnings(const Result& result) {
  std::string text = warning_summary(all_warnings(result));
  return text.empty() ? std::vector<std::string>{} : std::vector{std::move(text)};
}

Result solved(const Case& c, const AnalysisOptions& options) {
  Result result = analyze(c, options);
  add_heat_note(c, result.warnings);
  add_preload_note(c, result.warnings);
  return result;
}

const Analysis<Result>& contact_analysis() {
  static const std::vector<Place> places = with_loads();
  static const Analysis<Result> analysis{
      .command = Command::contact,
      .help = "Contact points, backlash, curvatures, ellipses, pictures",
      .file = "contact.json",
      .run = [](const input::Source&,
                const input::CaseInput& in) { return analyze_contacts(in.values); },
      .places = places,
      .put = put_loads,
      .load_case = load_case_json,
      .table = contact_table,
      .notes = summary_of_warnings,
      .pictures = [](const Result& r,
                     const Case& c) { return with_drawings(contact_pictures(r), c, r); },
      .without_figure = contacts_without_figure,
      .all_warnings = all_warnings,
      .responses = kContactResponses,
      .takes_load_cases_apart = true};
  return analysis;
}

const Analysis<Result>& solve_analysis() {
  static const std::vector<Place> places = with_loads();
  static const Analysis<Result> analysis{
      .command = Command::solve,
      .help = "Load distribution, pressures, displacement and stiffness",
      .file = "result.json",
      .run = [](const input::Source&, const input::CaseInput& in) { return solved(in.values); },
      .places = places,
      .put = put_loads,
      .load_case = load_case_json,
      .table = solve_text,
      .full_table = full_solve_text,
      .notes = summary_of_warnings,
      .files = load_files,
      .pictures = [](const Result& r,
                     const Case& c) { return with_drawings(solve_pictures(r), c, r); },
      .converged = all_converged,
      .headlines = overloads,
      .all_warnings = all_warnings,
      .responses = kSolveResponses,
      .takes_load_cases_apart = true};
  return analysis;
}

}  // namespace prs
