#include <fmt/ranges.h>

#include <algorithm>

#include "prs/model/block_checks.h"
#include "prs/model/quantity_text.h"

namespace prs {
namespace {

/// Heat of every part must find a way to the surroundings.
void check_conductance(const Heat::Conductance& c, Problems& problems) {
  if (!(c.to_ambient() > 0.0))
    return problems.add("heat.conductance",
                        "got no conductance to the surroundings; expected `screw_ambient`, "
                        "`nut_ambient` or `rollers_ambient` above 0, or the parts warm without "
                        "end; write `nut_ambient: 8 W/K`, for example");
  const bool screw_to_rollers = c.screw_rollers > 0.0, rollers_to_nut = c.rollers_nut > 0.0;
  bool rollers = c.rollers_ambient > 0.0, screw = c.screw_ambient > 0.0, nut = c.nut_ambient > 0.0;
  rollers = rollers || (screw && screw_to_rollers) || (nut && rollers_to_nut);
  screw = screw || (rollers && screw_to_rollers);
  nut = nut || (rollers && rollers_to_nut);
  const auto refuse = [&](bool holds, std::string_view part, std::string_view keys,
                          std::string_view example) {
    if (!holds)
      problems.add("heat.conductance",
                   "the heat of the {} finds no way to the surroundings; expected one of {} above "
                   "0; state one, `{}: 20 W/K`, for example",
                   part, keys, example);
  };
  refuse(rollers, "rollers", "`screw_rollers`, `rollers_nut`, `rollers_ambient`", "rollers_nut");
  refuse(screw, "screw", "`screw_ambient`, `screw_rollers`", "screw_rollers");
  refuse(nut, "nut", "`nut_ambient`, `rollers_nut`", "rollers_nut");
}

/// `a`, `b` and 3 more.
std::string some_names(const std::vector<LoadCase>& cases) {
  constexpr std::size_t kMost = 5;
  std::vector<std::string> names;
  for (const LoadCase& load : cases) {
    if (names.size() == kMost) break;
    names.push_back(fmt::format("`{}`", load.name));
  }
  std::string text = fmt::to_string(fmt::join(names, ", "));
  if (cases.size() > kMost) text += fmt::format(" and {} more", cases.size() - kMost);
  return text;
}

void check_duty(const Case& c, Problems& problems) {
  for (std::size_t k = 0; k < c.heat->duty.size(); ++k) {
    const std::optional<std::string>& name = c.heat->duty[k].load_case;
    const auto named = [&](const LoadCase& load) { return load.name == *name; };
    if (!name || std::ranges::any_of(c.load_cases, named)) continue;
    const std::string path = fmt::format("heat.duty[{}].load_case", k);
    if (c.load_cases.empty())
      problems.add(path,
                   "got `{}`; expected a case of `load_cases`, which is missing; add it, or write "
                   "`rest: 3 s` for a pause",
                   *name);
    else
      problems.add(path,
                   "got `{}`, which no load case is called; expected one of {}; write one of "
                   "these, or `rest: 3 s` for a pause",
                   *name, some_names(c.load_cases));
  }
}

/// Masses, where the capacities are not given.
void check_capacity(const Case& c, Problems& problems) {
  if (c.heat->capacity) return;
  if (!c.heat->specific_heat)
    return problems.add("heat.specific_heat",
                        "missing; expected it, or `capacity`, with `duty`: how much heat warms the "
                        "parts; add `specific_heat: 460 J/(kg K)`, that of steel");
  if (!c.structure)
    problems.add("heat.capacity",
                 "missing; expected the heat capacities of the parts, whose masses are not known "
                 "without `structure`; add `capacity: {screw: 300 J/K, rollers: 150 J/K, nut: 400 "
                 "J/K}`, for example");
  if (!c.materials) return;
  for (const Part part : kParts)
    if (!(*c.materials)[part].density)
      problems.add("materials",
                   "the {} lacks `density`; expected it with `heat.specific_heat`; add `density: "
                   "7810 kg/m^3`, for example, or `heat.capacity`",
                   name(part));
}

}  // namespace

void check_heat(const Case& c, Problems& problems) {
  check_conductance(c.heat->conductance, problems);
  if (c.deviations.temperature)
    problems.add("deviations.temperature",
                 "got temperatures of the parts together with `heat`, which computes them; "
                 "expected one of the two; delete `deviations.temperature` or `heat`");
  if (c.heat->duty.empty()) return;
  check_duty(c, problems);
  check_capacity(c, problems);
}

void require_heat(const Case& c, Problems& problems) {
  if (std::ranges::any_of(c.load_cases, &LoadCase::is_solved)) require_expansion(c, problems);
}

void require_expansion(const Case& c, Problems& problems) {
  if (!c.materials) return;
  for (const Part part : kParts)
    if (!(*c.materials)[part].thermal_expansion)
      problems.add(
          "materials",
          "the {} lacks `thermal_expansion`; expected it with `heat`, which warms the parts; add "
          "`thermal_expansion: 11.5 um/m/K`, for example, or `share: equal` to each load case",
          name(part));
}

}  // namespace prs
