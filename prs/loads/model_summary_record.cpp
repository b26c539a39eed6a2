#include "prs/loads/model_summary_record.h"

#include <fmt/ranges.h>

#include "prs/record/record_table.h"

namespace prs {
namespace {

using Bodies = ModelOptions::Bodies;

std::string_view name(ModelOptions::RollerContacts contacts) {
  return contacts == ModelOptions::RollerContacts::opposite ? "opposite" : "half_pitch_apart";
}

std::string_view name(ModelOptions::Accuracy accuracy) {
  return accuracy == ModelOptions::Accuracy::working ? "working" : "reference";
}

std::vector<std::string> effects_off(const RefinedEffects& e) {
  const std::pair<std::string_view, bool> effects[] = {{"core", e.core},
                                                       {"shear", e.shear},
                                                       {"hoop", e.hoop},
                                                       {"poisson", e.poisson},
                                                       {"flange", e.flange},
                                                       {"radial", e.radial},
                                                       {"concentration", e.concentration}};
  std::vector<std::string> off;
  for (const auto& [effect, on] : effects)
    if (!on) off.emplace_back(effect);
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

const ModelOptions& options_of(const ModelSummary& s) { return s.result->model; }

template <auto of_options, auto applies>
constexpr auto of_model = of<[](const ModelSummary& s) { return of_options(options_of(s)); },
                             [](const ModelSummary& s) { return applies(options_of(s)); }>;

template <Bodies bodies>
constexpr auto is = [](const ModelOptions& m) { return m.bodies == bodies; };

constexpr Quantity<ModelSummary> kModelSummary[] = {
    {"bodies", of<[](const ModelSummary& s) { return name(options_of(s).bodies); }>,
     "bars | refined | influence"},
    {"roller_contacts",
     of<[](const ModelSummary& s) {
       return name(roller_contacts(options_of(s), s.result->contacts.mechanism.starts.roller));
     },
        [](const ModelSummary& s) { return !is<Bodies::bars>(options_of(s)); }>,
     "opposite | half_pitch_apart"},
    {"effects_off",
     of_model<[](const ModelOptions& m) { return effects_off(m.refined); }, is<Bodies::refined>>,
     "effects of `refined` that are switched off"},
    {"accuracy",
     of_model<[](const ModelOptions& m) { return name(m.accuracy); }, is<Bodies::influence>>,
     "working | reference, of `influence`"},
    {"tooth_compliance_width_mm",
     of_model<[](const ModelOptions& m) { return m.tooth_compliance.width; }, has_yamamoto>,
     "of the teeth that deflect as Yamamoto has it", "", "", "", "", Reach::document},
    {"note", of_model<known_bias, [](const ModelOptions& m) { return !known_bias(m).empty(); }>,
     "how far it is known to be off"},
};

}  // namespace

Record<ModelSummary> record_of(Type<ModelSummary>) {
  return {"Model", "How the loads were solved.", kModelSummary};
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
