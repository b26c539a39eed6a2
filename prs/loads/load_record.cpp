#include "prs/loads/load_record.h"

#include <numeric>

#include "fe/cholesky.h"
#include "prs/loads/factorization.h"
#include "prs/loads/full_result.h"
#include "prs/model/preload.h"
#include "prs/record/record_table.h"

namespace prs {
std::optional<std::string> factorization(const LoadCaseResult& r) {
  if (!r.solve || r.solve->history.empty()) return std::nullopt;
  // `influence`, which knows no energy.
  if (std::isnan(r.solve->history.back().energy)) {
    const std::string eigen = fe::eigen_factorization_name();
    return eigen.substr(0, eigen.find(',')) + ", dense LU";
  }
  std::string name(fe::Cholesky::name());
  if (r.solve->wide) name += "; then " + fe::eigen_factorization_name() + " of 113 binary digits";
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
    {"change", of<&RunningLoads::change>,
     "of a thread's load in the last round, over the largest load", "", "", "", "",
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

bool has_load(const InterfaceLoads& l) {
  return l.load_rate.empty() || !std::isnan(l.load_rate.front());
}

constexpr Quantity<InterfaceLoads> kInterfaceLoads[] = {
    {"hertz_constant_N_per_mm1_5", of<&InterfaceLoads::hertz_constant>,
     "k_0 of N = k_0 delta^1.5, as used in the solve", source::kHertz},
    {"normal_angle_deg", of<&InterfaceLoads::normal_angle>,
     "psi between the normal and the axis, as used in the solve"},
    {"axial_load_N", of<&InterfaceLoads::axial_load>,
     "axial part of the normal load, of a running screw with that of friction"},
    {"normal_load_N", of<&InterfaceLoads::normal_load>, "at rest axial load over cos(psi)"},
    {"load_rate_percent", of<&InterfaceLoads::load_rate, has_load>,
     "share: axial load over force per roller", "Abevi 2015, (3)"},
    {"approach_um", of<&InterfaceLoads::approach>,
     "by which the bodies come closer along the normal", source::kHertz},
    {"semi_major_mm", of<&InterfaceLoads::semi_major>, "longer semi-axis a of the contact ellipse",
     source::kHertz, "semi-axis a of the ellipse"},
    {"semi_minor_mm", of<&InterfaceLoads::semi_minor>, "shorter semi-axis b of the contact ellipse",
     source::kHertz, "semi-axis b of the ellipse"},
    {"peak_pressure_MPa", of<&InterfaceLoads::peak_pressure>, "p_0 = 3 N/(2 pi a b)",
     source::kHertz},
    {"max_shear_stress_MPa", of<&InterfaceLoads::max_shear_stress>,
     "largest shear stress below the surface", source::kHertz, "largest shear stress", "", "",
     Reach::complete},
    {"max_shear_depth_mm", of<&InterfaceLoads::max_shear_depth>,
     "where the largest shear stress acts, for the depth of hardening", source::kHertz,
     "depth of the largest shear stress", "", "", Reach::complete},
    {"friction_force_N", of<&InterfaceLoads::friction>,
     "of each thread on the roller; running loads"},
    {"running_over_static", of<&InterfaceLoads::running_over_static>,
     "largest normal load over the largest of the same case at rest; running loads"},
    {"", of<&InterfaceLoads::rollers>},
};

using fe::NewtonIteration;

constexpr Quantity<NewtonIteration> kNewtonIteration[] = {
    {"energy_J", of<&NewtonIteration::energy>, "potential energy after the step"},
    {"relative_residual", of<&NewtonIteration::relative_residual>,
     "largest force out of balance over the load"},
    {"step_length", of<&NewtonIteration::step_length>, "share of the Newton step that was taken"},
    {"shift", of<&NewtonIteration::shift>, "added to the diagonal so that it can be solved"},
};

/// Where something is solved.
template <auto get>
constexpr auto of_solve = of<[](const LoadCaseResult& r) {
  return r.solve ? std::optional(std::invoke(get, *r.solve)) : std::nullopt;
}>;

template <Interface i>
constexpr auto of_loads =
    of<[](const LoadCaseResult& r) { return r.threads ? &(*r.threads)[i] : nullptr; },
       &LoadCaseResult::converged>;

/// One flank of a nut under preload.
struct FlankOf {
  const LoadCaseResult* result = nullptr;
  bool named = true;  ///< By the direction of the load.
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
    const bool second = r.slip->second_nut && r.load_case.direction == Direction::tension;
    power = &(second ? *r.slip->second_nut : *r.slip).threads[i].power;
  }
  return f.named ? FlankSide{&loads.normal_load, &loads.axial_load, power, r.other_flank->rollers}
                 : FlankSide{&other.normal_load, &other.axial_load, power, r.other_flank->rollers};
}>;

constexpr Quantity<FlankSide> kFlankSide[] = {
    {"normal_load_N", of<[](const FlankSide& s) { return *s.normal_load; }>,
     "of each thread of a roller"},
    {"power_W", of<[](const FlankSide& s) { return s.power; }>,
     "that friction takes at each of them; with slip"},
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
    {"name", of<[](const LoadCaseResult& r) -> const std::string& { return r.load_case.name; }>,
     "as the file has it"},
    {"axial_force_N", of<[](const LoadCaseResult& r) { return r.load_case.axial_force; }>,
     "on the whole screw; > 0 with a direction"},
    {"direction", of<[](const LoadCaseResult& r) { return r.load_case.direction; }>,
     "tension | compression"},
    {"position_mm", of<[](const LoadCaseResult& r) { return r.load_case.position; }>,
     "of the first roller contact on the nut"},
    {"loads", of<&LoadCaseResult::loads>, "static | running: of a screw that turns, with friction"},
    {"converged", of<&LoadCaseResult::converged>, "whether there is an equilibrium"},
    {"status", of<status_name>, "how the solve ended; equal shares need none"},
    {"iterations", of_solve<&fe::NewtonSummary::iterations>, "linear solves", "", "", "", "",
     Reach::document},
    {"relative_residual", of_solve<&fe::NewtonSummary::relative_residual>,
     "largest force out of balance over the load", "", "", "", "", Reach::document},
    {"factorization", of<factorization>,
     "library, version and kind of what solved the sparse equations", "", "", "", "",
     Reach::document},
    {"axial_displacement_um", of<&LoadCaseResult::axial_displacement, &LoadCaseResult::converged>,
     "of the loaded section; > 0 along the load"},
    {"axial_stiffness_N_per_um", of<&LoadCaseResult::axial_stiffness, &LoadCaseResult::converged>,
     "secant: force over displacement"},
    {"tangent_stiffness_N_per_um",
     of<&LoadCaseResult::tangent_stiffness, &LoadCaseResult::converged>,
     "derivative of the force by the displacement"},
    {"running", of<&LoadCaseResult::running>, "how loads and friction were found together"},
    {"static",
     of<[](const LoadCaseResult& r) { return r.running ? &r.running->at_rest : nullptr; },
        &LoadCaseResult::converged>,
     "the same case at rest, at the same temperatures; running loads"},
    {"screw", of_loads<Interface::screw>, "threads of one roller at the screw"},
    {"nut", of_loads<Interface::nut>, "threads of one roller at the nut"},
    {"flanks", of<[](const LoadCaseResult& r) -> std::optional<BothFlanks> {
       if (!r.other_flank || !r.threads) return std::nullopt;
       const bool tension = r.load_case.direction == Direction::tension;
       return BothFlanks{{&r, tension}, {&r, !tension}};
     }>,
     "under preload: both flanks of the threads, or both nuts; the lists above are those of the "
     "flank that the direction names"},
    {"", of<[](const LoadCaseResult& r) { return r.full.get(); }>},
    {"warnings", of<[](const LoadCaseResult& r) { return sentences(r.warnings); }>,
     "what is unusual about this load"},
    {"newton_history",
     of<[](const LoadCaseResult& r) { return r.solve ? &r.solve->history : nullptr; }>,
     "one per linear solve; documents of many load cases leave it out", "", "", "", "",
     Reach::document},
};

}  // namespace

Record<FlankSide> record_of(Type<FlankSide>) {
  return {"FlankThreads", "Threads of a flank of one roller at an interface.", kFlankSide};
}

Record<FlankOf> record_of(Type<FlankOf>) {
  return {"Flank", "A flank of a nut under preload.", kFlank};
}

Record<BothFlanks> record_of(Type<BothFlanks>) {
  return {"Flanks", "Both flanks of a nut under preload.", kFlanks};
}

Record<FrictionForces> record_of(Type<FrictionForces>) {
  return {"FrictionForces", "Friction of each thread on the roller.", kFrictionForces};
}

Record<RunningLoads> record_of(Type<RunningLoads>) {
  return {"Running", "How loads of a running screw and their friction were found.", kRunning};
}

Record<LargestAtRest> record_of(Type<LargestAtRest>) {
  return {"LargestAtRest", "Threads of an interface of a screw at rest.", kLargestAtRest};
}

Record<RunningLoads::AtRest> record_of(Type<RunningLoads::AtRest>) {
  return {"AtRest", "What a running load case is at rest.", kAtRest};
}

Record<InterfaceLoads> record_of(Type<InterfaceLoads>) {
  return {
      "InterfaceLoads",
      "Threads of one interface of one roller; thread 1 is next to the loaded end of the screw.",
      kInterfaceLoads};
}

Record<NewtonIteration> record_of(Type<NewtonIteration>) {
  return {"NewtonIteration", "One linear solve of the load distribution.", kNewtonIteration};
}

Record<LoadCaseResult> record_of(Type<LoadCaseResult>) {
  return {
      "LoadCase",
      "The answer to one load case; one that did not converge has its status and residual alone.",
      kLoadCase};
}

}  // namespace prs
