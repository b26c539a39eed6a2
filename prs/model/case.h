#pragma once

#include <algorithm>

#include "prs/model/deviations.h"
#include "prs/model/load_case.h"
#include "prs/model/model_options.h"
#include "prs/model/operation.h"
#include "prs/model/response_input.h"

namespace prs {

/// Values that replace those from the geometry, in the load distribution only.
struct ContactOverrides {
  PerInterface<std::optional<double>> hertz_constant;  ///< k_0 [N/m^1.5]
  PerInterface<std::optional<double>> normal_angle;    ///< psi, contact normal to axis [rad]
};

/// Title block of a report, and how the report shows shares of threads over the load.
struct ReportInput {
  enum class Butterfly {
    of_mean,  ///< In percent of the mean thread, tension to the right.
    of_load,  ///< In percent of the load, tension to the left (Abevi 2015, figs. 15-18).
  };
  std::optional<std::string> title, customer, author, number, revision;
  Butterfly butterfly = Butterfly::of_mean;
};

/// Contents of a case file besides the mechanism: bodies, materials, loads, operation, options. Blocks that the file
/// leaves out are empty. Functions that compute on contacts take these conditions and the complete mechanism of the
/// contacts, so that they cannot use the incomplete mechanism of the file by mistake.
struct Conditions {
  // Defined in case.cpp: inline copies of so many members cost time and size in all sources that hold a case.
  Conditions();
  Conditions(const Conditions&);
  Conditions(Conditions&&) noexcept;
  Conditions& operator=(const Conditions&);
  Conditions& operator=(Conditions&&) noexcept;
  ~Conditions();

  std::optional<Structure> structure;
  std::optional<Materials> materials;
  Deviations deviations;
  ContactOverrides contact;
  ModelOptions model;
  std::vector<LoadCase> load_cases;
  std::optional<Preload> preload;
  std::optional<Life> life;
  std::optional<MeasureOptions> measures;
  std::optional<Bearings> bearings;
  std::optional<Lubricant> lubricant;
  std::optional<Friction> friction;
  std::optional<Wear> wear;
  std::optional<Operation> operation;
  Carrier carrier;
  std::optional<PerPart<double>> roughness;  ///< Rq of the flanks, rms [m].
  std::optional<Heat> heat;
  std::optional<ResponseInput> response;
  std::optional<ReportInput> report;
};

inline bool has_butterflies_of_load(const Conditions& c) {
  return c.report && c.report->butterfly == ReportInput::Butterfly::of_load;
}

/// Whether slip, heat and life take the loads of a running screw, if friction and a speed are given.
inline bool slip_takes_running_loads(const ModelOptions& model, LoadCase::Share share) {
  return share == LoadCase::Share::solved && model.loads != ModelOptions::Loads::at_rest && model.friction();
}
/// Whether `solve` takes the loads of a running screw.
inline bool solve_takes_running_loads(const ModelOptions& model, LoadCase::Share share) {
  return share == LoadCase::Share::solved && model.loads == ModelOptions::Loads::running;
}

/// omega_s/n [rad/s] of a load case that has a speed, its own or the operation's.
inline double screw_speed(const Conditions& c, const LoadCase& load) {
  return load.speed ? *load.speed : c.operation->speed;
}

/// Whether slip, heat and life compute both flanks of a nut, or both nuts.
inline bool has_both_flanks(const Conditions& c, LoadCase::Share share) {
  return c.preload && share == LoadCase::Share::solved && !c.model.all_rollers();
}
inline bool some_load_has_both_flanks(const Conditions& c) {
  return std::ranges::any_of(c.load_cases, [&](const LoadCase& load) { return has_both_flanks(c, load.share); });
}

/// Whether `life` takes running loads: not if only `heat` gives the temperature of the oil and life ignores `heat`.
inline bool life_takes_running_loads(const Conditions& c) {
  const bool oil_is_known = !c.lubricant || has_operating_point(*c.lubricant) || c.life->takes_heat(warms(c.heat));
  return slip_takes_running_loads(c.model, c.life->share) && c.friction && c.operation && c.operation->speed != 0.0 &&
         oil_is_known;
}

/// All that a case file states.
struct Case : Conditions {
  Mechanism mechanism;  ///< Mechanism as the file states it.
};

}  // namespace prs
