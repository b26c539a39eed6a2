#include "prs/output/table.h"

#include <fmt/format.h>

#include "prs/output/bar_chart.h"
#include "prs/output/case_table.h"
#include "prs/output/table_units.h"
#include "prs/output/warnings.h"
#include "prs/quantities/model_summary.h"
#include "prs/quantities/quantities.h"

namespace prs {
namespace {

std::string stiffness(const LoadCaseResult& result) {
  return fixed(result.axial_stiffness, "N/µm", 1);
}

std::string displacement(const LoadCaseResult& result) {
  return fixed(result.axial_displacement, "µm", 2);
}

template <Interface interface>
std::string most_loaded_thread(const LoadCaseResult& result) {
  if (!result.threads) return std::string(kAbsent);
  const std::vector<double>& rates = (*result.threads)[interface].load_rate;
  const auto thread = index_of_largest(rates);
  if (!thread) return std::string(kAbsent);
  return fmt::format("{}: {:5.2f}", *thread + 1, rates[*thread] * per_si::percent);
}

std::string peak_pressure(const LoadCaseResult& result) {
  double peak = 0.0;
  std::string cell(kAbsent);
  if (!result.threads) return cell;
  for (const Interface i : kInterfaces)
    for (const double pressure : (*result.threads)[i].peak_pressure)
      if (pressure > peak) {
        peak = pressure;
        cell = fmt::format("{} {:5}", fixed(pressure, "GPa", 3), name(i));
      }
  return cell;
}

std::string iterations(const LoadCaseResult& result) {
  return result.solve ? fmt::to_string(result.solve->iterations()) : std::string(kAbsent);
}

constexpr CaseColumn kColumns[] = {
    {"", "load case", true, case_name_cell},
    {"force", "kN", false, force_cell},
    {"", "direction", true, direction_cell},
    {"stiffness", "N/µm", false, stiffness},
    {"displ.", "µm", false, displacement},
    {"screw max.", "thread: %", false, most_loaded_thread<Interface::screw>},
    {"nut max.", "thread: %", false, most_loaded_thread<Interface::nut>},
    {"pressure", "max. GPa", true, peak_pressure},
    {"Newton", "steps", false, iterations},
};

std::string failure(const LoadCaseResult& result) {
  if (result.converged()) return {};
  return fmt::format("NOT CONVERGED ({}), residual {:.1e}", status_name(result),
                     result.solve->relative_residual);
}

std::vector<double> percent(const std::vector<double>& rates) {
  std::vector<double> shown;
  for (const double rate : rates) shown.push_back(rate * per_si::percent);
  return shown;
}

}  // namespace

std::string load_case_table(const Result& result) {
  const std::string table =
      model_line(result) + case_table({kColumns, 3, failure, "load_cases.csv"}, result.load_cases);
  const std::string warnings = warning_summary(result);
  return warnings.empty() ? table : table + '\n' + warnings;
}

std::string load_distribution_chart(const LoadCaseResult& result) {
  const std::string title = case_name_cell(result);
  if (!result.threads)
    return fmt::format("{}: no load distribution ({})\n", title, status_name(result));

  const PerInterface<std::vector<double>> rates = {percent(result.threads->screw.load_rate),
                                                   percent(result.threads->nut.load_rate)};
  const double mean = per_si::percent / static_cast<double>(rates.screw.size());
  return fmt::format("{}: share of each thread, mean {:.2f} %\n", title, mean) +
         bar_chart(rates, 2, "%");
}

}  // namespace prs
