#include "prs/loads/load_table.h"

#include <fmt/format.h>

#include "prs/loads/case_table.h"
#include "prs/loads/load_record.h"
#include "prs/loads/model_summary_record.h"
#include "prs/loads/warnings.h"
#include "prs/record/bar_chart.h"
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

}  // namespace prs
