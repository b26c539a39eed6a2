#include "prs/losses/slip_csv.h"

#include <fmt/format.h>

#include <algorithm>

#include "prs/losses/slip_record.h"
#include "prs/record/quantity_csv.h"

namespace prs {
namespace {

/// Those of the search for the slip ratio also where there is no answer.
void slip_fields(CsvWriter& csv, const LoadCaseResult& result) {
  const SlipResult* slip = result.slip ? &*result.slip : nullptr;
  if (slip) {
    scalar_fields<SlipResult>(csv, slip);
  } else {
    csv.fields(false, slip_status_name(result));
    scalar_fields<SlipResult>(csv, slip, "evaluations");
  }
  if (slip && !slip->converged()) slip = nullptr;
  scalar_fields<SlipEstimates>(csv, slip ? &slip->estimates : nullptr);
  for (const PowerSource& source : kPowerSources)
    csv.number(slip ? std::optional(slip->power.*source.value) : std::nullopt);
  const std::optional<HottestThread> hottest = slip ? hottest_thread(*slip) : std::nullopt;
  scalar_fields<HottestThread>(csv, hottest ? &*hottest : nullptr);
  scalar_fields<EqualShareSlip>(csv, slip && slip->equal_shares ? &*slip->equal_shares : nullptr);
}

}  // namespace

std::string slip_csv(const Result& result, const CsvStyle& style) {
  CsvWriter csv(style);
  load_header(csv);
  scalar_header<SlipResult>(csv);
  scalar_header<SlipEstimates>(csv, "slip_ratio_");
  for (const PowerSource& source : kPowerSources) csv.text(fmt::format("{}_power_W", source.key));
  csv.fields("hottest_interface", "hottest_thread", "hottest_thread_power_W",
             "hottest_thread_power_density_W_per_mm2", "hottest_roller");
  scalar_header<EqualShareSlip>(csv, "equal_shares_");
  csv.end_row();

  for (const LoadCaseResult& load_case : result.load_cases) {
    load_fields(csv, load_case.load_case);
    slip_fields(csv, load_case);
    csv.end_row();
  }
  return csv.take();
}

std::string slip_threads_csv(const Result& result, const CsvStyle& style) {
  CsvWriter csv(style);
  load_header(csv);
  const bool all_rollers = std::ranges::any_of(
      result.load_cases, [](const LoadCaseResult& r) { return r.full != nullptr; });
  if (all_rollers) csv.text("roller");
  csv.fields("interface", "thread", "axial_load_N");
  series_header<InterfaceSlip>(csv);
  csv.end_row();

  for (const LoadCaseResult& load_case : result.load_cases) {
    if (!has_slip(load_case) || !load_case.threads) continue;
    for (const Interface i : kInterfaces) {
      const InterfaceSlip& slip = load_case.slip->threads[i];
      for (std::size_t k = 0; k < slip.power.size(); ++k) {
        const auto row = static_cast<std::size_t>(slip.threads_per_roller);
        load_fields(csv, load_case.load_case);
        if (all_rollers) csv.integer(row ? std::optional(k / row + 1) : std::nullopt);
        csv.fields(name(i), row ? k % row + 1 : k + 1,
                   entry((*load_case.threads)[i].axial_load, k));
        series_fields(csv, slip, k);
        csv.end_row();
      }
    }
  }
  return csv.take();
}

}  // namespace prs
