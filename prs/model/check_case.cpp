#include "prs/model/check_case.h"

#include <algorithm>

#include "prs/model/criterion.h"
#include "prs/model/limits.h"
#include "prs/model/load_case_check.h"
#include "prs/model/model_options_check.h"
#include "prs/model/motor_duty.h"
#include "prs/model/operation_check.h"
#include "prs/model/quantity_text.h"
#include "prs/model/structure_check.h"

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
  if (c.lubricant) check_lubricant(*c.lubricant, warms(c.heat) ? c.heat : std::nullopt, problems);
  check_carrier(c.carrier, problems);
  if (c.heat) check_heat(c, problems);
  if (c.measures) check_measures(c, problems);
  if (c.bearings) {
    const Bearings::Fixed& b = c.bearings->fixed;
    if (!b.dynamic_capacity && !b.static_capacity && !b.stiffness)
      problems.add("bearings.fixed",
                   "got none of dynamic_capacity, static_capacity, stiffness; expected at least one; add "
                   "`dynamic_capacity: 50 kN`, for example");
    if (b.dynamic_capacity && !(b.preload < *b.dynamic_capacity))
      problems.add(
          "bearings.fixed.preload",
          "got {}; expected less than `dynamic_capacity`, {}: makers preload with a tenth of it; check the units",
          newton(b.preload), newton(*b.dynamic_capacity));
  }
  if (c.response) check_response(c, problems);
  return std::move(problems).take();
}

namespace {

void require_load_cases(const Case& c, Command command, Problems& problems) {
  if (c.load_cases.empty())
    problems.add_missing("load_cases", fmt::format("at least one load case for `{}`", name(command)),
                         "[{axial_force: 10 kN, direction: tension, position: 10 mm}]");
  if (!c.materials)
    problems.add_missing("materials", fmt::format("elastic properties for `{}`", name(command)), kMaterialsExample);
  if (!c.structure && std::ranges::any_of(c.load_cases, &LoadCase::is_solved))
    problems.add("structure",
                 "missing; expected the parts around the threads for `{}`; add `structure` with "
                 "`roller` and `nut`, or `share: equal` to each load case",
                 name(command));
}

/// Load cases are needed, except by the losses of a preloaded screw, which has losses without a load.
void require_loads(const Case& c, Command command, Problems& problems) {
  for (const LoadCase& load : c.load_cases)
    if (load.axial_force == 0.0)
      problems.add(load.input_path + ".axial_force",
                   "got 0 N in case `{}`; expected a force > 0 for `{}`: without a load only `slip` "
                   "runs, under preload; change it",
                   load.name, name(command));
}

}  // namespace

void need_solve(const Case& c, Problems& problems) {
  require_load_cases(c, Command::solve, problems);
  require_loads(c, Command::solve, problems);
  const auto needs_slip = [](const LoadCase& load) {
    return load.travel && std::isnan(load.travel->stated_slip_ratio) &&
           load.travel->slip_ratio == Travel::SlipRatio::solved;
  };
  if (c.model.loads == ModelOptions::Loads::running || std::ranges::any_of(c.load_cases, needs_slip))
    require_slip(c, problems);
}

bool solve_takes_running_loads(const Case& c) {
  return std::ranges::any_of(c.load_cases,
                             [&](const auto& load) { return solve_takes_running_loads(c.model, load.share); });
}

bool slip_takes_running_loads(const Case& c) {
  return std::ranges::any_of(c.load_cases,
                             [&](const auto& load) { return slip_takes_running_loads(c.model, load.share); });
}

bool life_takes_running_loads(const Case& c) {
  return c.life && life_takes_running_loads(static_cast<const Conditions&>(c));
}

void need_compare(const Case& c, Problems& problems) {
  require_load_cases(c, Command::compare, problems);
  require_loads(c, Command::compare, problems);
  if (!c.load_cases.empty() && std::ranges::none_of(c.load_cases, &LoadCase::is_solved))
    problems.add("load_cases",
                 "got equal thread loads in each; expected one that the models solve; add a load case "
                 "without `share: equal` for `compare`");
}

