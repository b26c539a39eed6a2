#include "prs/losses/solve_analysis.h"

#include "prs/indices.h"
#include "prs/loads/case_table.h"
#include "prs/loads/full_result.h"
#include "prs/loads/load_criteria.h"
#include "prs/loads/load_record.h"
#include "prs/loads/mechanism_figures.h"
#include "prs/model/check_case.h"
#include "prs/record/table_layout.h"
#include "prs/slip/running.h"
#include "prs/text.h"

namespace prs {
namespace {

/// Travels and modes at a glance.
std::string motion_lines(const Result& result) {
  std::string text;
  for (const LoadCaseResult& r : result.load_cases) {
    if (!r.full) continue;
    const std::string name = case_name_cell(r);
    if (const auto& t = r.full->travel; t && t->converged())
      text += fmt::format("\n{}: travel deviation e_0a {}, v_ua {}, v_2pia {}", name,
                          fixed_with_unit(t->bands.mean, "µm", 3), fixed_with_unit(t->bands.variation, "µm", 3),
                          fixed_with_unit(t->bands.variation_one_turn, "µm", 3));
    if (const auto& m = r.full->modes; m && !m->modes.empty()) {
      const std::size_t shown = std::min<std::size_t>(m->modes.size(), 6);
      text += fmt::format("\n{}: natural frequencies", name);
      if (shown < m->modes.size()) text += fmt::format(", {} of {}:", shown, m->modes.size());
      for (const auto k : up_to(shown)) text += fmt::format("{} {:.5g}", k ? "," : "", m->modes[k].frequency);
      text += " Hz";
    }
  }
  return text.empty() ? text : text + "\n";
}

std::string solve_text(const Result& result) {
  std::string text = load_case_table(result) + motion_lines(result);
  if (result.load_cases.size() <= kMostCharts)
    for (const LoadCaseResult& r : result.load_cases) text.append("\n").append(load_distribution_chart(r));
  return text;
}

std::string full_solve_text(const Result& result) {
  std::map<std::string, std::vector<std::string>> cases;
  for (const LoadCaseResult& r : result.load_cases)
    if (const auto name = factorization(r)) cases[*name].push_back(printable(r.load_case.name));
  std::string text = solve_text(result) + "\n";
  for (const auto& [name, names] : cases)
    text += fmt::format("factorized by {}{}\n", name, cases.size() > 1 ? " in " + folded_names(names) : "");
  return text;
}

/// Ratios of the load of the most loaded threads to that of the same screw under symmetric load, if above 1.
std::vector<Headline> overloads(const Result& result) {
  constexpr double kNone = 1.0005;  // Ratio up to which four digits show 1.
  std::vector<Headline> headlines;
  for (const Interface i : kInterfaces) {
    Headline worst{fmt::format("Overload of a thread, {}", name(i)), "overload_factor", kNone};
    for (const LoadCaseResult& load : result.load_cases)
      if (const auto* rollers = load.threads ? &(*load.threads)[i].rollers : nullptr;
          rollers && *rollers && (*rollers)->overload_factor > worst.value)
        worst = {std::move(worst.title), worst.key, (*rollers)->overload_factor,
                 fmt::format("{}, {}", load.load_case.name, words_of_text(name(load.loads)))};
    if (!worst.where.empty()) headlines.push_back(std::move(worst));
  }
  return headlines;
}

constexpr std::string_view kSolveResponses[] = {"axial_displacement_um",       "axial_stiffness_N_per_um",
                                                "screw.load_rate_percent.max", "nut.load_rate_percent.max",
                                                "screw.peak_pressure_MPa.max", "nut.peak_pressure_MPa.max"};

}  // namespace

Result solved(const Case& c, const AnalysisOptions& options) {
  Result result = analyze_loads(c, options);
  add_heat_note(c, result.warnings);
  add_preload_note(c, result.warnings);
  return result;
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
                     const Case& c) { return with_drawings(solve_pictures(r, has_butterflies_of_load(c)), c, r); },
      .converged = all_converged,
      .headlines =
          [](const Result& r) {
            std::vector<Headline> all = overloads(r);
            append(all, frequencies(r));
            return all;
          },
      .criteria = load_criteria,
      .all_warnings = all_warnings,
      .responses = kSolveResponses,
      .takes_load_cases_apart = true};
  return analysis;
}

}  // namespace prs
