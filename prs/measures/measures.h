#pragma once

#include "prs/life/static_limits.h"
#include "prs/loads/result.h"
#include "prs/measures/system_stiffness.h"
#include "prs/model/case.h"

namespace prs {

/// Design measures of a mechanism that no load case changes. SI units; absent where the case does
/// not state what a measure needs. Formulas, validity and sources stand with the keys under which
/// documents show them, see prs/measures/measures_record.cpp.
struct Measures {
  // Transmission
  std::optional<double> velocity_ratio;  ///< Travel per angle of the screw against the nut [m/rad].
  std::optional<double> roller_ratio;    ///< omega_R/omega_S, nut at rest, < 0.
  std::optional<double> carrier_ratio;   ///< omega_C/omega_S, nut at rest.
  std::optional<double> efficiency;      ///< Estimate, rotation into travel.
  std::optional<double> back_driving_efficiency;  ///< Estimate, travel into rotation; absent where
                                                  ///< self-locking.
  // Stiffness of the parts between two threads, all rollers together, and of a tooth at one contact
  // [N/m]
  PerPart<std::optional<double>> section_stiffness;
  PerPart<std::optional<double>> tooth_stiffness;
  // Capacity of all contacts under equal shares
  std::optional<double> geometry_factor, element_diameter;  ///< f_c; D_c [m].
  std::optional<double> dynamic_capacity, dynamic_capacity_low, dynamic_capacity_high;  ///< [N]
  /// Catalogue value where the case states one, else the least of the next four [N].
  std::optional<double> static_capacity;
  PerInterface<std::optional<double>> deformation_capacity;  ///< By permanent deformation [N].
  PerInterface<std::optional<double>> pressure_capacity;     ///< By `kStaticPressureLimit` [N].
  /// Axial load at which an ellipse reaches a crest or root; the smaller of both interfaces [N].
  std::optional<double> flank_edge_load;
  PerInterface<std::optional<double>> interface_flank_edge_load;  ///< [N]
  // Weight and room
  std::optional<double> roller_weight, nut_weight, weight;  ///< All rollers; nut; both [kg].
  std::optional<double> screw_weight_per_length;            ///< [kg/m]
  std::optional<double> material_volume;                    ///< Material of rollers and nut [m^3].
  std::optional<double> envelope_volume;  ///< Volume of the cylinder around the nut [m^3].
  std::optional<double> force_density;    ///< C_a over the weight of rollers and nut [N/kg].
  // Inertia as seen at the part that turns, the screw of a standard mechanism and the nut of an
  // inverted one, whose other part travels [kg m^2]
  std::optional<double> roller_inertia;      ///< Rollers: spin and orbit.
  std::optional<double> travel_inertia;      ///< Mass that travels: rollers with nut or screw.
  std::optional<double> screw_inertia;       ///< Shaft over its length, about its axis.
  std::optional<double> nut_inertia;         ///< Nut about its axis.
  std::optional<double> equivalent_inertia;  ///< Sum: rollers, travel and the part that turns.
  // Shaft
  std::optional<double> shaft_stiffness;  ///< Axial; screw held at one end, whole length [N/m].
  std::optional<double> buckling_load;    ///< [N]
  /// First bending of a screw that turns, that of a standard mechanism [rad/s].
  std::optional<double> critical_speed;
};

/// Design measures under one load case, mean values being those of equal shares. SI units.
struct LoadMeasures {
  // Stiffness of all threads of the mechanism side by side under equal shares, secant [N/m]
  PerInterface<std::optional<double>> hertz_stiffness;
  /// With what the case says is in series with the mechanism, as solved at rest.
  std::optional<SystemStiffness> system_stiffness;
  std::optional<double> thread_stiffness;  ///< Both Hertz contacts and teeth in series.
  // Yang's load distribution, for comparison with that of the model; Detail::complete
  std::vector<double> yang_load_rate;  ///< Thread 1 first; empty where it is not defined.
  std::optional<double> yang_largest_load_rate;
  PerInterface<std::optional<double>> largest_load_rate;  ///< In the solved distribution.
  // Strength
  PerInterface<std::optional<double>> mean_peak_pressure;     ///< Under equal shares [Pa].
  PerInterface<std::optional<double>> largest_peak_pressure;  ///< At the most loaded thread [Pa].
  PerPart<std::optional<double>> root_shear_stress;           ///< At the most loaded thread [Pa].
  PerPart<std::optional<double>> root_bending_stress;         ///< [Pa]
  /// Static safety as `prs life` has it, see prs/life/static_limits.h, and what limits it; not of
  /// full mechanisms; Detail::complete.
  std::optional<double> solved_static_safety;
  std::optional<StaticLimit> solved_static_safety_limit;
  /// Estimates of it, and what limits them.
  std::optional<double> static_safety;         ///< With equal shares.
  std::optional<double> thread_static_safety;  ///< With the shares under this load.
  std::optional<StaticLimit> static_safety_limit, thread_static_safety_limit;
  std::optional<double> buckling_safety;  ///< Where the load compresses the screw.
  // Life under this load alone, equal shares
  std::optional<double> life;         ///< L10 [revolutions].
  std::optional<double> life_hours;   ///< At the operation's speed [h].
  std::optional<double> life_travel;  ///< [m]
  // Drive
  std::optional<double> drive_torque;  ///< By the estimate of efficiency [N m].
  /// Travel into rotation, by slip; absent where self-locking, or without friction or speed, and
  /// without Detail::complete.
  std::optional<double> back_driving_efficiency;
  std::optional<double> speed_safety;  ///< Critical over operating speed, where the screw turns.
};

/// Measures of a mechanism whose contacts are known. Reads nothing, throws nothing.
Measures measures_of(const Conditions& c, const Contacts& contacts);

/// Warnings on measures that lie outside the range the formulas were made for.
std::vector<Warning> unusual_measures(const Conditions& c, const Contacts& contacts,
                                      const Measures& measures);
/// What is unusual about a load case that converged and its measures.
std::vector<Warning> unusual_load_measures(const Conditions& c, const Measures& measures,
                                           const LoadMeasures& load_measures,
                                           const LoadCaseResult& result);

/// Measures under the solved or equal loads of one load case.
LoadMeasures load_measures_of(const Conditions& c, const Contacts& contacts,
                              const Measures& measures, const LoadCaseResult& result,
                              Detail detail = Detail::complete);

}  // namespace prs
