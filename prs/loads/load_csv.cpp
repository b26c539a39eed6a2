#include "prs/loads/load_csv.h"

#include <fmt/format.h>

#include <algorithm>

#include "prs/loads/load_record.h"
#include "prs/model/units.h"
#include "prs/record/quantity_csv.h"

namespace prs {
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
