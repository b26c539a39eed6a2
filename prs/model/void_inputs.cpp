#include "prs/model/void_inputs.h"

#include <fmt/format.h>

namespace prs {
namespace {

constexpr std::string_view kBoth = "contact.hertz_constant and contact.normal_angle";
constexpr std::string_view kHertz = "contact.hertz_constant";

/// The parts whose contacts are all at interfaces where `given` holds.
PerPart<bool> parts_between(const PerInterface<bool>& given) {
  return {given.screw, given.screw && given.nut, given.nut};
}

/// `HEAD.TAIL` where it is void of all parts, else that of each part: `pattern` has a place for
/// `.PART`.
void add_parts(std::vector<VoidInput>& inputs, const PerPart<bool>& is_void,
               std::string_view before, std::string_view behind, std::string_view overrides) {
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
  if (!c.structure || c.model.bodies == ModelOptions::Bodies::influence) return inputs;
  const bool bars = c.model.bodies == ModelOptions::Bodies::bars;
  const bool rigid_teeth = c.model.tooth_compliance.kind == Teeth::none;
  PerInterface<bool> hertz, both;
  for (const Interface i : kInterfaces) {
    hertz[i] = c.contact.hertz_constant[i].has_value();
    both[i] = hertz[i] && c.contact.normal_angle[i];
  }
  // In design mode the threads give the pitch diameters too.
  if (c.mechanism.geometry == Mechanism::Geometry::simulation) {
    if (rigid_teeth) add_parts(inputs, parts_between(both), "mechanism.flank_angle", "", kBoth);
    add_parts(inputs, parts_between(both), "mechanism.profile", "", kBoth);
    if (both.screw && both.nut)
      for (const char* path : {"mechanism.profile_plane", "mechanism.centre_distance"})
        inputs.push_back({path, kBoth});
    // `refined` knows where an inverted screw is threaded, and how a roller's contacts stand.
    if (both.screw && both.nut && bars)
      for (const char* path : {"mechanism.type", "mechanism.starts.roller"})
        inputs.push_back({path, kBoth});
  }
  if (bars && rigid_teeth && !c.model.roller_shear)
    add_parts(inputs, parts_between(hertz), "materials", ".poisson_ratio", kHertz);
  return inputs;
}

const VoidInput* find_void(const std::vector<VoidInput>& inputs, std::string_view path) {
  for (const VoidInput& input : inputs)
    if (path.starts_with(input.path) &&
        (path.size() == input.path.size() || path[input.path.size()] == '.'))
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
      warnings.push_back(
          {"", overrides == kBoth ? "void_geometry" : "void_poisson_ratios",
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
  if (c.heat)
    warnings.push_back({"heat", "without_heat",
                        "the load cases are solved with all parts at the reference temperature",
                        "`prs slip` takes the block `heat`"});
}

}  // namespace prs
