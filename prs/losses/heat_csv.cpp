#include "prs/losses/heat_csv.h"

#include <fmt/format.h>

#include "prs/losses/heat_record.h"
#include "prs/record/quantity_csv.h"

namespace prs {
namespace {

/// `temperature_degC` and `rollers` as a column.
std::string part_column(std::string_view key, std::string_view part) {
  const std::string_view unit = unit_of(key).suffix;
  return fmt::format("{}_{}{}", key.substr(0, key.size() - unit.size()), part, unit);
}

template <class Numbers>
void part_header(CsvWriter& csv, std::string_view key) {
  for (const Quantity<Numbers>& q : record_of<Numbers>().quantities)
    csv.text(part_column(key, q.key));
}

}  // namespace

std::string heat_csv(const Result& result, const CsvStyle& style) {
  CsvWriter csv(style);
  load_header(csv);
  scalar_header<HeatResult>(csv);
  part_header<PartNumbers>(csv, "temperature_degC");
  part_header<InterfaceNumbers>(csv, "oil_degC");
  part_header<PartNumbers>(csv, "heat_W");
  csv.end_row();
  for (const LoadCaseResult& load_case : result.load_cases) {
    if (!load_case.heat) continue;
    load_fields(csv, load_case.load_case);
    scalar_fields<HeatResult>(csv, &*load_case.heat);
    const HeatResult* heat = load_case.heat->converged() ? &*load_case.heat : nullptr;
    const auto put = [&](const std::optional<PartNumbers>& n) {
      scalar_fields<PartNumbers>(csv, n ? &*n : nullptr);
    };
    put(heat ? std::optional(celsius_of(heat->temperature)) : std::nullopt);
    const auto oil = heat && heat->oil ? std::optional(celsius_of(*heat->oil)) : std::nullopt;
    scalar_fields<InterfaceNumbers>(csv, oil ? &*oil : nullptr);
    put(heat ? std::optional(PartNumbers{heat->heat.screw, heat->heat.roller, heat->heat.nut})
             : std::nullopt);
    csv.end_row();
  }
  return csv.take();
}

std::string heat_cycle_csv(const HeatCycle& cycle, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.text("time_s");
  part_header<PartSeries>(csv, "temperature_degC");
  csv.end_row();
  const PartSeries temperature = celsius_of(cycle.temperature);
  for (std::size_t k = 0; k < cycle.time.size(); ++k) {
    csv.number(cycle.time[k]);
    series_fields(csv, temperature, k);
    csv.end_row();
  }
  return csv.take();
}

}  // namespace prs
