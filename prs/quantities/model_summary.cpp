#include "prs/quantities/model_summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "prs/model/units.h"

namespace prs {
namespace {

using Bodies = ModelOptions::Bodies;

std::string_view name(ModelOptions::RollerContacts contacts) {
  return contacts == ModelOptions::RollerContacts::opposite ? "opposite" : "half_pitch_apart";
}

std::string_view name(ModelOptions::Accuracy accuracy) {
  return accuracy == ModelOptions::Accuracy::working ? "working" : "reference";
}

std::vector<std::string_view> effects_off(const RefinedEffects& e) {
  const std::pair<std::string_view, bool> effects[] = {{"core", e.core},
                                                       {"shear", e.shear},
                                                       {"hoop", e.hoop},
                                                       {"poisson", e.poisson},
                                                       {"flange", e.flange},
                                                       {"radial", e.radial},
                                                       {"concentration", e.concentration}};
  std::vector<std::string_view> off;
  for (const auto& [effect, on] : effects)
    if (!on) off.push_back(effect);
  return off;
}

bool has_yamamoto(const ModelOptions& m) {
  return m.tooth_compliance.kind == ModelOptions::ToothCompliance::Kind::yamamoto;
}

/// What the model is known to be off by, at the full load of lesson 1's screw against finite
/// elements (docs/refined.md, docs/influence.md); empty where it was changed for comparison.
std::string_view known_bias(const ModelOptions& m) {
  if (m.mechanism == ModelOptions::Mechanism::full && m.bodies == Bodies::bars)
    return "all rollers; about as much too stiff as `bars` of a sector";
  if (has_yamamoto(m)) return "for comparison: Hertz has the deflection of the teeth already";
  switch (m.bodies) {
    case Bodies::bars:
      return "17 to 32 % stiffer than finite elements on an inverted 21 x 5 mm screw; nearer: "
             "`model: {bodies: refined}`";
    case Bodies::refined:
      return effects_off(m.refined).empty()
                 ? "0.4 to 3.4 % stiffer than finite elements on an inverted 21 x 5 mm screw"
                 : "";
    case Bodies::influence:
      break;
  }
  return "within 0.5 % of finite elements on an inverted 21 x 5 mm screw";
}

}  // namespace

nlohmann::ordered_json model_json(const Result& result) {
  const ModelOptions& m = result.model;
  nlohmann::ordered_json json;
  json["bodies"] = name(m.bodies);
  if (m.bodies != Bodies::bars)
    json["roller_contacts"] = name(roller_contacts(m, result.contacts.mechanism.starts.roller));
  if (m.bodies == Bodies::refined) json["effects_off"] = effects_off(m.refined);
  if (m.bodies == Bodies::influence) json["accuracy"] = name(m.accuracy);
  if (has_yamamoto(m))
    json["tooth_compliance_width_mm"] = m.tooth_compliance.width * per_si::millimetre;
  if (!known_bias(m).empty()) json["note"] = known_bias(m);
  return json;
}

std::string model_line(const Result& result) {
  const ModelOptions& m = result.model;
  if (std::ranges::none_of(result.load_cases,
                           [](const LoadCaseResult& r) { return r.solve.has_value(); }))
    return {};
  std::string line = fmt::format("bodies: {}", name(m.bodies));
  if (m.bodies != Bodies::bars)
    line += fmt::format(", roller contacts {}",
                        name(roller_contacts(m, result.contacts.mechanism.starts.roller)));
  if (m.bodies == Bodies::influence) line += fmt::format(", {} accuracy", name(m.accuracy));
  if (m.bodies == Bodies::refined && !effects_off(m.refined).empty())
    line += fmt::format(", without {}", fmt::join(effects_off(m.refined), ", "));
  if (has_yamamoto(m))
    line += fmt::format(", tooth deflection after Yamamoto over {:g} mm",
                        m.tooth_compliance.width * per_si::millimetre);
  if (!known_bias(m).empty()) line += fmt::format(": {}", known_bias(m));
  return line + '\n';
}

}  // namespace prs
