#include "prs/output/slip_csv.h"

#include <fmt/format.h>

#include "prs/quantities/slip_quantities.h"
#include "prs/output/csv_writer.h"

namespace prs {
namespace {

void search_fields(CsvWriter& csv, const LoadCaseResult& result) {
  csv.text(has_slip(result) ? "true" : "false");
  csv.text(slip_status_name(result));
  csv.text(result.slip ? fmt::to_string(result.slip->evaluations) : std::string());
  csv.number(result.slip ? result.slip->relative_residue : std::nullopt);
}

void quantity_header(CsvWriter& csv) {
  for (const SlipQuantity& quantity : kSlipQuantities) csv.text(quantity.key);
  for (const SlipQuantity& quantity : kSlipEstimates)
    csv.text(fmt::format("slip_ratio_{}", quantity.key));
  for (const PowerSource& source : kPowerSources) csv.text(fmt::format("{}_power_W", source.key));
  for (const char* key : {"hottest_interface", "hottest_thread", "hottest_thread_power_W",
                          "hottest_thread_power_density_W_per_mm2"})
    csv.text(key);
  for (const EqualShareQuantity& quantity : kEqualShareQuantities)
    csv.text(fmt::format("equal_shares_{}", quantity.key));
}

void hottest_fields(CsvWriter& csv, const SlipResult& slip) {
  const auto density = at_hottest(slip, &InterfaceSlip::power_density);
  csv.text(density ? name(slip.hottest.interface) : "");
  csv.text(density ? fmt::to_string(slip.hottest.thread + 1) : std::string());
  csv.number(at_hottest(slip, &InterfaceSlip::power));
  csv.number(density, per_si::per_square_millimetre);
}

/// Empty for a case without an answer.
void quantity_fields(CsvWriter& csv, const SlipResult* slip) {
  const auto number = [&](const auto& value, double factor) {
    csv.number(slip ? value(*slip) : std::nullopt, factor);
  };
  for (const auto& [key, value, factor] : kSlipQuantities) number(value, factor);
  for (const auto& [key, value, factor] : kSlipEstimates) number(value, factor);
  for (const PowerSource& source : kPowerSources)
    csv.number(slip ? std::optional(slip->power.*source.value) : std::nullopt);
  hottest_fields(csv, slip ? *slip : SlipResult{});
  for (const auto& [key, value, factor] : kEqualShareQuantities)
    csv.number(slip && slip->equal_shares ? value(*slip->equal_shares) : std::nullopt, factor);
}

}  // namespace

std::string slip_csv(const Result& result) {
  CsvWriter csv;
  load_header(csv);
  for (const char* key : {"converged", "status", "evaluations", "relative_residue"}) csv.text(key);
  quantity_header(csv);
  csv.end_row();

  for (const LoadCaseResult& load_case : result.load_cases) {
    load_fields(csv, load_case.load_case);
    search_fields(csv, load_case);
    quantity_fields(csv, has_slip(load_case) ? &*load_case.slip : nullptr);
    csv.end_row();
  }
  return csv.take();
}

std::string slip_threads_csv(const Result& result) {
  CsvWriter csv;
  load_header(csv);
  for (const char* key : {"interface", "thread", "axial_load_N"}) csv.text(key);
  for (const SlipThreadQuantity& quantity : kSlipThreadQuantities) csv.text(quantity.key);
  csv.end_row();

  for (const LoadCaseResult& load_case : result.load_cases) {
    if (!has_slip(load_case) || !load_case.threads) continue;
    for (const Interface i : kInterfaces) {
      const InterfaceSlip& slip = load_case.slip->threads[i];
      for (std::size_t k = 0; k < slip.power.size(); ++k) {
        load_fields(csv, load_case.load_case);
        csv.text(name(i));
        csv.integer(k + 1);
        csv.number(entry((*load_case.threads)[i].axial_load, k));
        for (const auto& [key, values, factor] : kSlipThreadQuantities)
          csv.number(entry(slip.*values, k), factor);
        csv.end_row();
      }
    }
  }
  return csv.take();
}

}  // namespace prs
