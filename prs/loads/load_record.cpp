#include "prs/loads/load_record.h"

#include <fmt/ranges.h>

#include <numeric>

#include "fe/cholesky.h"
#include "prs/bodies/body_models.h"
#include "prs/loads/load_case_result.h"
#include "prs/record/record_table.h"

namespace prs {

std::optional<std::string> factorization(const LoadCaseResult& r) {
  if (!r.solve || r.solve->history.empty()) return std::nullopt;
  // Only `influence` computes no energy.
  if (std::isnan(r.solve->history.back().energy)) {
    const std::string eigen = fe::eigen_factorization_name();
    return eigen.substr(0, eigen.find(',')) + ", dense LU";
  }
  std::string name(fe::Cholesky::name());
  if (r.solve->wide) name += "; then LDL' of 113 binary digits";
  return name;
}

namespace {

constexpr Quantity<FrictionForces> kFrictionForces[] = {
    {"axial", of<&FrictionForces::axial>, "along x, from the loaded end of the screw"},
    {"radial", of<&FrictionForces::radial>, "outwards"},
    {"tangential", of<&FrictionForces::tangential>, "along the orbit"},
};

constexpr Quantity<RunningLoads> kRunning[] = {
    {"status", of<&RunningLoads::status>, "how the search for loads and friction ended"},
    {"rounds", of<&RunningLoads::rounds>, "evaluations of slip", "", "", "", "", Reach::document},
    {"change", of<&RunningLoads::change>, "of a thread's load in the last round, over the largest load", "", "", "", "",
     Reach::document},
};

struct LargestAtRest {
  double normal_load;
};

constexpr Quantity<LargestAtRest> kLargestAtRest[] = {
    {"largest_normal_load_N", of<&LargestAtRest::normal_load>, "of all threads"},
};

template <Interface i>
constexpr auto largest_at_rest =
    of<[](const RunningLoads::AtRest& r) { return LargestAtRest{r.largest_normal_load[i]}; }>;

constexpr Quantity<RunningLoads::AtRest> kAtRest[] = {
    {"screw", largest_at_rest<Interface::screw>, "threads at the screw"},
    {"nut", largest_at_rest<Interface::nut>, "threads at the nut"},
    {"axial_displacement_um", of<&RunningLoads::AtRest::axial_displacement>,
     "of the loaded section; > 0 along the load"},
};

bool has_load(const InterfaceLoads& l) { return l.load_rate.empty() || !std::isnan(l.load_rate.front()); }

constexpr Quantity<InterfaceLoads> kInterfaceLoads[] = {
    {"hertz_constant_N_per_mm1_5", of<&InterfaceLoads::hertz_constant>,
     "k_0 of N = k_0 delta^1.5, as used in the solve", source::kHertz},
    {"normal_angle_deg", of<&InterfaceLoads::normal_angle>,
     "psi between the normal and the axis, as used in the solve"},
    {"axial_load_N", of<&InterfaceLoads::axial_load>,
     "axial part of the normal load, of a running screw with that of friction"},
    {"normal_load_N", of<&InterfaceLoads::normal_load>, "at rest axial load over cos(psi)"},
    {"load_rate_percent", of<&InterfaceLoads::load_rate, has_load>, "share: axial load over force per roller",
     "Abevi 2015, (3)"},
    {"approach_um", of<&InterfaceLoads::approach>, "by which the bodies come closer along the normal", source::kHertz},
    {"semi_major_mm", of<&InterfaceLoads::semi_major>, "longer semi-axis a of the contact ellipse", source::kHertz,
     "semi-axis a of the ellipse"},
    {"semi_minor_mm", of<&InterfaceLoads::semi_minor>, "shorter semi-axis b of the contact ellipse", source::kHertz,
     "semi-axis b of the ellipse"},
    {"peak_pressure_MPa", of<&InterfaceLoads::peak_pressure>, "p_0 = 3 N/(2 pi a b)", source::kHertz},
    {"max_shear_stress_MPa", of<&InterfaceLoads::max_shear_stress>, "largest shear stress below the surface",
     source::kHertz, "largest shear stress", "", "", Reach::complete},
    {"max_shear_depth_mm", of<&InterfaceLoads::max_shear_depth>,
     "where the largest shear stress acts, for the depth of hardening", source::kHertz,
     "depth of the largest shear stress", "", "", Reach::complete},
    {"max_von_mises_stress_MPa", of<&InterfaceLoads::max_von_mises_stress>,
     "largest von Mises stress below the centre of the ellipse", source::kHertz, "largest von Mises stress", "", "",
     Reach::complete},
    {"max_von_mises_depth_mm", of<&InterfaceLoads::max_von_mises_depth>, "where the largest von Mises stress acts",
     source::kHertz, "depth of the largest von Mises stress", "", "", Reach::complete},
    {"friction_force_N", of<&InterfaceLoads::friction>, "of each thread on the roller; running loads"},
    {"running_over_static", of<&InterfaceLoads::running_over_static>,
     "largest normal load over the largest of the same case at rest; running loads"},
    {"", of<&InterfaceLoads::rollers>},
};

using fe::NewtonIteration;

constexpr Quantity<NewtonIteration> kNewtonIteration[] = {
    {"energy_J", of<&NewtonIteration::energy>, "potential energy after the step"},
    {"relative_residual", of<&NewtonIteration::relative_residual>, "largest force out of balance over the load"},
    {"step_length", of<&NewtonIteration::step_length>, "share of the Newton step that was taken"},
    {"shift", of<&NewtonIteration::shift>, "added to the diagonal so that it can be solved"},
};

/// Getter of results of solving; none for load cases that are not solved.
template <auto get>
constexpr auto of_solve =
    of<[](const LoadCaseResult& r) { return r.solve ? std::optional(std::invoke(get, *r.solve)) : std::nullopt; }>;

template <Interface i>
constexpr auto of_loads =
    of<[](const LoadCaseResult& r) { return r.threads ? &(*r.threads)[i] : nullptr; }, &LoadCaseResult::converged>;

/// Getter of values of the guides of all rollers; none without a clearance.
template <std::array<double, 4> GuideLoads::*values>
constexpr auto of_guides = of<[](const LoadCaseResult& r) {
  return r.guides.empty() ? std::nullopt : std::optional(roller_after_roller(r.guides, values));
}>;

/// One flank of a nut under preload.
struct FlankOf {
  const LoadCaseResult* result = nullptr;
  bool named = true;  ///< Whether it is the flank named by the direction of the load.
};

struct FlankSide {
  const std::vector<double>*normal_load, *axial_load, *power;
  double rollers = 1.0;
};

}  // namespace

Record<FlankSide> record_of(Type<FlankSide>);
Record<FlankOf> record_of(Type<FlankOf>);
Record<PerDirection<FlankOf>> record_of(Type<PerDirection<FlankOf>>);

namespace {

template <Interface i>
constexpr auto side_of_flank = of<[](const FlankOf& f) {
  const LoadCaseResult& r = *f.result;
  const FlankThreads& other = r.other_flank->threads[i];
  const InterfaceLoads& loads = (*r.threads)[i];
  const std::vector<double>* power = r.slip && r.slip->converged() ? &other.power : nullptr;
  if (power && f.named) {
    power = &r.slip->of_nut_that_carries(r.load_case).threads[i].power;
  }
  return f.named ? FlankSide{&loads.normal_load, &loads.axial_load, power, r.other_flank->rollers}
                 : FlankSide{&other.normal_load, &other.axial_load, power, r.other_flank->rollers};
}>;

constexpr Quantity<FlankSide> kFlankSide[] = {
    {"normal_load_N", of<[](const FlankSide& s) { return *s.normal_load; }>, "of each thread of a roller"},
    {"power_W", of<[](const FlankSide& s) { return s.power; }>, "that friction takes at each of them; with slip"},
    {"axial_N", of<[](const FlankSide& s) {
       return s.rollers * std::accumulate(s.axial_load->begin(), s.axial_load->end(), 0.0);
     }>,
     "axial load of all rollers; that of the tension flank less that of the compression flank is "
     "the load"},
};

constexpr Quantity<FlankOf> kFlank[] = {
    {"screw", side_of_flank<Interface::screw>, "threads at the screw"},
    {"nut", side_of_flank<Interface::nut>, "threads at the nut"},
};

using BothFlanks = PerDirection<FlankOf>;

constexpr Quantity<BothFlanks> kFlanks[] = {
    {"tension", of<&BothFlanks::tension>, "that carries tension"},
    {"compression", of<&BothFlanks::compression>, "that carries compression"},
};

constexpr Quantity<LoadCaseResult> kLoadCase[] = {
    {"name", of<[](const LoadCaseResult& r) -> const std::string& { return r.load_case.name; }>, "as the file has it"},
    {"axial_force_N", of<[](const LoadCaseResult& r) { return r.load_case.axial_force; }>,
     "on the whole screw; > 0 with a direction"},
    {"direction", of<[](const LoadCaseResult& r) { return r.load_case.direction; }>, "tension | compression"},
    {"position_mm", of<[](const LoadCaseResult& r) { return r.load_case.position; }>,
     "of the first roller contact on the nut"},
    {"loads", of<&LoadCaseResult::loads>, "static | running: of a screw that turns, with friction", "", "thread loads"},
    {"converged", of<&LoadCaseResult::converged>, "whether there is an equilibrium"},
    {"status", of<status_name>, "how the solve ended; equal thread loads need none"},
    {"iterations", of_solve<&fe::NewtonSummary::iterations>, "linear solves", "", "", "", "", Reach::document},
    {"relative_residual", of_solve<&fe::NewtonSummary::relative_residual>, "largest force out of balance over the load",
     "", "", "", "", Reach::document},
    {"factorization", of<factorization>, "library, version and kind of what solved the sparse equations", "", "", "",
     "", Reach::document},
    {"axial_displacement_um", of<&LoadCaseResult::axial_displacement, &LoadCaseResult::converged>,
     "of the loaded section; > 0 along the load"},
    {"axial_stiffness_N_per_um", of<&LoadCaseResult::axial_stiffness, &LoadCaseResult::converged>,
     "secant: force over displacement"},
    {"tangent_stiffness_N_per_um", of<&LoadCaseResult::tangent_stiffness, &LoadCaseResult::converged>,
     "derivative of the force by the displacement"},
    {"running", of<&LoadCaseResult::running>, "how loads and friction were found together"},
    {"static",
     of<[](const LoadCaseResult& r) { return r.running ? &r.running->at_rest : nullptr; }, &LoadCaseResult::converged>,
     "the same case at rest, at the same temperatures; running loads"},
    {"screw", of_loads<Interface::screw>, "threads of one roller at the screw"},
    {"nut", of_loads<Interface::nut>, "threads of one roller at the nut"},
    {"guide_displacement_um", of_guides<&GuideLoads::displacement>,
     "of guides with a clearance, of the roller's end nodes outwards: outer and inner of the first end, inner and "
     "outer of the last; roller after roller"},
    {"guide_force_N", of_guides<&GuideLoads::force>, "of these guides on the roller, outwards"},
    {"flanks", of<[](const LoadCaseResult& r) -> std::optional<BothFlanks> {
       if (!r.other_flank || !r.threads) return std::nullopt;
       const bool tension = r.load_case.direction == Direction::tension;
       return BothFlanks{{&r, tension}, {&r, !tension}};
     }>,
     "under preload: both flanks of the threads, or both nuts; the lists above are those of the "
     "flank that the direction names"},
    {"", of<[](const LoadCaseResult& r) { return r.full.get(); }>},
    {"warnings", of<[](const LoadCaseResult& r) { return sentences(selected(r.warnings, false)); }>,
     "what is unusual about this load"},
    {"assumptions", of<[](const LoadCaseResult& r) {
       const std::vector<std::string> all = sentences(selected(r.warnings, true));
       return all.empty() ? std::nullopt : std::optional(all);
     }>,
     "choices of the model that matter for it"},
    {"newton_history", of<[](const LoadCaseResult& r) { return r.solve ? &r.solve->history : nullptr; }>,
     "one per linear solve; documents of many load cases leave it out", "", "", "", "", Reach::document},
};

}  // namespace

PRS_RECORD(FlankSide, "FlankThreads", "Threads of a flank of one roller at an interface.", kFlankSide);
PRS_RECORD(FlankOf, "Flank", "A flank of a nut under preload.", kFlank);
PRS_RECORD(BothFlanks, "Flanks", "Both flanks of a nut under preload.", kFlanks);
PRS_RECORD(FrictionForces, "FrictionForces", "Friction of each thread on the roller.", kFrictionForces);
PRS_RECORD(RunningLoads, "Running", "How loads of a running screw and their friction were found.", kRunning);
PRS_RECORD(LargestAtRest, "LargestAtRest", "Threads of an interface of a screw at rest.", kLargestAtRest);
PRS_RECORD(RunningLoads::AtRest, "AtRest", "What a running load case is at rest.", kAtRest);
PRS_RECORD(InterfaceLoads, "InterfaceLoads",
           "Threads of one interface of one roller; thread 1 is next to the loaded end of the screw.", kInterfaceLoads);
PRS_RECORD(NewtonIteration, "NewtonIteration", "One linear solve of the load distribution.", kNewtonIteration);
PRS_RECORD(LoadCaseResult, "LoadCase",
           "The answer to one load case; one that did not converge has its status and residual alone.", kLoadCase);

namespace {

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

const ModelOptions& options_of(const ModelSummary& s) { return s.result->model; }

template <auto of_options, auto applies>
constexpr auto of_model = of<[](const ModelSummary& s) { return of_options(options_of(s)); },
                             [](const ModelSummary& s) { return applies(options_of(s)); }>;

template <bool BodyModel::*ability>
constexpr auto knows = [](const ModelOptions& m) { return m.bodies->*ability; };

constexpr Quantity<ModelSummary> kModelSummary[] = {
    {"bodies", of<[](const ModelSummary& s) { return options_of(s).bodies->name; }>, kBodyWords.text},
    {"roller_contacts",
     of<[](const ModelSummary& s) {
       return name(roller_contacts(options_of(s), s.result->contacts.mechanism.starts.roller));
     },
        [](const ModelSummary& s) { return options_of(s).bodies->grooves; }>,
     "opposite | half_pitch_apart"},
    {"effects_off", of_model<[](const ModelOptions& m) { return effects_off(m.refined); }, knows<&BodyModel::effects>>,
     "effects of `refined` that are switched off"},
    {"accuracy", of_model<[](const ModelOptions& m) { return name(m.accuracy); }, knows<&BodyModel::meshes>>,
     "working | reference, of `influence`"},
    {"tooth_compliance_width_mm",
     of_model<[](const ModelOptions& m) { return m.tooth_compliance.width; }, has_yamamoto>,
     "of the teeth that deflect as Yamamoto has it", "", "", "", "", Reach::document},
    {"note", of_model<known_bias, [](const ModelOptions& m) { return !known_bias(m).empty(); }>,
     "how far it is known to be off"},
};

}  // namespace

PRS_RECORD(ModelSummary, "Model", "How the loads were solved.", kModelSummary);

bool has_solved(const Result& result) {
  return std::ranges::any_of(result.load_cases, [](const LoadCaseResult& r) { return r.solve.has_value(); });
}

std::string_view known_bias(const ModelOptions& m) {
  const bool full = m.all_rollers();
  if (full && m.bodies->bias_of_all_rollers != m.bodies->bias) return m.bodies->bias_of_all_rollers;
  if (has_yamamoto(m)) return "for comparison: Hertz has the deflection of the teeth already";
  return m.bodies->effects && !effects_off(m.refined).empty() ? "" : m.bodies->bias;
}

std::string model_line(const Result& result) {
  const ModelOptions& m = result.model;
  if (!has_solved(result)) return {};
  std::string line = fmt::format("bodies: {}", m.bodies->name);
  if (m.bodies->grooves)
    line += fmt::format(", roller contacts {}", name(roller_contacts(m, result.contacts.mechanism.starts.roller)));
  if (m.bodies->meshes) line += fmt::format(", {} accuracy", name(m.accuracy));
  if (m.bodies->effects && !effects_off(m.refined).empty())
    line += fmt::format(", without {}", fmt::join(effects_off(m.refined), ", "));
  if (has_yamamoto(m))
    line += fmt::format(", tooth deflection after Yamamoto over {:g} mm", m.tooth_compliance.width * "mm"_per_si);
  if (!known_bias(m).empty()) line += fmt::format(": {}", known_bias(m));
  return line + '\n';
}

namespace {

constexpr Quantity<PartNumbers> kPartNumbers[] = {
    {"screw", of<&PartNumbers::screw>, "of the screw"},
    {"rollers", of<&PartNumbers::rollers>, "of all rollers"},
    {"nut", of<&PartNumbers::nut>, "of the nut"},
};

constexpr Quantity<PartTimes> kPartTimes[] = {
    {"screw", of<&PartTimes::screw>, "of the screw"},
    {"rollers", of<&PartTimes::rollers>, "of all rollers"},
    {"nut", of<&PartTimes::nut>, "of the nut"},
};

constexpr Quantity<PartSeries> kPartSeries[] = {
    {"screw", of<&PartSeries::screw>, "of the screw"},
    {"rollers", of<&PartSeries::rollers>, "of all rollers"},
    {"nut", of<&PartSeries::nut>, "of the nut"},
};

constexpr Quantity<InterfaceNumbers> kInterfaceNumbers[] = {
    {"screw", of<&InterfaceNumbers::screw>, "of the contacts at the screw"},
    {"nut", of<&InterfaceNumbers::nut>, "of the contacts at the nut"},
};

std::optional<std::string> reason_of(const std::string& reason) {
  return reason.empty() ? std::nullopt : std::optional(reason);
}

template <auto member>
constexpr auto in_celsius = [](auto& r) { return celsius_of(r.*member); };
template <auto member>
constexpr auto in_celsius_if = [](auto& r) {
  const auto& temperature = r.*member;
  return temperature ? std::optional(celsius_of(*temperature)) : std::nullopt;
};

template <auto get>
constexpr auto balanced = of<get, &HeatResult::converged>;

constexpr Quantity<HeatResult> kHeat[] = {
    {"converged", of<&HeatResult::converged>, "whether there is a steady state"},
    {"status", of<&HeatResult::status>, "converged | no_steady_state | iteration_limit"},
    {"reason", of<[](const HeatResult& r) { return reason_of(r.reason); }>, "where not converged"},
    {"evaluations", of<&HeatResult::evaluations>, "of the losses at temperatures", "", "", "", "", Reach::document},
    {"other_steady_states", balanced<&HeatResult::others>,
     "whether hotter ones exist; this one is reached from ambient temperature"},
    {"temperature_degC", balanced<in_celsius<&HeatResult::temperature>>, "of each part"},
    {"oil_degC", balanced<in_celsius_if<&HeatResult::oil>>,
     "at the contacts of each interface: the mean of its two bodies; needs a lubricant"},
    {"heat_W", balanced<[](const HeatResult& r) {
       return PartNumbers{r.heat.screw, r.heat.roller, r.heat.nut};
     }>,
     "that friction puts into each part"},
};

template <auto get>
constexpr auto periodic = of<get, &HeatCycle::converged>;

bool has_course(const HeatCycle& r) { return r.converged() && !r.time.empty(); }

constexpr Quantity<HeatCycle> kHeatCycle[] = {
    {"converged", of<&HeatCycle::converged>, "whether there is a state that repeats itself"},
    {"status", of<&HeatCycle::status>, "converged | no_steady_state | iteration_limit"},
    {"reason", of<[](const HeatCycle& r) { return reason_of(r.reason); }>, "where not converged"},
    {"period_s", of<&HeatCycle::period>, "of the duty"},
    {"cycles", of<[](const HeatCycle& r) { return r.is_mission() ? std::optional(r.cycles) : std::nullopt; }>,
     "of the mission; with heat.cycles"},
    {"time_s", of<&HeatCycle::time, has_course>, "from the start of the cycle, or of the mission, to its end"},
    {"temperature_degC", of<in_celsius<&HeatCycle::temperature>, has_course>, "of each part at these times"},
    {"start_degC", periodic<in_celsius_if<&HeatCycle::start>>,
     "of each part at the start of the mission; with heat.cycles"},
    {"end_degC", periodic<in_celsius_if<&HeatCycle::end>>, "of each part at its end"},
    {"time_to_limit_s", of<[](const HeatCycle& r) -> std::optional<PartTimes> {
       const auto& t = r.time_to_limit;
       if (!t.screw && !t.roller && !t.nut) return std::nullopt;
       return PartTimes{t.screw, t.roller, t.nut};
     }>,
     "until parts first reach limits.temperature in the mission"},
    {"peak_degC", periodic<in_celsius<&HeatCycle::peak>>, "largest of each part"},
    {"mean_degC", periodic<in_celsius<&HeatCycle::mean>>, "of each part over the cycle or the mission"},
    {"energy_in_J", periodic<&HeatCycle::energy_in>,
     "that shaft and load bring in while they drive, per cycle or mission"},
    {"energy_lost_J", periodic<&HeatCycle::energy_lost>, "to friction, per cycle or mission"},
    {"efficiency", periodic<&HeatCycle::efficiency>, "energy out over energy in"},
};

}  // namespace

PartNumbers celsius_of(const PerPart<double>& k) {
  return {k.screw - kZeroCelsius, k.roller - kZeroCelsius, k.nut - kZeroCelsius};
}
PartSeries celsius_of(const PerPart<std::vector<double>>& kelvin) {
  PartSeries series{kelvin.screw, kelvin.roller, kelvin.nut};
  for (std::vector<double>* part : {&series.screw, &series.rollers, &series.nut})
    for (double& value : *part) value -= kZeroCelsius;
  return series;
}
InterfaceNumbers celsius_of(const PerInterface<double>& k) { return {k.screw - kZeroCelsius, k.nut - kZeroCelsius}; }

PRS_RECORD(PartNumbers, "PartNumbers", "A number of each part.", kPartNumbers);
PRS_RECORD(PartSeries, "PartSeries", "Numbers of each part over time.", kPartSeries);
PRS_RECORD(InterfaceNumbers, "InterfaceNumbers", "A number of each interface.", kInterfaceNumbers);
PRS_RECORD(HeatResult, "Heat",
           "Steady temperatures: what friction puts into the parts flows off through the "
           "conductances.",
           kHeat);
PRS_RECORD(HeatCycle, "HeatCycle", "The state of a duty that repeats itself from cycle to cycle, or a mission.",
           kHeatCycle);
PRS_RECORD(PartTimes, "PartTimes", "A time of each part to which something happens.", kPartTimes);

namespace {

using contact::MechanismGeometry;
using TwoValues = std::array<double, 2>;

template <class T>
constexpr Quantity<PerPart<T>> kPerPart[] = {
    {"screw", of<&PerPart<T>::screw>},
    {"roller", of<&PerPart<T>::roller>},
    {"nut", of<&PerPart<T>::nut>},
};

constexpr Quantity<PerInterface<double>> kPerInterface[] = {
    {"screw", of<&PerInterface<double>::screw>},
    {"nut", of<&PerInterface<double>::nut>},
};

template <class T>
constexpr Quantity<PerDirection<T>> kPerDirection[] = {
    {"tension", of<&PerDirection<T>::tension>},
    {"compression", of<&PerDirection<T>::compression>},
};

template <auto get>
constexpr auto point = of<[](const ContactAt& c) { return std::invoke(get, c.contact().geometry.point); }>;

template <contact::PrincipalValues contact::InterfaceGeometry::*values>
constexpr auto both = of<[](const ContactAt& c) {
  return TwoValues{(c.contact().geometry.*values).first, (c.contact().geometry.*values).second};
}>;

template <auto get>
constexpr auto geometry = of<[](const ContactAt& c) { return std::invoke(get, c.contact().geometry); }>;

template <double contact::HertzConstants::*get>
constexpr auto hertz = of<[](const ContactAt& c) { return c.contact().hertz.*get; },
                          [](const ContactAt& c) { return c.contact().hertz.ok(); }>;

template <double contact::SubsurfaceShear::*get>
constexpr auto shear = of<[](const ContactAt& c) { return (*c.contact().shear).*get; },
                          [](const ContactAt& c) { return c.contact().shear.has_value(); }>;

template <double contact::SubsurfaceVonMises::*get>
constexpr auto von_mises = of<[](const ContactAt& c) { return (*c.contact().von_mises).*get; },
                              [](const ContactAt& c) { return c.contact().von_mises.has_value(); }>;

std::array<double, 3> components(const contact::Vector3<double>& v) { return {v.x, v.y, v.z}; }

/// Acute angle between the major axis and the first principal direction of a part.
template <contact::PrincipalValues contact::InterfaceGeometry::*part>
constexpr auto angle_to_major_axis = of<[](const ContactAt& c) {
  const contact::InterfaceGeometry& g = c.contact().geometry;
  return std::abs(std::remainder((g.*part).angle - g.relative.angle, std::numbers::pi));
}>;

/// Contact point for tension; z from the origin of the roller's surface (Sandu 2018, (1.22)).
std::array<double, 3> position(const ContactAt& c) {
  const contact::ContactPoint& p = c.contact().geometry.point;
  const contact::ThreadSurface roller(c.contacts->threads.roller);
  const contact::RollerFace face = c.interface == Interface::screw
                                       ? contact::roller_face_at_screw(contact::Configuration::i1_j2)
                                       : contact::roller_face_at_nut(contact::Configuration::i1_j2);
  return {p.position.x, p.position.y,
          static_cast<int>(face) * roller.profile(p.radius_on_roller).height + roller.reduced_lead * p.angle_on_roller};
}

template <contact::Configuration configuration>
constexpr auto origin_height = of<[](const ContactAt& c) {
  const contact::MechanismContact contact{c.contacts->interfaces.screw.geometry, c.contacts->interfaces.nut.geometry};
  const contact::AxialPositions at = contact::axial_positions(c.contacts->threads, contact, configuration);
  return c.interface == Interface::screw ? at.screw : at.nut;
},
                                  [](const ContactAt& c) { return c.same_pitch(); }>;

template <auto get>
constexpr auto clearance = of<[](const ContactAt& c) {
  return c.contact().clearance ? std::optional<double>((*c.contact().clearance).*get) : std::nullopt;
}>;

using contact::HertzConstants;
using contact::InterfaceGeometry;
using Point = contact::ContactPoint;

constexpr std::string_view kSandu = "Sandu 2018, chapter 1", kYao = "Yao 2023, (55) to (58)";

constexpr Quantity<ContactAt> kInterfaceContact[] = {
    {"radius_on_body_mm", point<&Point::radius_on_body>, "of the contact point from the body's axis", kSandu,
     "radius on the body"},
    {"radius_on_roller_mm", point<&Point::radius_on_roller>, "of the contact point from the roller's axis", kSandu,
     "radius on the roller"},
    {"angle_on_body_deg", point<&Point::angle_on_body>,
     "of the contact point about the body's axis, from the line of centres", kSandu, "angle on the body"},
    {"angle_on_roller_deg", point<&Point::angle_on_roller>,
     "of the contact point about the roller's axis, from the line of centres", kSandu, "angle on the roller"},
    {"flank_clearance_mm", clearance<&ThreadClearance::flank>,
     "along the axis, each thread in the middle of the other's groove; half the backlash", kYao,
     "flank to flank when centred"},
    {"body_crest_clearance_mm", clearance<&ThreadClearance::body_crest>,
     "along the axis, from the edge of the body's crest to the roller's flank", kYao, "crest of the body to flank"},
    {"roller_crest_clearance_mm", clearance<&ThreadClearance::roller_crest>,
     "along the axis, from the edge of the roller's crest to the body's flank", kYao, "crest of the roller to flank"},
    {"body_curvatures_per_mm", both<&InterfaceGeometry::body>,
     "principal curvatures, convex > 0, ascending in absolute value", kSandu, "curvatures of the body"},
    {"roller_curvatures_per_mm", both<&InterfaceGeometry::roller>,
     "principal curvatures, convex > 0, ascending in absolute value", kSandu, "curvatures of the roller"},
    {"relative_curvatures_per_mm", both<&InterfaceGeometry::relative>,
     "eigenvalues of the sum of both curvature tensors, without a factor 1/2", kSandu, "relative curvatures"},
    {"curvature_sum_per_mm", geometry<&InterfaceGeometry::curvature_sum>, "kappa_1 + kappa_2", "Sandu 2018, (1.77)",
     "sum of the relative curvatures"},
    {"equivalent_radius_mm", geometry<[](const InterfaceGeometry& g) { return 1.0 / g.curvature_sum(); }>,
     "1 over the sum of the relative curvatures"},
    {"first_directions_angle_deg", geometry<&InterfaceGeometry::first_directions_angle>,
     "between the first principal directions of body and roller", "Sandu 2018, (1.61)",
     "angle of the first directions"},
    {"normal_angle_deg", point<&Point::normal_angle>, "psi = arccos|n_z|", kSandu, "normal against the axis"},
    {"normal", of<[](const ContactAt& c) { return components(c.contact().geometry.point.normal); }>,
     "unit vector, outward from the roller: radial, across, axial", kSandu},
    {"position_mm", of<position>,
     "contact point in tension: radial and across from the axis of screw and nut, axial from the origin of the "
     "roller's surface; in compression across and axial change sign",
     "Sandu 2018, (1.22)"},
    {"origin_height_tension_mm", origin_height<contact::Configuration::i1_j2>,
     "of the body's surface origin above the roller's, along the axis, in tension; needs equal pitches",
     "Sandu 2018, (1.41) to (1.44)"},
    {"origin_height_compression_mm", origin_height<contact::Configuration::i2_j1>, "the same in compression",
     "Sandu 2018, (1.41) to (1.44)"},
    {"major_axis", of<[](const ContactAt& c) { return components(c.contact().geometry.major_axis); }>,
     "t_1, unit vector along the major axis of the ellipse: radial, across, axial", "Sandu 2018, (1.67)"},
    {"major_axis_from_body_deg", angle_to_major_axis<&InterfaceGeometry::body>,
     "phi_1, acute angle of the major axis from the body's first principal direction",
     "Sandu 2018, (1.65); Yao 2023, (36)", "major axis from the body's first direction"},
    {"major_axis_from_roller_deg", angle_to_major_axis<&InterfaceGeometry::roller>,
     "phi_2, acute angle of the major axis from the roller's first principal direction",
     "Sandu 2018, (1.62); Yao 2023, (36)", "major axis from the roller's first direction"},
    {"backlash_mm",
     of<[](const ContactAt& c) { return c.contact().geometry.point.backlash; },
        [](const ContactAt& c) { return c.same_pitch(); }>,
     "axial play of both faces; < 0: the threads are too thick; needs equal pitches", "Sandu 2018, (1.40)"},
    {"hertz_constant_N_per_mm1_5", hertz<&HertzConstants::hertz_constant>, "k_0 of N = k_0 delta^1.5", source::kHertz,
     "Hertz constant"},
    {"ellipticity", hertz<&HertzConstants::ellipticity>, "b/a of the contact ellipse", source::kHertz,
     "ellipticity b/a"},
    {"semi_major_mm_per_N1_3", hertz<&HertzConstants::semi_major_per_cbrt_load>,
     "semi-axis a over the cube root of the normal load", source::kHertz, "semi-axis a over cube root of the load"},
    {"semi_minor_mm_per_N1_3", hertz<&HertzConstants::semi_minor_per_cbrt_load>,
     "semi-axis b over the cube root of the normal load", source::kHertz, "semi-axis b over cube root of the load"},
    {"max_shear_over_peak_pressure", shear<&contact::SubsurfaceShear::shear_over_pressure>,
     "largest shear stress below the surface over p_0", source::kHertz, "largest shear stress over peak pressure", "",
     "", Reach::complete},
    {"max_shear_depth_over_semi_minor", shear<&contact::SubsurfaceShear::depth_over_semi_minor>, "its depth over b",
     source::kHertz, "depth of the largest shear stress over semi-axis b", "", "", Reach::complete},
    {"max_von_mises_over_peak_pressure", von_mises<&contact::SubsurfaceVonMises::stress_over_pressure>,
     "largest von Mises stress below the centre of the ellipse over p_0", source::kHertz,
     "largest von Mises stress over peak pressure", "", "", Reach::complete},
    {"max_von_mises_depth_over_semi_minor", von_mises<&contact::SubsurfaceVonMises::depth_over_semi_minor>,
     "its depth over b", source::kHertz, "depth of the largest von Mises stress over semi-axis b", "", "",
     Reach::complete},
};

PerPart<double> of_threads(const MechanismGeometry& threads, auto value) {
  return {value(threads.screw), value(threads.roller), value(threads.nut)};
}

template <Interface i>
constexpr auto contact_of = of<[](const Contacts& c) {
  return c.interfaces[i].geometry.ok() ? std::optional(ContactAt{&c, i}) : std::nullopt;
}>;

constexpr Quantity<Contacts> kContacts[] = {
    {"centre_distance_mm", of<[](const Contacts& c) { return c.threads.centre_distance; }>,
     "from the axis of the screw to that of a roller"},
    {"pitch_diameter_mm", of<[](const Contacts& c) {
       return of_threads(c.threads, [](const auto& thread) { return 2.0 * thread.pitch_radius; });
     }>,
     "where thread and groove are equally wide, or as the file has it"},
    {"helix_angle_deg", of<[](const Contacts& c) {
       return of_threads(c.threads, [](const auto& thread) { return contact::ThreadSurface(thread).helix_angle(); });
     }>,
     "at the pitch diameter"},
    {"profile_radius_limits_mm", of<[](const Contacts& c) {
       const auto range = [](const contact::Thread& thread) {
         const contact::RadiusLimits limits = contact::flank_limits(thread);
         return TwoValues{limits.smallest, limits.largest};
       };
       return PerPart<TwoValues>{range(c.threads.screw), range(c.threads.roller), range(c.threads.nut)};
     }>,
     "radii between which there is a flank", "", "radii of the flanks"},
    {"max_rollers", of<[](const Contacts& c) { return contact::largest_roller_count(c.threads); }>,
     "that fit side by side", "", "rollers that fit"},
    {"screw", contact_of<Interface::screw>, "of roller and screw"},
    {"nut", contact_of<Interface::nut>, "of roller and nut"},
};

constexpr Quantity<ThreadWidths> kThreadWidths[] = {
    {"crest_width_mm", of<&ThreadWidths::crest>, "along the axis; < 0: the profile ends before",
     "Yao 2023, (52) to (54)", "crest width"},
    {"root_width_mm", of<&ThreadWidths::root>, "along the axis", "Yao 2023, (52) to (54)", "root width"},
};

template <contact::Thread MechanismGeometry::*part>
constexpr auto widths = of<[](const MechanismGeometry& threads) {
  const std::optional<ThreadWidths> widths = thread_widths(threads.*part);
  return widths && (widths->crest || widths->root) ? widths : std::nullopt;
}>;

constexpr Quantity<MechanismGeometry> kThreads[] = {
    {"screw", widths<&MechanismGeometry::screw>},
    {"roller", widths<&MechanismGeometry::roller>},
    {"nut", widths<&MechanismGeometry::nut>},
};

}  // namespace

PRS_RECORD(PerPart<double>, "PerPart", "One number each of screw, roller and nut.", kPerPart<double>);
PRS_RECORD(PerPart<TwoValues>, "PerPartRange", "Smallest and largest value each of screw, roller and nut.",
           kPerPart<TwoValues>);
PRS_RECORD(PerInterface<double>, "PerInterface", "One number each of the roller's contacts with screw and nut.",
           kPerInterface);
PRS_RECORD(PerDirection<double>, "PerDirection", "One number for each sense of the load.", kPerDirection<double>);
PRS_RECORD(PerDirection<std::optional<double>>, "PerDirection", "One number for each sense of the load.",
           kPerDirection<std::optional<double>>);
PRS_RECORD(ContactAt, "InterfaceContact",
           "Where two threads touch: Sandu 2018, chapter 1. `body` is the screw or the nut.", kInterfaceContact);
PRS_RECORD(Contacts, "Contacts", "Mechanism and contacts of both interfaces.", kContacts);
PRS_RECORD(ThreadWidths, "ThreadWidths", "Axial widths of a truncated thread.", kThreadWidths);
PRS_RECORD(MechanismGeometry, "Threads", "Threads of the parts by themselves; needs their heights.", kThreads);

}  // namespace prs
