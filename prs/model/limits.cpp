#include "prs/model/limits.h"

#include <fmt/format.h>

#include <utility>

namespace prs {

std::vector<Problem> check_limits(const Limits& limits, const Conditions& c) {
  Problems problems;
  constexpr double kZeroCelsius = 273.15;
  if (limits.temperature && c.heat && !(*limits.temperature > c.heat->ambient))
    problems.add("limits.temperature",
                 fmt::format("got {:.6g} degC; expected more than the surroundings have, "
                             "heat.ambient: {:.6g} degC; raise the limit",
                             *limits.temperature - kZeroCelsius, c.heat->ambient - kZeroCelsius));
  return std::move(problems).take();
}

}  // namespace prs
