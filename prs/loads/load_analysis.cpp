#include "prs/loads/load_analysis.h"

#include "prs/loads/analyze.h"
#include "prs/loads/load_pictures.h"
#include "prs/loads/load_table.h"
#include "prs/loads/warnings.h"

namespace prs {
namespace {

std::vector<std::string> contacts_without_figure(const Result& result) {
  std::vector<std::string> notes;
  for (const Interface i : kInterfaces)
    if (!result.contacts.interfaces[i].geometry.ok())
      notes.push_back(fmt::format(
          "pictures of the contacts were not drawn: the {} threads have no contact point ({})",
          label(i), failure(result.contacts, i).message));
  return notes;
}

constexpr std::string_view kContactResponses[] = {"contact.screw.normal_angle_deg",
                                                  "contact.nut.normal_angle_deg",
                                                  "contact.screw.hertz_constant_N_per_mm1_5",
                                                  "contact.nut.hertz_constant_N_per_mm1_5",
                                                  "screw.peak_pressure_MPa.max",
                                                  "nut.peak_pressure_MPa.max"};

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

}  // namespace prs
