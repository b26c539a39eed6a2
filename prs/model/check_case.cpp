#include "prs/model/check_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "prs/model/block_checks.h"

namespace prs {

std::vector<Problem> check_case(const Case& c) {
  Problems problems;
  check_threads(c.mechanism, problems);
  check_bodies(c, problems);
  check_meshing(c.mechanism, problems);
  if (c.structure) check_structure(*c.structure, c.mechanism, problems);
  check_load_cases(c, problems);
  check_thickness(c, problems);
  check_deviations(c, problems);
  if (c.preload) check_preload(c, problems);
  if (c.life) check_life(c, problems);
  if (c.lubricant) check_lubricant(*c.lubricant, problems);
  check_carrier(c.carrier, problems);
  return std::move(problems).take();
}

std::vector<Problem> check_requirements(const Case& c, Command command) {
  Problems problems;
  if (command == Command::preload) require_preload(c, problems);
  if (command == Command::life) require_life(c, problems);
  const bool measures = command == Command::measures && !c.load_cases.empty();
  if (command != Command::solve && command != Command::slip && !measures)
    return std::move(problems).take();
  const std::string_view verb = command == Command::solve  ? "solve"
                                : command == Command::slip ? "slip"
                                                           : "measures";

  if (c.load_cases.empty())
    problems.add_missing("load_cases", fmt::format("at least one load case for `{}`", verb),
                         "[{axial_force: 10 kN, direction: tension, position: 10 mm}]");
  if (!c.materials)
    problems.add_missing("materials", fmt::format("elastic properties for `{}`", verb),
                         kMaterialsExample);
  const auto solved = [](const LoadCase& load) { return load.share == LoadCase::Share::solved; };
  if (!c.structure && std::ranges::any_of(c.load_cases, solved))
    problems.add("structure",
                 fmt::format("missing; expected the parts around the threads for `{}`; add "
                             "`structure` with `roller` and `nut`, or `share: equal` to each load "
                             "case",
                             verb));
  if (command == Command::slip) require_slip(c, problems);
  return std::move(problems).take();
}

}  // namespace prs
