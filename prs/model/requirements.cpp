#include "prs/model/requirements.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "prs/model/block_checks.h"

namespace prs {
namespace {

bool is_solved(const LoadCase& load) { return load.share == LoadCase::Share::solved; }

void require_load_cases(const Case& c, Command command, Problems& problems) {
  if (c.load_cases.empty())
    problems.add_missing("load_cases",
                         fmt::format("at least one load case for `{}`", name(command)),
                         "[{axial_force: 10 kN, direction: tension, position: 10 mm}]");
  if (!c.materials)
    problems.add_missing("materials", fmt::format("elastic properties for `{}`", name(command)),
                         kMaterialsExample);
  if (!c.structure && std::ranges::any_of(c.load_cases, is_solved))
    problems.add("structure",
                 fmt::format("missing; expected the parts around the threads for `{}`; add "
                             "`structure` with `roller` and `nut`, or `share: equal` to each load "
                             "case",
                             name(command)));
}

}  // namespace

void need_solve(const Case& c, Problems& problems) {
  require_load_cases(c, Command::solve, problems);
  if (c.model.loads == ModelOptions::Loads::running) require_slip(c, problems);
}

void need_compare(const Case& c, Problems& problems) {
  require_load_cases(c, Command::compare, problems);
  if (!c.load_cases.empty() && std::ranges::none_of(c.load_cases, is_solved))
    problems.add("load_cases",
                 "got equal shares in each; expected one that the models solve; add a load case "
                 "without `share: equal` for `compare`");
}

void need_slip(const Case& c, Problems& problems) {
  require_load_cases(c, Command::slip, problems);
  require_slip(c, problems);
  if (c.heat) require_heat(c, problems);
}

void need_preload(const Case& c, Problems& problems) { require_preload(c, problems); }
void need_life(const Case& c, Problems& problems) { require_life(c, problems); }

void need_measures(const Case& c, Problems& problems) {
  if (!c.load_cases.empty()) require_load_cases(c, Command::measures, problems);
}

std::vector<Problem> missing(const Case& c, Command command) {
  Problems problems;
  if (command.needs) command.needs(c, problems);
  return std::move(problems).take();
}

}  // namespace prs
