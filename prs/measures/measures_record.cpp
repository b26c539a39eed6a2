#include "prs/measures/measures_analysis.h"

#include <initializer_list>

namespace prs {
namespace {

constexpr std::string_view kTransmissionGroup = "Transmission";
constexpr std::string_view kStiffnessGroup = "Stiffness";
constexpr std::string_view kCapacityGroup = "Capacity";
constexpr std::string_view kStaticGroup = "Static limits with equal shares";
constexpr std::string_view kWeightGroup = "Weight and room";
constexpr std::string_view kInertiaGroup = "Inertia at the part that turns";
constexpr std::string_view kShaftGroup = "Shaft";
constexpr std::string_view kDistributionGroup = "Load distribution";
constexpr std::string_view kStrengthGroup = "Strength";
constexpr std::string_view kLifeGroup = "Life under this load";
constexpr std::string_view kDriveGroup = "Drive";

constexpr std::string_view kRatioValidity =
    "rolling without slip by the leads, Gamma = |l_R/l_S|, formula of matched diameters; inverted: "
    "1 - x is the ratio to the nut that turns, screw at rest; with friction see `prs slip`";
constexpr std::string_view kEfficiencyEstimate =
    "estimate: Coulomb friction of one screw and nut; `prs slip` computes the efficiency from the "
    "losses of the contacts; needs measures.friction_coefficient, that of the whole mechanism as "
    "catalogues state it; no preload";
constexpr std::string_view kEfficiencyValidity =
    "needs measures.friction_coefficient; mu is that of the whole mechanism "
    "as catalogues state it; no preload";
constexpr std::string_view kBackDrivingValidity =
    "as efficiency; misses a maker's 24 screws by -0.07 to +0.01 and `slip` by -0.06 to -0.03 "
    "(lesson 10: 0.73 for 0.78), for contacts lose about the same share of the power both ways: "
    "prefer that of a load case, which is by slip";
constexpr std::string_view kSectionValidity =
    "sections of the sector model between two threads; nut between its flanges";
constexpr std::string_view kToothValidity =
    "needs measures.loaded_width w, which no theory gives; with Hertz on top part of the "
    "deflection counts twice";
constexpr std::string_view kYamamoto =
    "Yamamoto 1980 in its right form (Jung 2017, (3.4) to (3.19), misprinted)";
constexpr std::string_view kLemorFormula =
    "C_a = f_c cos(alpha)^0.86 N_c^(2/3) D_c^1.8 tan(alpha) cos(beta)^(1/3) [N, mm], "
    "3.647 D_c^1.4 beyond 25.4 mm; or "
    "life.dynamic_capacity where stated";
constexpr std::string_view kLemorValidity =
    "d_r cos(alpha)/d_n from 0.01 to 0.30; crowned flanks of 45 deg, hardened steel";
constexpr std::string_view kLemor = "Lemor, in Jung 2017, (5.5), (6.1), (8.26)";
constexpr std::string_view kRangeFormula =
    "C_a with f_c at d_r cos/(2 c) or D_c cos/(2 c), the ratio of ISO 281, and the fit's 0.35 %";
constexpr std::string_view kRangeValidity =
    "which ratio f_c takes, not an error bar: C_a is 0.69 to 1.26 times a maker's for screws from "
    "8 to "
    "120 "
    "mm (validation/standard_screws); a maker's own value goes first";
constexpr std::string_view kDeformationFormula =
    "C_0 = N_r N cos(psi) D sqrt(1e-4/(1.3e-7 kappa_1 kappa_2)) [N, mm], D twice the radius of the "
    "roller's profile: permanent deformation 1e-4 D";
constexpr std::string_view kDeformationValidity =
    "equal shares; bearing steel of 63.5 to 65.5 HRC; convex roller flank; made for grooves, "
    "allows "
    "flat flanks 5 GPa and more: compare the load at the pressure limit";
constexpr std::string_view kPalmgren =
    "Palmgren's formula (Harris, Rolling Bearing Analysis); criterion of ISO 76";
constexpr std::string_view kPressureFormula =
    "axial load at which every contact has p_0 = 4.0 GPa: N_r N cos(psi) (2 pi a' b' p_0/3)^3";
constexpr std::string_view kPressureValidity =
    "equal shares; hardened bearing steel; elastic up to there";
constexpr std::string_view kPressureSource =
    "Hertz; limit of ISO 76:2006 for roller bearings (4.2 GPa for ball bearings)";
constexpr std::string_view kStaticSource = "ISO 76; Palmgren; Hertz";
constexpr std::string_view kFlankEdgeFormula =
    "N_r N cos(psi) min(h/rho')^3, h the radial height from the contact point to a crest or root "
    "of "
    "body or roller, rho' = sqrt((a' t_1r)^2 + (b' t_2r)^2) the ellipse's radial reach under 1 N";
constexpr std::string_view kFlankEdgeValidity =
    "equal shares; ellipse of the unbounded flank; crests and roots of mechanism.thread, else "
    "where flanks meet: crests as makers cut them, 0.15 p high, bring it down to a third to a "
    "fifth";
constexpr std::string_view kFlankEdgeSource = "Hertz; geometry";
#define BODIES                                                                               \
  "bodies bounded by the pitch diameters; rollers with run-out and ends, nut with flanges; " \
  "without carrier, gears and seals"
constexpr std::string_view kBodyValidity = BODIES;
constexpr std::string_view kWeightValidity = "needs materials.density of these parts; " BODIES;
#undef BODIES
constexpr std::string_view kBodySource = "geometry; Jung 2017, (5.1) to (5.4), corrected";
constexpr std::string_view kInertiaValidity =
    "standard: the screw turns, the nut travels; inverted: the nut turns, the screw travels; "
    "without carrier and couplings";
constexpr std::string_view kInertiaSource = "Jung 2017, (8.32) to (8.34), corrected";
constexpr std::string_view kGeometry = "geometry";

constexpr std::string_view kHertzStiffnessFormula =
    "k = N_r N/(h f^(-1/3)), h = 1/(k_0^(2/3) cos(psi)^(5/3)), f = F/(N_r N)";
constexpr std::string_view kHertzStiffnessValidity =
    "secant, equal shares; roller moves axially only";
constexpr std::string_view kLoadRateFormula =
    "largest axial thread load over F/N_r, of the solved distribution";
constexpr std::string_view kMeanPressureFormula = "p_0 = 3 N/(2 pi a b) at N = f/cos(psi)";
constexpr std::string_view kLargestPressureFormula =
    "p_0 = 3 N/(2 pi a b) of the most loaded thread";
constexpr std::string_view kShearFormula = "tau = F/(a w), mean over the root a of a tooth";
constexpr std::string_view kBendingFormula = "sigma = 6 F c/(a^2 w), load at the pitch line";
constexpr std::string_view kRootValidity =
    "needs measures.loaded_width w; nominal: no notch, no radial force; teeth wider than high are "
    "hardly beams";
constexpr std::string_view kRootSource =
    "Shigley, Mechanical Engineering Design, power screws (shear there: largest, 3/2 of the mean)";

/// Larger load rate of both interfaces.
std::optional<double> largest_load_rate(const LoadMeasures& m) {
  const auto& [screw, nut] = m.largest_load_rate;
  return screw && nut ? std::optional(std::max(*screw, *nut)) : std::nullopt;
}

constexpr Quantity<SystemStiffness::Contribution> kContribution[] = {
    {.key = "stiffness_N_per_um",
     .value = of<&SystemStiffness::Contribution::stiffness>,
     .meaning = "of this part alone"},
    {.key = "percent",
     .value = of<&SystemStiffness::Contribution::share>,
     .meaning = "of the total compliance; all sum to 100",
     .unit = unit_of("share_percent")},
};

constexpr Quantity<SystemStiffness::Contributions> kContributions[] = {
    {"mechanism", of<&SystemStiffness::Contributions::mechanism>,
     "threads and bodies, the secant stiffness of the load case at rest"},
    {"shaft", of<&SystemStiffness::Contributions::shaft>, "stretch of the screw's shaft"},
    {"wind_up", of<&SystemStiffness::Contributions::wind_up>,
     "travel by which the shaft twists, without friction"},
    {"support_bearing", of<&SystemStiffness::Contributions::support_bearing>,
     "all bearings of the shaft together"},
    {"housing", of<&SystemStiffness::Contributions::housing>, "what holds the nut"},
};

constexpr Quantity<SystemStiffness> kSystemStiffness[] = {
    {"total_N_per_um", of<&SystemStiffness::total>, "of all in series"},
    {"contributions", of<&SystemStiffness::contributions>, "by what gives way"},
};

constexpr Quantity<Measures> kMeasures[] = {
    {"velocity_ratio_mm_per_rad", of<&Measures::velocity_ratio>, "|l|/(2 pi)",
     "Jung 2017, (8.30), corrected", "travel per angle", kTransmissionGroup, "always"},
    {"roller_ratio", of<&Measures::roller_ratio>, "omega_R/omega_S = -d_S/(2 d_R)",
     "Sandu 2018, (2.4), (2.21); Jung 2017, (2.13), corrected",
     "roller speed over screw speed, nut at rest", kTransmissionGroup, kRatioValidity},
    {"carrier_ratio", of<&Measures::carrier_ratio>, "omega_C/omega_S = d_S/(2 (d_S + d_R))",
     "Sandu 2018, (2.21); Jung 2017, (2.27), inverted there",
     "carrier speed over screw speed, nut at rest", kTransmissionGroup, kRatioValidity},
    {"efficiency", of<&Measures::efficiency>, "eta = 1/(1 + pi d_S mu/l)", "Jung 2017, (8.29)",
     "efficiency, rotation into travel (estimate)", kTransmissionGroup, kEfficiencyEstimate},
    {"back_driving_efficiency", of<&Measures::back_driving_efficiency>,
     "eta' = 1 - pi d_S mu/l = 2 - 1/eta; absent where self-locking",
     "friction angle of one thread, as (8.29)",
     "efficiency, travel into rotation (estimate within 0.07)", kTransmissionGroup,
     kBackDrivingValidity},
    {"section_stiffness_screw_N_per_um", of_side<&Measures::section_stiffness, Part::screw>,
     "E A_S/p, A_S = pi/4 (d_S^2 - d_bore^2)", "Jung 2017, (3.2)", "screw section over a pitch",
     kStiffnessGroup, kSectionValidity},
    {"section_stiffness_roller_N_per_um", of_side<&Measures::section_stiffness, Part::roller>,
     "N_r E A_R/(2 p), A_R = pi/4 d_R^2", "Jung 2017, (3.3)", "sections of all rollers",
     kStiffnessGroup, "two pitches as printed, without a reason; the sector model has E A_R/p"},
    {"section_stiffness_nut_N_per_um", of_side<&Measures::section_stiffness, Part::nut>,
     "E A_N/p, A_N = pi/4 (D_N^2 - d_N^2)", "Jung 2017, (3.1)", "nut section over a pitch",
     kStiffnessGroup, kSectionValidity},
    {"tooth_stiffness_screw_N_per_um", of_side<&Measures::tooth_stiffness, Part::screw>,
     "w over the sum of five deflections under 1 N/m", kYamamoto, "screw tooth at one contact",
     kStiffnessGroup, kToothValidity},
    {"tooth_stiffness_roller_N_per_um", of_side<&Measures::tooth_stiffness, Part::roller>,
     "w over the sum of five deflections under 1 N/m", kYamamoto, "roller tooth at one contact",
     kStiffnessGroup, kToothValidity},
    {"tooth_stiffness_nut_N_per_um", of_side<&Measures::tooth_stiffness, Part::nut>,
     "w over the sum of five deflections under 1 N/m", kYamamoto, "nut tooth at one contact",
     kStiffnessGroup, kToothValidity},
    {"geometry_factor", of<&Measures::geometry_factor>, "polynomial in d_r cos(alpha)/d_n",
     "Jung 2017, (6.3); ISO 281, thrust ball bearings of 45 deg", "geometry factor f_c",
     kCapacityGroup, "ratio from 0.01 to 0.30; [N, mm]"},
    {"element_diameter_mm", of<&Measures::element_diameter>, "sqrt(2.5 p sqrt(2) d_r)",
     "Lemor, in Jung 2017, (6.2), (8.27)", "diameter of the equivalent ball D_c", kCapacityGroup,
     "crowned threads of 45 deg"},
    {"dynamic_capacity_N", of<&Measures::dynamic_capacity>, kLemorFormula, kLemor,
     "dynamic capacity C_a", kCapacityGroup, kLemorValidity},
    {"dynamic_capacity_low_N", of<&Measures::dynamic_capacity_low>, kRangeFormula, "docs/life.md",
     "dynamic capacity, least by other ratios in f_c", kCapacityGroup, kRangeValidity},
    {"dynamic_capacity_high_N", of<&Measures::dynamic_capacity_high>, kRangeFormula, "docs/life.md",
     "dynamic capacity, greatest by other ratios in f_c", kCapacityGroup, kRangeValidity},
    {"static_capacity_N", of<&Measures::static_capacity>,
     "the least of the next four; or life.static_capacity where stated", "ISO 76, Palmgren, Hertz",
     "static capacity C_0", kStaticGroup,
     "equal shares; hardened bearing steel; flanks of any height, see flank_edge_load_N; as "
     "uncertain as the profile radius: a maker's hardly depends on the lead, as if r = 5 p, which "
     "gives 0.7 to 1.4 times his, an arc about the axis 0.4 to 4.7 (validation/standard_screws)"},
    {"deformation_capacity_screw_N", of_side<&Measures::deformation_capacity, Interface::screw>,
     kDeformationFormula, kPalmgren, "load at the permanent deformation, roller-screw",
     kStaticGroup, kDeformationValidity},
    {"deformation_capacity_nut_N", of_side<&Measures::deformation_capacity, Interface::nut>,
     kDeformationFormula, kPalmgren, "load at the permanent deformation, roller-nut", kStaticGroup,
     kDeformationValidity},
    {"pressure_capacity_screw_N", of_side<&Measures::pressure_capacity, Interface::screw>,
     kPressureFormula, kPressureSource, "load at the pressure limit, roller-screw", kStaticGroup,
     kPressureValidity},
    {"pressure_capacity_nut_N", of_side<&Measures::pressure_capacity, Interface::nut>,
     kPressureFormula, kPressureSource, "load at the pressure limit, roller-nut", kStaticGroup,
     kPressureValidity},
    {"flank_edge_load_N", of<&Measures::flank_edge_load>, "the smaller of both below",
     kFlankEdgeSource, "load at the edge of a flank", kStaticGroup, kFlankEdgeValidity},
    {"flank_edge_load_screw_N", of_side<&Measures::interface_flank_edge_load, Interface::screw>,
     kFlankEdgeFormula, kFlankEdgeSource, "load at the edge of a flank, roller-screw", kStaticGroup,
     kFlankEdgeValidity},
    {"flank_edge_load_nut_N", of_side<&Measures::interface_flank_edge_load, Interface::nut>,
     kFlankEdgeFormula, kFlankEdgeSource, "load at the edge of a flank, roller-nut", kStaticGroup,
     kFlankEdgeValidity},
    {"roller_weight_kg", of<&Measures::roller_weight>, "N_r rho pi/4 (d_R^2 N p + 2 d_end^2 L_end)",
     kBodySource, "weight of all rollers", kWeightGroup, kWeightValidity},
    {"nut_weight_kg", of<&Measures::nut_weight>, "rho pi/4 integral of (D(x)^2 - d_N^2) dx",
     kBodySource, "weight of the nut", kWeightGroup, kWeightValidity},
    {"weight_kg", of<&Measures::weight>, "sum of both", kBodySource, "weight of rollers and nut",
     kWeightGroup, kWeightValidity},
    {"screw_weight_kg_per_m", of<&Measures::screw_weight_per_length>, "rho pi/4 (d_S^2 - d_bore^2)",
     kGeometry, "weight of the screw per length", kWeightGroup, kWeightValidity},
    {"material_volume_cm3", of<&Measures::material_volume>,
     "pi/4 (integral of (D(x)^2 - d_N^2) dx + N_r (d_R^2 N p + 2 d_end^2 L_end))",
     "Jung 2017, (7.2), which lacks pi/4", "material of rollers and nut", kWeightGroup,
     kBodyValidity},
    {"envelope_volume_cm3", of<&Measures::envelope_volume>, "pi/4 D_max^2 L_N", kGeometry,
     "cylinder around the nut", kWeightGroup, "the nut's length, largest flange included"},
    {"force_density_kN_per_kg", of<&Measures::force_density>,
     "C_a over the weight of rollers and nut", "Jung 2017, chapter 6", "force density",
     kWeightGroup,
     "that of C_a and of the weight; the screw, whose length is the actuator's, is not counted"},
    {"roller_inertia_kg_mm2", of<&Measures::roller_inertia>,
     "N_r (I_R (omega_R/omega)^2 + M_R c^2 (omega_C/omega)^2)", kInertiaSource,
     "spin and orbit of the rollers", kInertiaGroup, kInertiaValidity},
    {"travel_inertia_kg_mm2", of<&Measures::travel_inertia>,
     "(N_r M_R + M) (l/(2 pi))^2, M the nut or, inverted, the screw over measures.shaft.length",
     kInertiaSource, "what travels", kInertiaGroup, kInertiaValidity},
    {"screw_inertia_kg_mm2", of<&Measures::screw_inertia>, "rho pi/32 (d_S^4 - d_bore^4) L",
     kGeometry, "screw about its axis", kInertiaGroup,
     "needs measures.shaft.length; threaded over all of it"},
    {"nut_inertia_kg_mm2", of<&Measures::nut_inertia>, "rho pi/32 integral of (D(x)^4 - d_N^4) dx",
     kGeometry, "nut about its axis", kInertiaGroup, kBodyValidity},
    {"equivalent_inertia_kg_mm2", of<&Measures::equivalent_inertia>,
     "rollers + what travels + the part that turns (screw; inverted: nut)",
     "Jung 2017, (8.34), corrected", "equivalent inertia", kInertiaGroup,
     "needs all densities and measures.shaft.length"},
    {"shaft_stiffness_N_per_um", of<&Measures::shaft_stiffness>,
     "E A_S/L, A_S = pi/4 (d_S^2 - d_bore^2)", kGeometry, "screw over its length, in series",
     kShaftGroup, "needs measures.shaft; held axially at one end, the nut at the other"},
    {"buckling_load_N", of<&Measures::buckling_load>,
     "pi^2 E I/(K L)^2; below lambda = sqrt(2 pi^2 E/s_y): A s_y (1 - s_y lambda^2/(4 pi^2 E))",
     "Euler; J. B. Johnson; K = 2, 1, 0.699, 0.5", "buckling load", kShaftGroup,
     "needs measures.shaft; core diameter, by default d_S - 0.5 p; straight, no safety factor; "
     "without measures.yield_strength Euler alone, too high for stocky shafts"},
    {"critical_speed_rpm", of<&Measures::critical_speed>,
     "(beta L)^2 sqrt(E I/(rho A L^4)), beta L = 1.8751, pi, 3.9266, 4.7300",
     "Euler-Bernoulli beam", "critical speed, first bending", kShaftGroup,
     "standard mechanisms, whose screw turns; needs measures.shaft and the screw's density; "
     "slender uniform beam of the core diameter; no "
     "axial load, no margin (catalogues: 80 %)"},
};

constexpr Quantity<LoadMeasures> kLoadMeasures[] = {
    {"lowest_frequency_Hz", of<&LoadMeasures::lowest_frequency>, "of the modes", "",
     "lowest natural frequency", kShaftGroup, "needs `modes` and `structure.masses`"},
    {"speeds_to_avoid_rpm", filled<&LoadMeasures::speeds_to_avoid>,
     "at which turn, carrier, rollers or their number meet the lowest frequency, screw against nut",
     "", "speeds to avoid", kShaftGroup, "needs `modes` and `structure.masses`"},
    {"hertz_stiffness_screw_N_per_um", of_side<&LoadMeasures::hertz_stiffness, Interface::screw>,
     kHertzStiffnessFormula, source::kHertz, "all roller-screw contacts, secant", kStiffnessGroup,
     kHertzStiffnessValidity},
    {"hertz_stiffness_nut_N_per_um", of_side<&LoadMeasures::hertz_stiffness, Interface::nut>,
     kHertzStiffnessFormula, source::kHertz, "all roller-nut contacts, secant", kStiffnessGroup,
     kHertzStiffnessValidity},
    {"thread_stiffness_N_per_um", of<&LoadMeasures::thread_stiffness>,
     "N_r N/((h_S + h_N) f^(-1/3) + sum 1/k_tooth), teeth of screw, nut and twice the roller where "
     "measures.loaded_width is given",
     "Jung 2017, (3.45), (3.46), without the roller's teeth there", "all threads, secant",
     kStiffnessGroup,
     "secant, equal shares; roller moves axially only; with teeth a lower bound, which may be "
     "below "
     "`solve`'s whole screw: the models of the bodies have Hertz contacts without Yamamoto's "
     "teeth, "
     "whose deflection Hertz has in part and whose nut ring each contact widens alone"},
    {"system_stiffness", of<&LoadMeasures::system_stiffness>,
     "1/k = sum 1/k_i: mechanism, secant; shaft L/(E A) or x (L - x)/(L E A); wind-up "
     "(l/(2 pi))^2 L_t/(G J); bearings; housing",
     kGeometry, "the axis with its parts in series", kStiffnessGroup,
     "needs measures.system; what it leaves out is rigid; without friction, the mechanism as "
     "solved at rest"},
    {"yang_largest_load_rate_percent", of<&LoadMeasures::yang_largest_load_rate>,
     "largest axial thread load over F/N_r", "Yang, in Jung 2017, (4.1), (8.20), corrected",
     "largest load rate after Yang", kDistributionGroup,
     "each roller tooth a ball that passes on what it takes; needs structure, position and thrust "
     "section",
     Reach::complete},
    {"largest_load_rate_screw_percent", of_side<&LoadMeasures::largest_load_rate, Interface::screw>,
     kLoadRateFormula, "load distribution of `prs solve`", "largest load rate, roller-screw",
     kDistributionGroup, "that of the model"},
    {"largest_load_rate_nut_percent", of_side<&LoadMeasures::largest_load_rate, Interface::nut>,
     kLoadRateFormula, "load distribution of `prs solve`", "largest load rate, roller-nut",
     kDistributionGroup, "that of the model"},
    {"largest_load_rate_percent", of<&largest_load_rate>, kLoadRateFormula,
     "load distribution of `prs solve`", "largest load rate of all threads", kDistributionGroup,
     "that of the model"},
    {"mean_peak_pressure_screw_MPa", of_side<&LoadMeasures::mean_peak_pressure, Interface::screw>,
     kMeanPressureFormula, source::kHertz, "peak pressure under equal shares, roller-screw",
     kStrengthGroup, "equal shares"},
    {"mean_peak_pressure_nut_MPa", of_side<&LoadMeasures::mean_peak_pressure, Interface::nut>,
     kMeanPressureFormula, source::kHertz, "peak pressure under equal shares, roller-nut",
     kStrengthGroup, "equal shares"},
    {"largest_peak_pressure_screw_MPa",
     of_side<&LoadMeasures::largest_peak_pressure, Interface::screw>, kLargestPressureFormula,
     source::kHertz, "largest peak pressure, roller-screw", kStrengthGroup,
     "that of the load distribution"},
    {"largest_peak_pressure_nut_MPa", of_side<&LoadMeasures::largest_peak_pressure, Interface::nut>,
     kLargestPressureFormula, source::kHertz, "largest peak pressure, roller-nut", kStrengthGroup,
     "that of the load distribution"},
    {"root_shear_stress_screw_MPa", of_side<&LoadMeasures::root_shear_stress, Part::screw>,
     kShearFormula, kRootSource, "shear at the root, screw", kStrengthGroup, kRootValidity},
    {"root_shear_stress_roller_MPa", of_side<&LoadMeasures::root_shear_stress, Part::roller>,
     kShearFormula, kRootSource, "shear at the root, roller", kStrengthGroup, kRootValidity},
    {"root_shear_stress_nut_MPa", of_side<&LoadMeasures::root_shear_stress, Part::nut>,
     kShearFormula, kRootSource, "shear at the root, nut", kStrengthGroup, kRootValidity},
    {"root_bending_stress_screw_MPa", of_side<&LoadMeasures::root_bending_stress, Part::screw>,
     kBendingFormula, kRootSource, "bending at the root, screw", kStrengthGroup, kRootValidity},
    {"root_bending_stress_roller_MPa", of_side<&LoadMeasures::root_bending_stress, Part::roller>,
     kBendingFormula, kRootSource, "bending at the root, roller", kStrengthGroup, kRootValidity},
    {"root_bending_stress_nut_MPa", of_side<&LoadMeasures::root_bending_stress, Part::nut>,
     kBendingFormula, kRootSource, "bending at the root, nut", kStrengthGroup, kRootValidity},
    {"solved_static_safety", of<&LoadMeasures::solved_static_safety>,
     "force at which the first thread reaches a limit, with the thread loads there, over F",
     kStaticSource, "static safety", kStrengthGroup,
     "as that of `prs life`; not of a full mechanism", Reach::complete},
    {"static_safety", of<&LoadMeasures::static_safety>,
     "the smaller of static_capacity_N and flank_edge_load_N over F", kStaticSource,
     "static safety (estimate: equal shares)", kStrengthGroup,
     "estimate of `prs life`'s static safety, force at which the first thread reaches a limit over "
     "the force; the same there with `share: equal`"},
    {"thread_static_safety", of<&LoadMeasures::thread_static_safety>,
     "the smaller of both interfaces' static limits over N_r N times the largest axial thread load",
     kStaticSource, "static safety (estimate: shares under this load)", kStrengthGroup,
     "estimate of `prs life`'s static safety, with the shares that the threads have under this "
     "load in place of those at the limit"},
    {"buckling_safety", of<&LoadMeasures::buckling_safety>, "buckling load over F",
     "Euler; J. B. Johnson", "safety against buckling", kStrengthGroup,
     "in compression; that of the buckling load"},
    {"l10_revolutions", of<&LoadMeasures::life>, "10^6 (C_a/F)^3", source::kLife,
     "life L10 (estimate: equal shares)", kLifeGroup,
     "equal shares, 90 % reliability, F up to about C_a/2; spectra: `prs life`"},
    {"l10_hours", of<&LoadMeasures::life_hours>, "L10 over the speed", source::kLife,
     "life L10 (estimate: equal shares)", kLifeGroup, "needs a speed; that of L10"},
    {"l10_travel_km", of<&LoadMeasures::life_travel>, "L10 |l|", source::kLife,
     "life L10 (estimate: equal shares)", kLifeGroup, "that of L10"},
    {"drive_torque_Nm", of<&LoadMeasures::drive_torque>, "F |l|/(2 pi eta)",
     "Jung 2017, (8.31), corrected, with (8.29)", "torque that drives against the load (estimate)",
     kDriveGroup, kEfficiencyValidity},
    {"back_driving_efficiency_by_slip", of<&LoadMeasures::back_driving_efficiency>,
     "shaft's power over that of the load that drives",
     "Sandu 2018, chapters 2 and 3, as `prs slip`", "efficiency, travel into rotation, by slip",
     kDriveGroup,
     "needs what `prs slip` needs; at the speed of the case; absent where the screw locks itself",
     Reach::complete},
    {"speed_safety", of<&LoadMeasures::speed_safety>, "critical speed over |speed|",
     "Euler-Bernoulli beam", "critical over operating speed", kDriveGroup,
     "standard mechanisms, whose screw turns; that of the critical speed"},

    {"solved_static_safety_limit", of<&LoadMeasures::solved_static_safety_limit>,
     "pressure | deformation | flank_edge | given", kStaticSource, "what limits static safety",
     kStrengthGroup, "that of solved_static_safety", Reach::complete},
    {"static_safety_limit", of<&LoadMeasures::static_safety_limit>,
     "pressure | deformation | flank_edge | given", kStaticSource,
     "what limits static safety, equal shares", kStrengthGroup, "that of static_safety"},
    {"thread_static_safety_limit", of<&LoadMeasures::thread_static_safety_limit>,
     "pressure | deformation | flank_edge | given", kStaticSource,
     "what limits static safety, most loaded thread", kStrengthGroup,
     "that of thread_static_safety"},
    {"yang_load_rate_percent", filled<&LoadMeasures::yang_load_rate>,
     "h (F_k^(2/3) - F_(k+1)^(2/3)) = what screw and nut stretch between threads k and k + 1; sum "
     "F/N_r",
     "Yang, in Jung 2017, (4.1), (8.20), corrected", "load rate of each thread after Yang",
     kDistributionGroup,
     "each roller tooth a ball that passes on what it takes: no bending, nothing along the roller; "
     "screw and nut as bars; no deviations",
     Reach::complete},
};

}  // namespace

std::vector<std::string> estimates_beside(const Computed& computed) {
  std::vector<std::string> keys;
  const auto add = [&](bool is_computed, std::initializer_list<const char*> estimates) {
    if (is_computed) keys.insert(keys.end(), estimates.begin(), estimates.end());
  };
  add(computed.slip, {"efficiency", "back_driving_efficiency", "drive_torque_Nm"});
  add(computed.life,
      {"static_capacity_N", "flank_edge_load_N", "l10_revolutions", "l10_hours", "l10_travel_km"});
  add(computed.thread_safety, {"static_safety", "static_safety_limit"});
  add(computed.static_safety,
      {"thread_static_safety", "thread_static_safety_limit", "static_capacity_N",
       "deformation_capacity_screw_N", "deformation_capacity_nut_N", "pressure_capacity_screw_N",
       "pressure_capacity_nut_N", "flank_edge_load_N", "flank_edge_load_screw_N",
       "flank_edge_load_nut_N"});
  add(computed.thread_loads, {"mean_peak_pressure_screw_MPa", "mean_peak_pressure_nut_MPa",
                              "yang_largest_load_rate_percent"});
  return keys;
}

Record<Measures> record_of(Type<Measures>) {
  return {"Measures", "Design measures of the mechanism that no load changes.", kMeasures};
}

Record<SystemStiffness::Contribution> record_of(Type<SystemStiffness::Contribution>) {
  return {"StiffnessContribution", "A part of an axis and its share of what gives way.",
          kContribution};
}

Record<SystemStiffness::Contributions> record_of(Type<SystemStiffness::Contributions>) {
  return {"StiffnessContributions", "Parts of an axis in series.", kContributions};
}

Record<SystemStiffness> record_of(Type<SystemStiffness>) {
  return {"SystemStiffness", "Axial stiffness of an axis.", kSystemStiffness};
}

Record<LoadMeasures> record_of(Type<LoadMeasures>) {
  return {"LoadMeasures", "Design measures under one load.", kLoadMeasures};
}

}  // namespace prs
