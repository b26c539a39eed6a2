#include "prs/compare/comparison_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "prs/compare/comparison_record.h"
#include "prs/loads/case_groups.h"
#include "prs/loads/case_table.h"
#include "prs/loads/load_record.h"
#include "prs/loads/warnings.h"
#include "prs/record/quantity_csv.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kLongestName = 19;

std::string comparison_row(std::initializer_list<std::string> cells) {
  constexpr std::size_t kWidths[] = {0, 10, 10, 6, 8, 12, 12, 13, 6};  // Behind the name.
  std::string line = "  ";
  std::size_t column = 0;
  for (const std::string& cell : cells) {
    line += padded(cell, kWidths[column], column <= 1);
    ++column;
  }
  return ended(line);
}

std::string model_row(const std::string& load_case, const ComparedModel& m) {
  const LoadCaseResult& r = m.result();
  const std::string bodies(m.model_name());
  if (!r.converged()) return comparison_row({load_case, bodies, not_converged(r)});
  return comparison_row({load_case, bodies, stiffness_cell(r),
                         fixed(stiffness_over_best(m), 1.0, 3), displacement_cell(r),
                         most_loaded_cell(r, Interface::screw), most_loaded_cell(r, Interface::nut),
                         pressure_cell(r), fixed(pressure_over_best(m), 1.0, 3)});
}

}  // namespace

std::string comparison_table(const ModelComparison& c) {
  const std::size_t shown = std::min(c.load_cases(), kMaxUnfoldedCases);
  std::size_t name_width = std::string_view("load case").size();
  for (std::size_t k = 0; k < shown; ++k)
    name_width = std::max(name_width, width(case_name_cell(c.best().load_cases[k])));
  name_width = std::min(name_width, kLongestName);
  const auto cell = [&](const std::string& text) { return fitted(text, name_width, true) + "  "; };
  std::string text = comparison_row({cell(""), "", "stiffness", "over", "displ.", "screw max.",
                                     "nut max.", "pressure", "over"}) +
                     comparison_row({cell("load case"), "model", with_table_unit("N/µm"), "best",
                                     with_table_unit("µm"), "thread: %", "thread: %",
                                     with_table_unit("max. GPa"), "best"});
  for (std::size_t k = 0; k < shown; ++k)
    for (std::size_t m = 0; m < c.models.size(); ++m)
      text += model_row(cell(m == 0 ? case_name_cell(c.best().load_cases[k]) : ""), {&c, k, m});
  if (shown < c.load_cases())
    text += fmt::format("  … {} of {} load cases; {}\n", shown, c.load_cases(),
                        all_in("comparison.csv"));
  return text + warning_section(all_warnings(c.warnings, c.best().load_cases));
}

std::string comparison_csv(const ModelComparison& c, const CsvStyle& style) {
  CsvWriter csv(style);
  load_header(csv);
  csv.row("bodies", "converged", "axial_stiffness_N_per_um", "stiffness_over_best",
          "axial_displacement_um", "screw_most_loaded_thread", "screw_largest_load_rate_percent",
          "nut_most_loaded_thread", "nut_largest_load_rate_percent", "largest_peak_pressure_MPa",
          "pressure_over_best");
  for (std::size_t k = 0; k < c.load_cases(); ++k)
    for (std::size_t model = 0; model < c.models.size(); ++model) {
      const ComparedModel m{&c, k, model};
      const LoadCaseResult& r = m.result();
      load_fields(csv, r.load_case);
      csv.fields(m.model_name(), r.converged(),
                 scaled(r.axial_stiffness, per_si::newton_per_micrometre), stiffness_over_best(m),
                 scaled(r.axial_displacement, per_si::micrometre));
      for (const Interface i : kInterfaces) {
        const std::vector<double> shares =
            r.threads ? (*r.threads)[i].load_rate : std::vector<double>{};
        csv.integer(r.threads ? most_loaded_thread((*r.threads)[i]) : std::nullopt);
        csv.number(entry(shares, index_of_largest(shares)), per_si::percent);
      }
      csv.row(scaled(largest_pressure(r), per_si::megapascal), pressure_over_best(m));
    }
  return csv.take();
}

}  // namespace prs
