#pragma once

#include "prs/life/static_limits.h"
#include "prs/loads/analyze.h"
#include "prs/measures/stiffness.h"

namespace prs {

/// Nominal stresses at the root of a thread tooth, a cantilever of the root's width a under an axial load F [N] at the
/// pitch line, the height c above the root, over `width` w of thread [m]:
///
///     shear    tau = F/(a w)            mean over the root
///     bending  sigma = 6 F c/(a^2 w)    at the root's surface
///
/// as in handbooks for power screws. The radial part of the contact load, which relieves the loaded side, and the notch
/// at the root are left out; teeth of roller screws are shorter than wide (c < a), for which beams give only an order
/// of magnitude and shear governs. The theory does not give the width of thread loaded by a point contact.
struct RootStress {
  double shear = 0.0;    ///< [Pa]
  double bending = 0.0;  ///< [Pa]
};

inline RootStress root_stress(const ToothSection& tooth, double axial_load, double width) {
  const double area = tooth.root_width * width;
  return {axial_load / area, 6.0 * axial_load * tooth.height / (area * tooth.root_width)};
}

/// Design measures of a mechanism that do not depend on the load case. SI units; absent if the case does not state an
/// input. Formulas, validity and sources are listed with their keys in documents, see prs/measures/measures.yaml.
struct Measures {
  // Transmission
  std::optional<double> velocity_ratio;           ///< Travel per angle of the screw against the nut [m/rad].
  std::optional<double> roller_ratio;             ///< omega_R/omega_S, nut at rest, < 0.
  std::optional<double> carrier_ratio;            ///< omega_C/omega_S, nut at rest.
  std::optional<double> efficiency;               ///< Estimate, rotation into travel.
  std::optional<double> back_driving_efficiency;  ///< Estimate, travel into rotation; absent if self-locking.
  // Stiffness of the parts between two threads, all rollers together, and of a tooth at one contact
  // [N/m]
  PerPart<std::optional<double>> section_stiffness;
  PerPart<std::optional<double>> tooth_stiffness;
  // Capacity of all contacts under equal shares
  std::optional<double> geometry_factor, element_diameter;                              ///< f_c; D_c [m].
  std::optional<double> dynamic_capacity, dynamic_capacity_low, dynamic_capacity_high;  ///< [N]
  /// Catalogue value if the case states one, else the smallest of the capacities of both interfaces below [N].
  std::optional<double> static_capacity;
  PerInterface<std::optional<double>> deformation_capacity;  ///< Capacity by permanent deformation [N].
  PerInterface<std::optional<double>> pressure_capacity;     ///< Capacity by `kStaticPressureLimit` [N].
  /// Axial load at which an ellipse reaches a crest or root; the smaller of both interfaces [N].
  std::optional<double> flank_edge_load;
  PerInterface<std::optional<double>> interface_flank_edge_load;  ///< [N]
  // Weight and room
  std::optional<double> roller_weight, nut_weight, weight;  ///< All rollers; nut; both [kg].
  std::optional<double> screw_weight_per_length;            ///< [kg/m]
  std::optional<double> material_volume;                    ///< Material of rollers and nut [m^3].
  std::optional<double> envelope_volume;                    ///< Volume of the cylinder around the nut [m^3].
  std::optional<double> force_density;                      ///< C_a over the weight of rollers and nut [N/kg].
  // Inertia at the turning part, the screw of a standard mechanism or the nut of an inverted one, whose other part
  // travels [kg m^2]
  std::optional<double> roller_inertia;      ///< Rollers: spin and orbit.
  std::optional<double> travel_inertia;      ///< Inertia of the travelling mass: rollers with nut or screw.
  std::optional<double> screw_inertia;       ///< Inertia of the shaft over its length, about its axis.
  std::optional<double> nut_inertia;         ///< Inertia of the nut about its axis.
  std::optional<double> equivalent_inertia;  ///< Sum: rollers, travel and the turning part.
  // Shaft
  std::optional<double> shaft_stiffness;  ///< Axial stiffness; screw held at one end, whole length [N/m].
  std::optional<double> buckling_load;    ///< [N]
  /// First bending frequency of a turning screw, in a standard mechanism [rad/s].
  std::optional<double> critical_speed;
};

/// Design measures under one load case; mean values are those of equal shares. SI units.
struct LoadMeasures {
  // Stiffness of all threads of the mechanism side by side under equal shares, secant [N/m]
  PerInterface<std::optional<double>> hertz_stiffness;
  /// Stiffness with the elements in series with the mechanism, as solved at rest.
  std::optional<SystemStiffness> system_stiffness;
  std::optional<double> thread_stiffness;  ///< Stiffness of both Hertz contacts and teeth in series.
  // Yang's load distribution, for comparison with that of the model; Detail::complete
  std::vector<double> yang_load_rate;  ///< Thread 1 first; empty if it is not defined.
  std::optional<double> yang_largest_load_rate;
  PerInterface<std::optional<double>> largest_load_rate;  ///< Largest load rate in the solved distribution.
  // Strength
  PerInterface<std::optional<double>> mean_peak_pressure;     ///< Pressure under equal shares [Pa].
  PerInterface<std::optional<double>> largest_peak_pressure;  ///< Pressure at the most loaded thread [Pa].
  PerPart<std::optional<double>> root_shear_stress;           ///< Stress at the most loaded thread [Pa].
  PerPart<std::optional<double>> root_bending_stress;         ///< [Pa]
  /// Static safety as in `prs life`, see prs/life/static_limits.h, and its limit; not for full mechanisms;
  /// Detail::complete.
  std::optional<double> solved_static_safety;
  std::optional<StaticLimit> solved_static_safety_limit;
  /// Force at which the first ellipse reaches the edge of a flank, with the thread loads solved there, over this force;
  /// Detail::complete.
  std::optional<double> flank_edge_margin;
  /// Estimates of static safety, and their limits.
  std::optional<double> static_safety;         ///< Estimate with equal shares.
  std::optional<double> thread_static_safety;  ///< Estimate with the shares under this load.
  std::optional<StaticLimit> static_safety_limit, thread_static_safety_limit;
  std::optional<double> buckling_safety;  ///< Present if the load compresses the screw.
  // Modes of a full mechanism with masses, if requested
  std::optional<double> lowest_frequency;  ///< [Hz]
  std::vector<double> speeds_to_avoid;     ///< Speeds at which an order meets this frequency, ascending [rad/s].
  // Life under this load alone, equal shares
  std::optional<double> life;         ///< L10 [revolutions].
  std::optional<double> life_hours;   ///< Life at the operation's speed [h].
  std::optional<double> life_travel;  ///< [m]
  // Drive
  std::optional<double> drive_torque;  ///< Torque by the estimate of efficiency [N m].
  /// Travel into rotation, by slip; absent if self-locking, or without friction or speed, and without Detail::complete.
  std::optional<double> back_driving_efficiency;
  std::optional<double> speed_safety;  ///< Critical over operating speed, if the screw turns.
};

/// Measures of a mechanism whose contacts are known. Reads and throws nothing.
Measures measures_of(const Conditions& c, const Contacts& contacts);

/// Warnings on measures outside the range of their formulas.
std::vector<Warning> unusual_measures(const Conditions& c, const Contacts& contacts, const Measures& measures);
/// Warnings on a load case that converged and its measures.
std::vector<Warning> unusual_load_measures(const Conditions& c, const Contacts& contacts, const Measures& measures,
                                           const LoadMeasures& load_measures, const LoadCaseResult& result);

/// Measures under the solved or equal loads of one load case.
LoadMeasures load_measures_of(const Conditions& c, const Contacts& contacts, const Measures& measures,
                              const LoadCaseResult& result, Detail detail = Detail::complete);

/// All results of `analyze_measures`.
struct MeasuresResult {
  Result analysis;  ///< Contacts and thread loads from which the measures are computed.
  Measures measures;
  /// One per load case; absent if it did not converge.
  std::vector<std::optional<LoadMeasures>> load_measures;
  /// Whether the case has all inputs of `slip` and `life`, which compute quantities that are estimated here.
  bool slips = false, lives = false;
};

/// Measures from known results of a case: contacts, and solved load cases.
MeasuresResult measured(const Conditions& c, Result analysis, Detail detail);

/// The chain of `analyze`, then the design measures of the mechanism and of each load case. Reads and prints nothing.
/// The case must have passed `check_case` and the requirements of `measures`. Throws CaseError if the geometry gives no
/// contact.
MeasuresResult analyze_measures(const Conditions& c, Contacts found, AnalysisOptions options = {});
inline MeasuresResult analyze_measures(const Case& c, AnalysisOptions options = {}) {
  return analyze_measures(c, checked_contacts(c, options.detail), options);
}

/// Travel of the screw against the nut per angle [m/rad], |l|/(2 pi). Jung 2017, (8.30), has a
/// factor d_s/d_r that does not belong there (erratum).
double velocity_ratio(double lead);

/// Speeds of rollers and carrier over that of the screw, nut at rest, > 0 in the screw's sense.
struct PlanetaryRatios {
  double roller = 0.0;   ///< omega_R/omega_S
  double carrier = 0.0;  ///< omega_C/omega_S
};

/// Ratios for rollers without slip, at the gears and on the other part, all on pitch circles (Sandu 2018, (2.4) and
/// (2.21)); with matched pitch diameters
///
///     omega_C/omega_S = d_S/(2 (d_S + d_R)),   omega_R/omega_S = -d_S/(2 d_R)
///
/// Jung 2017, (2.27), is inverted and (2.9) to (2.13) are the carrier's view (errata). `gear_ratio` Gamma = |l_R/l_S| >
/// 0, below 1 for standard mechanisms. `SlipResult` has the ratio with friction.
PlanetaryRatios planetary_ratios(Mechanism::Type type, double gear_ratio);

/// Speeds against the frame over that of the turning part (`against_frame`, `turning_speed` of kinematics.h): x -> 1 -
/// x for the inverted mechanism, whose nut turns.
PlanetaryRatios ratios_to_frame(Mechanism::Type type, const PlanetaryRatios& nut_at_rest);

/// Efficiency of converting rotation to travel (Jung 2017, (8.29)), with the friction angle of one equivalent thread on
/// the screw's pitch diameter:
///
///     eta = 1/(1 + pi d_S mu/l)
///
/// `friction_coefficient` mu is that of the whole mechanism, as catalogues state it, not that of a sliding contact.
/// Valid for small mu and no preload.
double efficiency(double lead, double screw_diameter, double friction_coefficient);

/// Efficiency of converting travel to rotation, 1 - pi d_S mu/l = 2 - 1/eta, by the same argument. Absent if it is not
/// positive: the screw is self-locking. A rough estimate: if the screw itself drives at 0.77 to 0.89, it misses a
/// maker's values by -0.07 to +0.01 and those of slip by -0.06 to -0.03, as rolling and spinning contacts lose about
/// the same share of the power both ways.
std::optional<double> back_driving_efficiency(double lead, double screw_diameter, double friction_coefficient);

/// Torque [N m] that moves a load F [N] against its direction: F |l|/(2 pi eta).
double drive_torque(double force, double lead, double efficiency);

/// Inertia [kg m^2] of N_r rollers at the turning part, from their spin and their orbit:
///
///     N_r (I_R (omega_R/omega)^2 + M_R c^2 (omega_C/omega)^2)
///
/// `mass` M_R [kg] and `inertia` I_R [kg m^2] of one roller, speeds against the frame. Jung 2017, (8.33), has d_S/(2
/// d_N) in place of d_S/(2 d_R) and no orbit (erratum).
double roller_inertia(int rollers, double mass, double inertia, double centre_distance,
                      const PlanetaryRatios& to_frame);

/// Inertia [kg m^2] of a travelling mass [kg] at the turning part: M (l/(2 pi))^2, Jung 2017, (8.32) corrected
/// (erratum).
double travel_inertia(double mass, double lead);

}  // namespace prs
