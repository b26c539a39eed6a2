#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "prs/model/units.h"
#include "prs/measures/measures.h"

namespace prs {

/// A design measure as documents, tables and `--explain` show it: key with unit, shown = SI *
/// factor, and what a reader must know to trust it.
template <class Owner>
struct MeasureQuantity {
  std::string_view key;
  std::optional<double> (*value)(const Owner&);
  double factor;
  std::string_view group;  ///< Heading above neighbouring measures.
  std::string_view title;
  std::string_view formula;
  std::string_view validity;
  std::string_view source;
};

using DesignMeasure = MeasureQuantity<Measures>;
using LoadMeasure = MeasureQuantity<LoadMeasures>;

/// A design measure with one value a thread.
struct ThreadMeasure {
  std::string_view key;
  std::vector<double> LoadMeasures::*values;
  double factor;
  std::string_view title;
  std::string_view formula;
  std::string_view validity;
  std::string_view source;
};

/// A measure that is a word: which static limit an estimate of safety stands on.
struct LimitMeasure {
  std::string_view key;
  std::optional<StaticLimit> LoadMeasures::*value;
  std::string_view title;
  std::string_view formula;
  std::string_view validity;
  std::string_view source;
};

template <auto member>
std::optional<double> design_measure(const Measures& m) {
  return m.*member;
}

template <auto member, auto side>
std::optional<double> design_measure(const Measures& m) {
  return (m.*member)[side];
}

template <auto member>
std::optional<double> load_measure(const LoadMeasures& m) {
  return m.*member;
}

template <auto member, auto side>
std::optional<double> load_measure(const LoadMeasures& m) {
  return (m.*member)[side];
}

/// Of both interfaces.
inline std::optional<double> largest_load_rate(const LoadMeasures& m) {
  const auto& [screw, nut] = m.largest_load_rate;
  return screw && nut ? std::optional(std::max(*screw, *nut)) : std::nullopt;
}

namespace measure_text {

inline constexpr std::string_view kTransmission = "Transmission";
inline constexpr std::string_view kStiffness = "Stiffness";
inline constexpr std::string_view kCapacity = "Capacity";
inline constexpr std::string_view kWeight = "Weight and room";
inline constexpr std::string_view kInertia = "Inertia at the part that turns";
inline constexpr std::string_view kShaft = "Shaft";
inline constexpr std::string_view kDistribution = "Load distribution";
inline constexpr std::string_view kStrength = "Strength";
inline constexpr std::string_view kLife = "Life under this load";
inline constexpr std::string_view kDrive = "Drive";

inline constexpr std::string_view kRatioValidity =
    "rolling without slip by the leads, Gamma = |l_R/l_S|, formula of matched diameters; inverted: "
    "1 - x is the ratio to the nut that turns, screw at rest; with friction see `prs slip`";
inline constexpr std::string_view kEfficiencyEstimate =
    "estimate: Coulomb friction of one screw and nut; `prs slip` computes the efficiency from the "
    "losses of the contacts; needs measures.friction_coefficient, that of the whole mechanism as "
    "catalogues state it; no preload";
inline constexpr std::string_view kEfficiencyValidity =
    "needs measures.friction_coefficient; mu is that of the whole mechanism "
    "as catalogues state it; no preload";
inline constexpr std::string_view kBackDrivingValidity =
    "as efficiency; misses a maker's 24 screws by -0.07 to +0.01 and `slip` with the lead negated "
    "by -0.06 to -0.03 (lesson 10: 0.73 for 0.78), for contacts lose about the same share of the "
    "power both ways: prefer `slip`";
inline constexpr std::string_view kSectionValidity =
    "sections of the sector model between two threads; nut between its flanges";
inline constexpr std::string_view kToothValidity =
    "needs measures.loaded_width w, which no theory gives; with Hertz on top part of the "
    "deflection counts twice";
inline constexpr std::string_view kYamamoto =
    "Yamamoto 1980 in its right form (Jung 2017, (3.4) to (3.19), misprinted)";
inline constexpr std::string_view kLemorFormula =
    "C_a = f_c cos(alpha)^0.86 N_c^(2/3) D_c^1.8 tan(alpha) cos(beta)^(1/3) [N, mm]; or "
    "life.dynamic_capacity where stated";
inline constexpr std::string_view kLemorValidity =
    "d_r cos(alpha)/d_n from 0.01 to 0.30; crowned flanks of 45 deg, hardened steel";
inline constexpr std::string_view kLemor = "Lemor, in Jung 2017, (5.5), (6.1), (8.26)";
inline constexpr std::string_view kRangeFormula =
    "C_a with the other readings of the diameter ratio in f_c and the fit's 0.35 %";
inline constexpr std::string_view kRangeValidity =
    "how f_c is read, not an error bar: C_a is 0.69 to 1.26 times a maker's for screws from 8 to "
    "120 "
    "mm (validation/standard_screws); a maker's own value goes first";
inline constexpr std::string_view kDeformationFormula =
    "C_0 = N_r N cos(psi) D sqrt(1e-4/(1.3e-7 kappa_1 kappa_2)) [N, mm], D twice the radius of the "
    "roller's profile: permanent deformation 1e-4 D";
inline constexpr std::string_view kDeformationValidity =
    "equal shares; bearing steel of 63.5 to 65.5 HRC; convex roller flank; made for grooves, "
    "allows "
    "flat flanks 5 GPa and more: compare the load at the pressure limit";
inline constexpr std::string_view kPalmgren =
    "Palmgren's formula (Harris, Rolling Bearing Analysis); criterion of ISO 76";
inline constexpr std::string_view kPressureFormula =
    "axial load at which every contact has p_0 = 4.0 GPa: N_r N cos(psi) (2 pi a' b' p_0/3)^3";
inline constexpr std::string_view kPressureValidity =
    "equal shares; hardened bearing steel; elastic up to there";
inline constexpr std::string_view kPressureSource =
    "Hertz; limit of ISO 76:2006 for roller bearings (4.2 GPa for ball bearings)";
inline constexpr std::string_view kStaticSource = "ISO 76; Palmgren; Hertz";
inline constexpr std::string_view kFlankEdgeFormula =
    "N_r N cos(psi) min(h/rho')^3, h the radial height from the contact point to a crest or root "
    "of "
    "body or roller, rho' = sqrt((a' t_1r)^2 + (b' t_2r)^2) the ellipse's radial reach under 1 N";
inline constexpr std::string_view kFlankEdgeValidity =
    "equal shares; ellipse of the unbounded flank; crests and roots of mechanism.thread, else "
    "where flanks meet: crests as makers cut them, 0.15 p high, bring it down to about a fifth";
inline constexpr std::string_view kFlankEdgeSource = "Hertz; geometry";
inline constexpr std::string_view kBodyValidity =
    "bodies bounded by the pitch diameters; rollers with run-out and ends, nut with flanges; "
    "without carrier, gears and seals";
inline constexpr std::string_view kBodySource = "geometry; Jung 2017, (5.1) to (5.4), corrected";
inline constexpr std::string_view kInertiaValidity =
    "standard: the screw turns, the nut travels; inverted: the nut turns, the screw travels; "
    "without carrier and couplings";
inline constexpr std::string_view kInertiaSource = "Jung 2017, (8.32) to (8.34), corrected";
inline constexpr std::string_view kGeometry = "geometry";

inline constexpr std::string_view kHertzStiffnessFormula =
    "k = N_r N/(h f^(-1/3)), h = 1/(k_0^(2/3) cos(psi)^(5/3)), f = F/(N_r N)";
inline constexpr std::string_view kHertzStiffnessValidity =
    "secant, equal shares; roller moves axially only";
inline constexpr std::string_view kLoadRateFormula =
    "largest axial thread load over F/N_r, of the solved distribution";
inline constexpr std::string_view kMeanPressureFormula = "p_0 = 3 N/(2 pi a b) at N = f/cos(psi)";
inline constexpr std::string_view kLargestPressureFormula =
    "p_0 = 3 N/(2 pi a b) of the most loaded thread";
inline constexpr std::string_view kHertz = "Hertz with exact ellipticity";
inline constexpr std::string_view kShearFormula = "tau = F/(a w), mean over the root a of a tooth";
inline constexpr std::string_view kBendingFormula = "sigma = 6 F c/(a^2 w), load at the pitch line";
inline constexpr std::string_view kRootValidity =
    "needs measures.loaded_width w; nominal: no notch, no radial force; teeth wider than high are "
    "hardly beams";
inline constexpr std::string_view kRootSource =
    "Shigley, Mechanical Engineering Design, power screws (shear there: largest, 3/2 of the mean)";

}  // namespace measure_text

inline constexpr DesignMeasure kDesignMeasures[] = {
    {"velocity_ratio_mm_per_rad", design_measure<&Measures::velocity_ratio>, per_si::millimetre,
     measure_text::kTransmission, "travel per angle", "|l|/(2 pi)", "always",
     "Jung 2017, (8.30), corrected"},
    {"roller_ratio", design_measure<&Measures::roller_ratio>, 1.0, measure_text::kTransmission,
     "roller speed over screw speed, nut at rest", "omega_R/omega_S = -d_S/(2 d_R)",
     measure_text::kRatioValidity, "Sandu 2018, (2.4), (2.21); Jung 2017, (2.13), corrected"},
    {"carrier_ratio", design_measure<&Measures::carrier_ratio>, 1.0, measure_text::kTransmission,
     "carrier speed over screw speed, nut at rest", "omega_C/omega_S = d_S/(2 (d_S + d_R))",
     measure_text::kRatioValidity, "Sandu 2018, (2.21); Jung 2017, (2.27), inverted there"},
    {"efficiency", design_measure<&Measures::efficiency>, 1.0, measure_text::kTransmission,
     "efficiency, rotation into travel (estimate)", "eta = 1/(1 + pi d_S mu/l)",
     measure_text::kEfficiencyEstimate, "Jung 2017, (8.29)"},
    {"back_driving_efficiency", design_measure<&Measures::back_driving_efficiency>, 1.0,
     measure_text::kTransmission, "efficiency, travel into rotation (estimate, up to 0.07 off)",
     "eta' = 1 - pi d_S mu/l = 2 - 1/eta; absent where self-locking",
     measure_text::kBackDrivingValidity, "friction angle of one thread, as (8.29)"},

    {"section_stiffness_screw_N_per_um", design_measure<&Measures::section_stiffness, Part::screw>,
     per_si::newton_per_micrometre, measure_text::kStiffness, "screw section over a pitch",
     "E A_S/p, A_S = pi/4 (d_S^2 - d_bore^2)", measure_text::kSectionValidity, "Jung 2017, (3.2)"},
    {"section_stiffness_roller_N_per_um",
     design_measure<&Measures::section_stiffness, Part::roller>, per_si::newton_per_micrometre,
     measure_text::kStiffness, "sections of all rollers", "N_r E A_R/(2 p), A_R = pi/4 d_R^2",
     "two pitches as printed, without a reason; the sector model has E A_R/p", "Jung 2017, (3.3)"},
    {"section_stiffness_nut_N_per_um", design_measure<&Measures::section_stiffness, Part::nut>,
     per_si::newton_per_micrometre, measure_text::kStiffness, "nut section over a pitch",
     "E A_N/p, A_N = pi/4 (D_N^2 - d_N^2)", measure_text::kSectionValidity, "Jung 2017, (3.1)"},
    {"tooth_stiffness_screw_N_per_um", design_measure<&Measures::tooth_stiffness, Part::screw>,
     per_si::newton_per_micrometre, measure_text::kStiffness, "screw tooth at one contact",
     "w over the sum of five deflections under 1 N/m", measure_text::kToothValidity,
     measure_text::kYamamoto},
    {"tooth_stiffness_roller_N_per_um", design_measure<&Measures::tooth_stiffness, Part::roller>,
     per_si::newton_per_micrometre, measure_text::kStiffness, "roller tooth at one contact",
     "w over the sum of five deflections under 1 N/m", measure_text::kToothValidity,
     measure_text::kYamamoto},
    {"tooth_stiffness_nut_N_per_um", design_measure<&Measures::tooth_stiffness, Part::nut>,
     per_si::newton_per_micrometre, measure_text::kStiffness, "nut tooth at one contact",
     "w over the sum of five deflections under 1 N/m", measure_text::kToothValidity,
     measure_text::kYamamoto},

    {"geometry_factor", design_measure<&Measures::geometry_factor>, 1.0, measure_text::kCapacity,
     "geometry factor f_c", "polynomial in d_r cos(alpha)/d_n", "ratio from 0.01 to 0.30; [N, mm]",
     "Jung 2017, (6.3); ISO 281, thrust ball bearings of 45 deg"},
    {"element_diameter_mm", design_measure<&Measures::element_diameter>, per_si::millimetre,
     measure_text::kCapacity, "diameter of the equivalent ball D_c", "sqrt(2.5 p sqrt(2) d_r)",
     "crowned threads of 45 deg", "Lemor, in Jung 2017, (6.2), (8.27)"},
    {"dynamic_capacity_N", design_measure<&Measures::dynamic_capacity>, 1.0,
     measure_text::kCapacity, "dynamic capacity C_a", measure_text::kLemorFormula,
     measure_text::kLemorValidity, measure_text::kLemor},
    {"dynamic_capacity_low_N", design_measure<&Measures::dynamic_capacity_low>, 1.0,
     measure_text::kCapacity, "dynamic capacity, least reading of f_c", measure_text::kRangeFormula,
     measure_text::kRangeValidity, "docs/life.md"},
    {"dynamic_capacity_high_N", design_measure<&Measures::dynamic_capacity_high>, 1.0,
     measure_text::kCapacity, "dynamic capacity, greatest reading of f_c",
     measure_text::kRangeFormula, measure_text::kRangeValidity, "docs/life.md"},
    {"static_capacity_N", design_measure<&Measures::static_capacity>, 1.0, measure_text::kCapacity,
     "static capacity C_0", "the least of the next four; or life.static_capacity where stated",
     "equal shares; hardened bearing steel; flanks of any height, see flank_edge_load_N; as "
     "uncertain as the profile radius: a maker's hardly depends on the lead, as if r = 5 p, which "
     "gives 0.7 to 1.4 times his, an arc about the axis 0.4 to 4.7 (validation/standard_screws)",
     "ISO 76, Palmgren, Hertz"},
    {"deformation_capacity_screw_N",
     design_measure<&Measures::deformation_capacity, Interface::screw>, 1.0,
     measure_text::kCapacity, "load at the permanent deformation, roller-screw",
     measure_text::kDeformationFormula, measure_text::kDeformationValidity,
     measure_text::kPalmgren},
    {"deformation_capacity_nut_N", design_measure<&Measures::deformation_capacity, Interface::nut>,
     1.0, measure_text::kCapacity, "load at the permanent deformation, roller-nut",
     measure_text::kDeformationFormula, measure_text::kDeformationValidity,
     measure_text::kPalmgren},
    {"pressure_capacity_screw_N", design_measure<&Measures::pressure_capacity, Interface::screw>,
     1.0, measure_text::kCapacity, "load at the pressure limit, roller-screw",
     measure_text::kPressureFormula, measure_text::kPressureValidity,
     measure_text::kPressureSource},
    {"pressure_capacity_nut_N", design_measure<&Measures::pressure_capacity, Interface::nut>, 1.0,
     measure_text::kCapacity, "load at the pressure limit, roller-nut",
     measure_text::kPressureFormula, measure_text::kPressureValidity,
     measure_text::kPressureSource},
    {"flank_edge_load_N", design_measure<&Measures::flank_edge_load>, 1.0, measure_text::kCapacity,
     "load at the edge of a flank", "the smaller of both below", measure_text::kFlankEdgeValidity,
     measure_text::kFlankEdgeSource},
    {"flank_edge_load_screw_N",
     design_measure<&Measures::interface_flank_edge_load, Interface::screw>, 1.0,
     measure_text::kCapacity, "load at the edge of a flank, roller-screw",
     measure_text::kFlankEdgeFormula, measure_text::kFlankEdgeValidity,
     measure_text::kFlankEdgeSource},
    {"flank_edge_load_nut_N", design_measure<&Measures::interface_flank_edge_load, Interface::nut>,
     1.0, measure_text::kCapacity, "load at the edge of a flank, roller-nut",
     measure_text::kFlankEdgeFormula, measure_text::kFlankEdgeValidity,
     measure_text::kFlankEdgeSource},

    {"roller_weight_kg", design_measure<&Measures::roller_weight>, 1.0, measure_text::kWeight,
     "weight of all rollers", "N_r rho pi/4 (d_R^2 N p + 2 d_end^2 L_end)",
     measure_text::kBodyValidity, measure_text::kBodySource},
    {"nut_weight_kg", design_measure<&Measures::nut_weight>, 1.0, measure_text::kWeight,
     "weight of the nut", "rho pi/4 integral of (D(x)^2 - d_N^2) dx", measure_text::kBodyValidity,
     measure_text::kBodySource},
    {"weight_kg", design_measure<&Measures::weight>, 1.0, measure_text::kWeight,
     "weight of rollers and nut", "sum of both", measure_text::kBodyValidity,
     measure_text::kBodySource},
    {"screw_weight_kg_per_m", design_measure<&Measures::screw_weight_per_length>, 1.0,
     measure_text::kWeight, "weight of the screw per metre", "rho pi/4 (d_S^2 - d_bore^2)",
     measure_text::kBodyValidity, measure_text::kGeometry},
    {"material_volume_cm3", design_measure<&Measures::material_volume>, per_si::cubic_centimetre,
     measure_text::kWeight, "material of rollers and nut",
     "pi/4 (integral of (D(x)^2 - d_N^2) dx + N_r (d_R^2 N p + 2 d_end^2 L_end))",
     measure_text::kBodyValidity, "Jung 2017, (7.2), which lacks pi/4"},
    {"envelope_volume_cm3", design_measure<&Measures::envelope_volume>, per_si::cubic_centimetre,
     measure_text::kWeight, "cylinder around the nut", "pi/4 D_max^2 L_N",
     "the nut's length, largest flange included", measure_text::kGeometry},
    {"force_density_kN_per_kg", design_measure<&Measures::force_density>, per_si::kilonewton,
     measure_text::kWeight, "force density", "C_a over the weight of rollers and nut",
     "that of C_a and of the weight; the screw, whose length is the actuator's, is not counted",
     "Jung 2017, chapter 6"},

    {"roller_inertia_kg_mm2", design_measure<&Measures::roller_inertia>, per_si::square_millimetre,
     measure_text::kInertia, "spin and orbit of the rollers",
     "N_r (I_R (omega_R/omega)^2 + M_R c^2 (omega_C/omega)^2)", measure_text::kInertiaValidity,
     measure_text::kInertiaSource},
    {"travel_inertia_kg_mm2", design_measure<&Measures::travel_inertia>, per_si::square_millimetre,
     measure_text::kInertia, "what travels",
     "(N_r M_R + M) (l/(2 pi))^2, M the nut or, inverted, the screw over measures.shaft.length",
     measure_text::kInertiaValidity, measure_text::kInertiaSource},
    {"screw_inertia_kg_mm2", design_measure<&Measures::screw_inertia>, per_si::square_millimetre,
     measure_text::kInertia, "screw about its axis", "rho pi/32 (d_S^4 - d_bore^4) L",
     "needs measures.shaft.length; threaded over all of it", measure_text::kGeometry},
    {"nut_inertia_kg_mm2", design_measure<&Measures::nut_inertia>, per_si::square_millimetre,
     measure_text::kInertia, "nut about its axis", "rho pi/32 integral of (D(x)^4 - d_N^4) dx",
     measure_text::kBodyValidity, measure_text::kGeometry},
    {"equivalent_inertia_kg_mm2", design_measure<&Measures::equivalent_inertia>,
     per_si::square_millimetre, measure_text::kInertia, "equivalent inertia",
     "rollers + what travels + the part that turns (screw; inverted: nut)",
     "needs all densities and measures.shaft.length", "Jung 2017, (8.34), corrected"},

    {"shaft_stiffness_N_per_um", design_measure<&Measures::shaft_stiffness>,
     per_si::newton_per_micrometre, measure_text::kShaft, "screw over its length, in series",
     "E A_S/L, A_S = pi/4 (d_S^2 - d_bore^2)",
     "needs measures.shaft; held axially at one end, the nut at the other",
     measure_text::kGeometry},
    {"buckling_load_N", design_measure<&Measures::buckling_load>, 1.0, measure_text::kShaft,
     "buckling load",
     "pi^2 E I/(K L)^2; below lambda = sqrt(2 pi^2 E/s_y): A s_y (1 - s_y lambda^2/(4 pi^2 E))",
     "needs measures.shaft; core diameter, by default d_S - 0.5 p; straight, no safety factor; "
     "without measures.yield_strength Euler alone, too high for stocky shafts",
     "Euler; J. B. Johnson; K = 2, 1, 0.699, 0.5"},
    {"critical_speed_rpm", design_measure<&Measures::critical_speed>, per_si::revolution_per_minute,
     measure_text::kShaft, "critical speed, first bending",
     "(beta L)^2 sqrt(E I/(rho A L^4)), beta L = 1.8751, pi, 3.9266, 4.7300",
     "standard mechanisms, whose screw turns; needs measures.shaft and the screw's density; "
     "slender uniform beam of the core diameter; no "
     "axial load, no margin (catalogues: 80 %)",
     "Euler-Bernoulli beam"},
};

inline constexpr LoadMeasure kLoadMeasures[] = {
    {"hertz_stiffness_screw_N_per_um",
     load_measure<&LoadMeasures::hertz_stiffness, Interface::screw>, per_si::newton_per_micrometre,
     measure_text::kStiffness, "all roller-screw contacts, secant",
     measure_text::kHertzStiffnessFormula, measure_text::kHertzStiffnessValidity,
     measure_text::kHertz},
    {"hertz_stiffness_nut_N_per_um", load_measure<&LoadMeasures::hertz_stiffness, Interface::nut>,
     per_si::newton_per_micrometre, measure_text::kStiffness, "all roller-nut contacts, secant",
     measure_text::kHertzStiffnessFormula, measure_text::kHertzStiffnessValidity,
     measure_text::kHertz},
    {"thread_stiffness_N_per_um", load_measure<&LoadMeasures::thread_stiffness>,
     per_si::newton_per_micrometre, measure_text::kStiffness, "all threads, secant",
     "N_r N/((h_S + h_N) f^(-1/3) + sum 1/k_tooth), teeth of screw, nut and twice the roller where "
     "measures.loaded_width is given",
     "secant, equal shares; roller moves axially only; with teeth a lower bound, which may be "
     "below "
     "`solve`'s whole screw: the models of the bodies have Hertz contacts without Yamamoto's "
     "teeth, "
     "whose deflection Hertz has in part and whose nut ring each contact widens alone",
     "Jung 2017, (3.45), (3.46), without the roller's teeth there"},

    {"yang_largest_load_rate_percent", load_measure<&LoadMeasures::yang_largest_load_rate>,
     per_si::percent, measure_text::kDistribution, "largest load rate after Yang",
     "largest axial thread load over F/N_r",
     "each roller tooth a ball that passes on what it takes; needs structure, position and thrust "
     "section",
     "Yang, in Jung 2017, (4.1), (8.20), corrected"},
    {"largest_load_rate_screw_percent",
     load_measure<&LoadMeasures::largest_load_rate, Interface::screw>, per_si::percent,
     measure_text::kDistribution, "largest load rate, roller-screw", measure_text::kLoadRateFormula,
     "that of the model", "load distribution of `prs solve`"},
    {"largest_load_rate_nut_percent",
     load_measure<&LoadMeasures::largest_load_rate, Interface::nut>, per_si::percent,
     measure_text::kDistribution, "largest load rate, roller-nut", measure_text::kLoadRateFormula,
     "that of the model", "load distribution of `prs solve`"},
    {"largest_load_rate_percent", largest_load_rate, per_si::percent, measure_text::kDistribution,
     "largest load rate of all threads", measure_text::kLoadRateFormula, "that of the model",
     "load distribution of `prs solve`"},

    {"mean_peak_pressure_screw_MPa",
     load_measure<&LoadMeasures::mean_peak_pressure, Interface::screw>, per_si::megapascal,
     measure_text::kStrength, "peak pressure under equal shares, roller-screw",
     measure_text::kMeanPressureFormula, "equal shares", measure_text::kHertz},
    {"mean_peak_pressure_nut_MPa", load_measure<&LoadMeasures::mean_peak_pressure, Interface::nut>,
     per_si::megapascal, measure_text::kStrength, "peak pressure under equal shares, roller-nut",
     measure_text::kMeanPressureFormula, "equal shares", measure_text::kHertz},
    {"largest_peak_pressure_screw_MPa",
     load_measure<&LoadMeasures::largest_peak_pressure, Interface::screw>, per_si::megapascal,
     measure_text::kStrength, "largest peak pressure, roller-screw",
     measure_text::kLargestPressureFormula, "that of the load distribution", measure_text::kHertz},
    {"largest_peak_pressure_nut_MPa",
     load_measure<&LoadMeasures::largest_peak_pressure, Interface::nut>, per_si::megapascal,
     measure_text::kStrength, "largest peak pressure, roller-nut",
     measure_text::kLargestPressureFormula, "that of the load distribution", measure_text::kHertz},
    {"root_shear_stress_screw_MPa", load_measure<&LoadMeasures::root_shear_stress, Part::screw>,
     per_si::megapascal, measure_text::kStrength, "shear at the root, screw",
     measure_text::kShearFormula, measure_text::kRootValidity, measure_text::kRootSource},
    {"root_shear_stress_roller_MPa", load_measure<&LoadMeasures::root_shear_stress, Part::roller>,
     per_si::megapascal, measure_text::kStrength, "shear at the root, roller",
     measure_text::kShearFormula, measure_text::kRootValidity, measure_text::kRootSource},
    {"root_shear_stress_nut_MPa", load_measure<&LoadMeasures::root_shear_stress, Part::nut>,
     per_si::megapascal, measure_text::kStrength, "shear at the root, nut",
     measure_text::kShearFormula, measure_text::kRootValidity, measure_text::kRootSource},
    {"root_bending_stress_screw_MPa", load_measure<&LoadMeasures::root_bending_stress, Part::screw>,
     per_si::megapascal, measure_text::kStrength, "bending at the root, screw",
     measure_text::kBendingFormula, measure_text::kRootValidity, measure_text::kRootSource},
    {"root_bending_stress_roller_MPa",
     load_measure<&LoadMeasures::root_bending_stress, Part::roller>, per_si::megapascal,
     measure_text::kStrength, "bending at the root, roller", measure_text::kBendingFormula,
     measure_text::kRootValidity, measure_text::kRootSource},
    {"root_bending_stress_nut_MPa", load_measure<&LoadMeasures::root_bending_stress, Part::nut>,
     per_si::megapascal, measure_text::kStrength, "bending at the root, nut",
     measure_text::kBendingFormula, measure_text::kRootValidity, measure_text::kRootSource},
    {"static_safety", load_measure<&LoadMeasures::static_safety>, 1.0, measure_text::kStrength,
     "static safety (estimate: equal shares)",
     "the smaller of static_capacity_N and flank_edge_load_N over F",
     "estimate of `prs life`'s static safety, force at which the first thread reaches a limit over "
     "the force; the same there with `share: equal`",
     measure_text::kStaticSource},
    {"thread_static_safety", load_measure<&LoadMeasures::thread_static_safety>, 1.0,
     measure_text::kStrength, "static safety (estimate: shares under this load)",
     "the smaller of both interfaces' static limits over N_r N times the largest axial thread load",
     "estimate of `prs life`'s static safety, with the shares that the threads have under this "
     "load in place of those at the limit",
     measure_text::kStaticSource},
    {"buckling_safety", load_measure<&LoadMeasures::buckling_safety>, 1.0, measure_text::kStrength,
     "safety against buckling", "buckling load over F", "in compression; that of the buckling load",
     "Euler; J. B. Johnson"},

    {"l10_revolutions", load_measure<&LoadMeasures::life>, 1.0, measure_text::kLife, "life L10",
     "10^6 (C_a/F)^3", "equal shares, 90 % reliability, F up to about C_a/2; spectra: `prs life`",
     "Jung 2017, (8.25); ISO 281"},
    {"l10_hours", load_measure<&LoadMeasures::life_hours>, 1.0, measure_text::kLife, "life L10",
     "L10 over the speed", "needs a speed; that of L10", "Jung 2017, (8.25); ISO 281"},
    {"l10_travel_km", load_measure<&LoadMeasures::life_travel>, per_si::kilometre,
     measure_text::kLife, "life L10", "L10 |l|", "that of L10", "Jung 2017, (8.25); ISO 281"},

    {"drive_torque_Nm", load_measure<&LoadMeasures::drive_torque>, 1.0, measure_text::kDrive,
     "torque that drives against the load (estimate)", "F |l|/(2 pi eta)",
     measure_text::kEfficiencyValidity, "Jung 2017, (8.31), corrected, with (8.29)"},
    {"speed_safety", load_measure<&LoadMeasures::speed_safety>, 1.0, measure_text::kDrive,
     "critical over operating speed", "critical speed over |speed|",
     "standard mechanisms, whose screw turns; that of the critical speed", "Euler-Bernoulli beam"},
};

inline constexpr LimitMeasure kLimitMeasures[] = {
    {"static_safety_limit", &LoadMeasures::static_safety_limit, "what limits static safety",
     "pressure | deformation | flank_edge | given", "that of static_safety",
     measure_text::kStaticSource},
    {"thread_static_safety_limit", &LoadMeasures::thread_static_safety_limit,
     "what limits static safety, most loaded thread", "pressure | deformation | flank_edge | given",
     "that of thread_static_safety", measure_text::kStaticSource},
};

inline constexpr ThreadMeasure kThreadMeasures[] = {
    {"yang_load_rate_percent", &LoadMeasures::yang_load_rate, per_si::percent,
     "load rate of each thread after Yang",
     "h (F_k^(2/3) - F_(k+1)^(2/3)) = what screw and nut stretch between threads k and k + 1; sum "
     "F/N_r",
     "each roller tooth a ball that passes on what it takes: no bending, nothing along the roller; "
     "screw and nut as bars; no deviations",
     "Yang, in Jung 2017, (4.1), (8.20), corrected"},
};

}  // namespace prs