void need_slip(const Case& c, Problems& problems) {
  require_load_cases(c, Command::slip, problems);
  require_slip(c, problems, true);
  if (warms(c.heat)) require_heat(c, problems);
  if (some_load_has_both_flanks(c)) require_preload(c, problems);
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

std::vector<Problem> check_drive_motor(const DriveMotor& m) {
  Problems problems;
  if (m.rated_torque && m.peak_torque && *m.peak_torque < *m.rated_torque)
    problems.add("motor.peak_torque",
                 "got {:.6g} N m; expected at least `rated_torque`, {:.6g} N m; exchange them, or check the units",
                 *m.peak_torque, *m.rated_torque);
  if (m.supply.voltage && !m.resistance)
    problems.add("motor.resistance", "missing; expected that of the winding beside `supply.voltage`; add {}",
                 "`resistance: 0.8 Ohm`");
  return std::move(problems).take();
}

std::vector<Problem> check_motor(const MotorDuty& duty, const Conditions& c) {
  Problems problems;
  const auto require = [&](const std::string& path, const std::optional<std::string>& name) {
    if (name && std::ranges::find(c.load_cases, *name, &LoadCase::name) == c.load_cases.end())
      problems.add(path, "got `{}`, which no load case is called; expected a name of `load_cases`; rename it", *name);
  };
  for (Problem& wrong : check_drive_motor(duty.motor)) problems.add(std::move(wrong.path), std::move(wrong.message));
  require("motor.driven_back", duty.driven_back);
  for (std::size_t k = 0; k < duty.cycle.size(); ++k)
    require(fmt::format("motor.cycle[{}].load_case", k), duty.cycle[k].load_case);
  return std::move(problems).take();
}

std::string wrong_length(const std::optional<int>& cycles, std::size_t steps) {
  constexpr std::size_t kMost = 100'000;
  if (!cycles || static_cast<std::size_t>(*cycles) * steps <= kMost) return {};
  return fmt::format(
      "got {} cycles; expected at most {} of this cycle, each of whose loads is computed in turn; take fewer cycles, "
      "or describe one by fewer, longer loads",
      *cycles, kMost / steps);
}

std::string wrong_start(const std::optional<PerPart<double>>& start, const Limits& limits) {
  if (!start) return {};
  const CriterionRow& row = *CriterionKey("temperature").row;
  const double hottest = std::max({start->screw, start->roller, start->nut}), physical = *row.physical + row.zero;
  const bool is_stated = limits.temperature && *limits.temperature <= physical;
  const double most = is_stated ? *limits.temperature : physical;
  if (hottest < most) return {};
  return fmt::format("got {}; expected less than {}, {}; start cooler{}", celsius(hottest), celsius(most),
                     is_stated ? "`limits.temperature`" : "where bearing steel turns into austenite",
                     is_stated ? ", or raise the limit" : "");
}

std::vector<Problem> check_limits(const Limits& limits, const Conditions& c) {
  Problems problems;
  constexpr double kZeroCelsius = 273.15;
  if (limits.temperature && c.heat && !(*limits.temperature > c.heat->ambient))
    problems.add("limits.temperature",
                 "got {:.6g} degC; expected more than the surroundings have, heat.ambient: {:.6g} "
                 "degC; raise the limit",
                 *limits.temperature - kZeroCelsius, c.heat->ambient - kZeroCelsius);
  if (const std::string wrong = wrong_start(c.heat ? c.heat->start : std::nullopt, limits); !wrong.empty())
    problems.add("heat.start", "{}", wrong);
  return std::move(problems).take();
}

namespace {

constexpr std::string_view kBoth = "contact.hertz_constant and contact.normal_angle";
constexpr std::string_view kHertz = "contact.hertz_constant";

/// The parts all of whose contacts are at interfaces where `given` holds.
PerPart<bool> parts_between(const PerInterface<bool>& given) {
  return {given.screw, given.screw && given.nut, given.nut};
}

/// Adds `HEAD.TAIL` if the input is void for all parts, else the path of each part for which it is: `pattern` has a
/// place for `.PART`.
void add_parts(std::vector<VoidInput>& inputs, const PerPart<bool>& is_void, std::string_view before,
               std::string_view behind, std::string_view overrides) {
  if (is_void.screw && is_void.roller && is_void.nut) {
    inputs.push_back({fmt::format("{}{}", before, behind), overrides});
    return;
  }
  for (const Part p : kParts)
    if (is_void[p]) inputs.push_back({fmt::format("{}.{}{}", before, name(p), behind), overrides});
}

}  // namespace

std::vector<VoidInput> void_inputs(const Case& c) {
  using Teeth = ModelOptions::ToothCompliance::Kind;
  std::vector<VoidInput> inputs;
  if (!c.structure || c.model.bodies->meshes) return inputs;
  const bool bars = !c.model.bodies->grooves;
  const bool rigid_teeth = c.model.tooth_compliance.kind == Teeth::none;
  PerInterface<bool> hertz, both;
  for (const Interface i : kInterfaces) {
    hertz[i] = c.contact.hertz_constant[i].has_value();
    both[i] = hertz[i] && c.contact.normal_angle[i];
  }
  // In design mode the pitch diameters follow from the threads, which therefore stay effective.
  if (c.mechanism.geometry == Mechanism::Geometry::simulation) {
    if (rigid_teeth) add_parts(inputs, parts_between(both), "mechanism.flank_angle", "", kBoth);
    add_parts(inputs, parts_between(both), "mechanism.profile", "", kBoth);
    if (both.screw && both.nut)
      for (const char* path : {"mechanism.profile_plane", "mechanism.centre_distance"}) inputs.push_back({path, kBoth});
    // `refined` also reads where an inverted screw is threaded, and how a roller's contacts stand.
    if (both.screw && both.nut && bars)
      for (const char* path : {"mechanism.type", "mechanism.starts.roller"}) inputs.push_back({path, kBoth});
  }
  if (bars && rigid_teeth && !c.model.roller_shear)
    add_parts(inputs, parts_between(hertz), "materials", ".poisson_ratio", kHertz);
  return inputs;
}

const VoidInput* find_void(const std::vector<VoidInput>& inputs, std::string_view path) {
  for (const VoidInput& input : inputs)
    if (path.starts_with(input.path) && (path.size() == input.path.size() || path[input.path.size()] == '.'))
      return &input;
  return nullptr;
}

std::vector<Warning> void_input_warnings(const Case& c) {
  std::vector<Warning> warnings;
  const std::vector<VoidInput> inputs = void_inputs(c);
  for (const std::string_view overrides : {kBoth, kHertz}) {
    std::string paths;
    for (const VoidInput& input : inputs)
      if (input.overrides == overrides) paths += (paths.empty() ? "" : ", ") + input.path;
    if (!paths.empty())
      warnings.push_back({"", overrides == kBoth ? "void_geometry" : "void_poisson_ratios",
                          fmt::format("overridden by {}: no load or stiffness follows {}, only ellipses, "
                                      "pressures, capacities and slip do",
                                      overrides, paths),
                          std::string(kDeleteOverrides)});
  }
  return warnings;
}

void add_preload_note(const Case& c, std::vector<Warning>& warnings) {
  if (c.preload)
    warnings.push_back({"preload", "without_preload", "the load cases are solved without preload",
                        "`prs preload` takes the block `preload`"});
}

void add_heat_note(const Case& c, std::vector<Warning>& warnings) {
  if (warms(c.heat))
    warnings.push_back({"heat", "without_heat", "the load cases are solved with all parts at the reference temperature",
                        "`prs slip` takes the block `heat`"});
}

}  // namespace prs
