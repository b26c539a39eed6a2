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

std::vector<Problem> missing(const Case& c, Command command) {
  Problems problems;
  const bool loads = command == Command::solve || command == Command::slip ||
                     (command == Command::measures && !c.load_cases.empty());
  if (loads || command == Command::compare) require_load_cases(c, command, problems);
  if (command == Command::compare && !c.load_cases.empty() &&
      std::ranges::none_of(c.load_cases, is_solved))
    problems.add("load_cases",
                 "got equal shares in each; expected one that the models solve; add a load case "
                 "without `share: equal` for `compare`");
  if (command == Command::slip) require_slip(c, problems);
  if (command == Command::slip && c.heat) require_heat(c, problems);
  if (command == Command::preload) require_preload(c, problems);
  if (command == Command::life) require_life(c, problems);
  return std::move(problems).take();
}

}  // namespace prs
