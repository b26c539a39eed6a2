#include "prs/model/check_case.h"

#include <algorithm>

#include "prs/model/block_checks.h"
#include "prs/model/limits.h"

namespace prs {

std::vector<Problem> check_case(const Case& c) {
  Problems problems;
  check_threads(c.mechanism, problems);
  check_bodies(c, problems);
  check_meshing(c.mechanism, problems);
  if (c.structure) check_structure(*c.structure, c.mechanism, problems);
  check_load_cases(c, problems);
  check_loads(c, problems);
  check_thickness(c, problems);
  check_deviations(c, problems);
  check_full_mechanism(c, problems);
  if (c.preload) check_preload(c, problems);
  if (c.life) check_life(c, problems);
  if (c.lubricant) check_lubricant(*c.lubricant, c.heat, problems);
  check_carrier(c.carrier, problems);
  if (c.heat) check_heat(c, problems);
  if (c.measures) check_measures(*c.measures, problems);
  return std::move(problems).take();
}

namespace {

void require_load_cases(const Case& c, Command command, Problems& problems) {
  if (c.load_cases.empty())
    problems.add_missing("load_cases",
                         fmt::format("at least one load case for `{}`", name(command)),
                         "[{axial_force: 10 kN, direction: tension, position: 10 mm}]");
  if (!c.materials)
    problems.add_missing("materials", fmt::format("elastic properties for `{}`", name(command)),
                         kMaterialsExample);
  if (!c.structure && std::ranges::any_of(c.load_cases, &LoadCase::is_solved))
    problems.add("structure",
                 "missing; expected the parts around the threads for `{}`; add `structure` with "
                 "`roller` and `nut`, or `share: equal` to each load case",
                 name(command));
}

/// Only the losses of a preloaded screw are those of something without a load.
void require_loads(const Case& c, Command command, Problems& problems) {
  for (const LoadCase& load : c.load_cases)
    if (load.axial_force == 0.0)
      problems.add(
          load.input_path + ".axial_force",
          "got 0 N in case `{}`; expected a force > 0 for `{}`: without a load only `slip` "
          "runs, under preload; change it",
          load.name, name(command));
}

}  // namespace

void need_solve(const Case& c, Problems& problems) {
  require_load_cases(c, Command::solve, problems);
  require_loads(c, Command::solve, problems);
  if (c.model.loads == ModelOptions::Loads::running) require_slip(c, problems);
}

void need_compare(const Case& c, Problems& problems) {
  require_load_cases(c, Command::compare, problems);
  require_loads(c, Command::compare, problems);
  if (!c.load_cases.empty() && std::ranges::none_of(c.load_cases, &LoadCase::is_solved))
    problems.add("load_cases",
                 "got equal shares in each; expected one that the models solve; add a load case "
                 "without `share: equal` for `compare`");
}

void need_slip(const Case& c, Problems& problems) {
  require_load_cases(c, Command::slip, problems);
  require_slip(c, problems);
  if (c.heat) require_heat(c, problems);
  if (std::ranges::any_of(c.load_cases,
                          [&](const LoadCase& load) { return has_both_flanks(c, load.share); }))
    require_preload(c, problems);
}

void need_measures(const Case& c, Problems& problems) {
  if (c.load_cases.empty()) return;
  require_load_cases(c, Command::measures, problems);
  require_loads(c, Command::measures, problems);
}

std::vector<Problem> missing(const Case& c, Command command) {
  Problems problems;
  if (command.needs) command.needs(c, problems);
  return std::move(problems).take();
}

std::vector<Problem> check_limits(const Limits& limits, const Conditions& c) {
  Problems problems;
  constexpr double kZeroCelsius = 273.15;
  if (limits.temperature && c.heat && !(*limits.temperature > c.heat->ambient))
    problems.add("limits.temperature",
                 "got {:.6g} degC; expected more than the surroundings have, heat.ambient: {:.6g} "
                 "degC; raise the limit",
                 *limits.temperature - kZeroCelsius, c.heat->ambient - kZeroCelsius);
  return std::move(problems).take();
}

}  // namespace prs
