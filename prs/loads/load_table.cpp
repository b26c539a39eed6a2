#include "prs/loads/load_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "prs/loads/case_table.h"
#include "prs/loads/load_record.h"
#include "prs/loads/model_summary_record.h"
#include "prs/loads/warnings.h"
#include "prs/model/units.h"
#include "prs/record/bar_chart.h"
#include "prs/record/quantity_csv.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {
namespace {

template <Interface interface>
std::string most_loaded(const LoadCaseResult& result) {
  return most_loaded_cell(result, interface);
}

constexpr CaseColumn kColumns[] = {
    {"", "load case", true, case_name_cell},
    {"force", "kN", false, force_cell},
    {"", "direction", true, direction_cell},
    {"stiffness", "N/µm", false, stiffness_cell},
    {"displ.", "µm", false, displacement_cell},
    {"screw max.", "thread: %", false, most_loaded<Interface::screw>},
    {"nut max.", "thread: %", false, most_loaded<Interface::nut>},
    {"pressure", "max. GPa", true, pressure_cell},
};

std::vector<double> percent(const std::vector<double>& rates) {
  std::vector<double> shown;
  for (const double rate : rates) shown.push_back(rate * per_si::percent);
  return shown;
}

}  // namespace

std::string load_case_table(const Result& result) {
  std::string model = model_line(result);
  if (!model.empty()) model = wrapped(model.substr(0, model.size() - 1), "", kTableWidth);
  const std::string table =
      model + case_table({kColumns, 3, not_converged, "load_cases.csv"}, result.load_cases);
  return table + warning_section(all_warnings(result));
}

std::string load_distribution_chart(const LoadCaseResult& result) {
  const std::string title = case_name_cell(result);
  if (!result.threads)
    return fmt::format("{}: no load distribution ({})\n", title, status_name(result));

  const bool rollers = result.full != nullptr;
  PerInterface<std::vector<double>> shares;
  for (const Interface i : kInterfaces) {
    const InterfaceLoads& loads = (*result.threads)[i];
    shares[i] = percent(rollers ? loads.rollers->share : loads.load_rate);
  }
  const double mean = per_si::percent / static_cast<double>(shares.screw.size());
  return fmt::format("{}: share of each {}, mean {:.2f} %\n", title, rollers ? "roller" : "thread",
                     mean) +
         bar_chart(shares, 2, "%");
}

namespace {

void most_loaded_fields(CsvWriter& csv, const LoadCaseResult& result, Interface i) {
  const InterfaceLoads loads = result.threads ? (*result.threads)[i] : InterfaceLoads{};
  const auto thread = index_of_largest(loads.load_rate);
  const auto row = static_cast<std::size_t>(std::max(loads.threads_per_roller, 0));
  csv.fields(thread ? std::optional((row ? *thread % row : *thread) + 1) : std::nullopt,
             scaled(entry(loads.load_rate, thread), per_si::percent),
             scaled(entry(loads.peak_pressure, index_of_largest(loads.peak_pressure)),
                    per_si::megapascal));
}

}  // namespace

std::string load_cases_csv(const Result& result, const CsvStyle& style) {
  CsvWriter csv(style);
  load_header(csv);
  scalar_header<LoadCaseResult>(csv, "", "converged");
  for (const Interface i : kInterfaces)
    for (const char* key :
         {"most_loaded_thread", "largest_load_rate_percent", "largest_peak_pressure_MPa"})
      csv.text(fmt::format("{}_{}", name(i), key));
  csv.end_row();

  for (const LoadCaseResult& load_case : result.load_cases) {
    load_fields(csv, load_case.load_case);
    scalar_fields<LoadCaseResult>(csv, &load_case, "converged");
    for (const Interface i : kInterfaces) most_loaded_fields(csv, load_case, i);
    csv.end_row();
  }
  return csv.take();
}

std::string load_distribution_csv(const Result& result, const CsvStyle& style) {
  CsvWriter csv(style);
  load_header(csv);
  const bool all_rollers = std::ranges::any_of(
      result.load_cases, [](const LoadCaseResult& r) { return r.full != nullptr; });
  if (all_rollers) csv.text("roller");
  csv.text("thread");
  for (const Interface i : kInterfaces)
    series_header<InterfaceLoads>(csv, fmt::format("{}_", name(i)));
  csv.end_row();

  for (const LoadCaseResult& load_case : result.load_cases) {
    if (!load_case.threads) continue;
    for (std::size_t k = 0; k < load_case.threads->screw.axial_load.size(); ++k) {
      load_fields(csv, load_case.load_case);
      const auto row = static_cast<std::size_t>(load_case.threads->screw.threads_per_roller);
      if (all_rollers) csv.integer(row ? std::optional(k / row + 1) : std::nullopt);
      csv.integer(row ? k % row + 1 : k + 1);
      for (const Interface i : kInterfaces) series_fields(csv, (*load_case.threads)[i], k);
      csv.end_row();
    }
  }
  return csv.take();
}

}  // namespace prs
