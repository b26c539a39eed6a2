#include "prs/output/csv.h"

#include <fmt/format.h>

#include "prs/quantities/quantities.h"
#include "prs/output/csv_writer.h"

namespace prs {
namespace {

void solve_fields(CsvWriter& csv, const LoadCaseResult& result) {
  csv.text(result.converged() ? "true" : "false");
  csv.text(status_name(result));
  csv.text(result.solve ? fmt::to_string(result.solve->iterations()) : std::string());
  csv.number(result.solve ? std::optional(result.solve->relative_residual) : std::nullopt);
}

void most_loaded_fields(CsvWriter& csv, const LoadCaseResult& result, Interface i) {
  const InterfaceLoads loads = result.threads ? (*result.threads)[i] : InterfaceLoads{};
  const auto thread = index_of_largest(loads.load_rate);
  csv.integer(thread ? std::optional(*thread + 1) : std::nullopt);
  csv.number(entry(loads.load_rate, thread), per_si::percent);
  csv.number(entry(loads.peak_pressure, index_of_largest(loads.peak_pressure)), per_si::megapascal);
}

}  // namespace

std::string load_cases_csv(const Result& result) {
  CsvWriter csv;
  load_header(csv);
  for (const char* key : {"converged", "status", "iterations", "relative_residual"}) csv.text(key);
  for (const CaseQuantity& quantity : kCaseQuantities) csv.text(quantity.key);
  for (const Interface i : kInterfaces)
    for (const char* key :
         {"most_loaded_thread", "largest_load_rate_percent", "largest_peak_pressure_MPa"})
      csv.text(fmt::format("{}_{}", name(i), key));
  csv.end_row();

  for (const LoadCaseResult& load_case : result.load_cases) {
    load_fields(csv, load_case.load_case);
    solve_fields(csv, load_case);
    for (const auto& [key, value, factor] : kCaseQuantities) csv.number(load_case.*value, factor);
    for (const Interface i : kInterfaces) most_loaded_fields(csv, load_case, i);
    csv.end_row();
  }
  return csv.take();
}

std::string load_distribution_csv(const Result& result) {
  CsvWriter csv;
  load_header(csv);
  csv.text("thread");
  for (const Interface i : kInterfaces)
    for (const ThreadQuantity& quantity : kThreadQuantities)
      csv.text(fmt::format("{}_{}", name(i), quantity.key));
  csv.end_row();

  for (const LoadCaseResult& load_case : result.load_cases) {
    if (!load_case.threads) continue;
    for (std::size_t k = 0; k < load_case.threads->screw.axial_load.size(); ++k) {
      load_fields(csv, load_case.load_case);
      csv.integer(k + 1);
      for (const Interface i : kInterfaces)
        for (const auto& [key, values, factor] : kThreadQuantities)
          csv.number(entry((*load_case.threads)[i].*values, k), factor);
      csv.end_row();
    }
  }
  return csv.take();
}

}  // namespace prs
