#include "prs/loads/load_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "prs/model/units.h"

namespace prs {

double signed_kN(const LoadCaseResult& result) {
  const auto& direction = result.load_case.direction;
  const double sign = direction == Direction::compression ? -1.0 : 1.0;
  return sign * result.load_case.axial_force * per_si::kilonewton;
}

std::vector<const LoadCaseResult*> chosen(const Result& result, const FigureOptions& options) {
  std::vector<const LoadCaseResult*> cases;
  for (const std::size_t k : options.load_cases) {
    if (k >= result.load_cases.size())
      throw NoFigure(fmt::format("no load case {}; there are {}", k, result.load_cases.size()));
    cases.push_back(&result.load_cases[k]);
  }
  if (options.load_cases.empty())
    for (const LoadCaseResult& load_case : result.load_cases) cases.push_back(&load_case);
  return cases;
}

const LoadCaseResult* chosen_case(const Result& result, const FigureOptions& options,
                                  bool (*has)(const LoadCaseResult&)) {
  FigureOptions one = options;
  if (options.load_case) one.load_cases = {*options.load_case};
  const auto loads = [](const LoadCaseResult& r) {
    double thread = 0.0;
    for (const Interface i : kInterfaces)
      if (r.threads)
        for (const double load : (*r.threads)[i].normal_load) thread = std::max(thread, load);
    return std::pair(r.load_case.axial_force, thread);
  };
  const LoadCaseResult* largest = nullptr;
  for (const LoadCaseResult* load_case : chosen(result, one))
    if (has(*load_case) && (!largest || loads(*load_case) > loads(*largest))) largest = load_case;
  return largest;
}

}  // namespace prs
