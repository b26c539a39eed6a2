#pragma once

#include <map>

#include "prs/threads/contacts.h"

namespace prs {

/// Rollers at equal spacing, 360 deg/N from one to the next.
///
/// *Which numbers mesh.* In pitches, a thread of n starts and hand h (+1 right, -1 left) has at the
/// angle phi and the height z the phase n phi/(2 pi) - h z/p. A roller at the place phi_i, turned
/// by psi_i, faces the screw with phi_i + pi and the nut with phi_i. Its crests meet the grooves of
/// a body B where, z eliminated,
///
///     n_R (phi_i - psi_i)/(2 pi) - h_R h n_B phi_i/(2 pi) = const_B   (mod 1),   B = screw, nut.
///
/// Both conditions are one and the same at every place if (n_N - n_S)/N is whole, and as the leads
/// are equal (Sandu 2018, (2.14)) n_N = n_S: every number of rollers meshes both threads. What is
/// left is the turn psi_i. Gears with z_body/z_roller = n_S/n_R, ring gear (standard) or on the
/// screw (inverted), ask for
///
///     z_R (phi_i - psi_i)/(2 pi) -+ z_body phi_i/(2 pi) = const       (mod 1),
///
/// the same turn. The condition of planetary gears with sun and ring, (z_ring + z_sun)/N whole,
/// does not arise, since each roller has one gear mesh only. It is assumed that on every roller
/// teeth and threads stand in the same relation, and at both ends.

/// Smallest number of rollers that centre the screw.
inline constexpr int kFewestRollers = 3;

/// Largest number of rollers of this outer radius whose neighbours are `gap` apart, (1.47) with r + gap/2; at most
/// 1000, and 1 if not even two would fit.
int most_rollers(double centre_distance, double outer_radius, double gap);

/// Turn of a roller in the planet carrier against its neighbour [rad], in the sense in which the
/// places are counted: psi - phi of the conditions above, from 0 to 2 pi/n_R, with which the
/// rollers' threads repeat. Standard -(n_S/n_R) 2 pi/N, inverted +(n_S/n_R) 2 pi/N.
double indexing_angle(Mechanism::Type type, Mechanism::Starts starts, int rollers);

/// Whether every roller is assembled at the same turn as seen from its place: n_S/N whole. Other numbers need marks, or
/// rollers that find their turn by rolling in from one place.
bool go_in_alike(Mechanism::Starts starts, int rollers);

/// Spur gears that keep the rollers in step, by numbers and module: pinions at the ends of the
/// rollers, in ring gears on the nut (standard) or on gears of the screw (inverted). 20 deg basic
/// rack of full depth.
struct GearPair {
  int roller_teeth = 0;  ///< z_R, a multiple k n_R of the roller's starts.
  int body_teeth = 0;    ///< z_N or z_S, k n_S: the ratio of the leads exactly.
  /// Axial way of a roller's thread, p n_R/z_R, if it goes in one tooth off its place [m].
  double tooth_misfit = 0.0;
  double module = 0.0;                  ///< m [m]
  int series = 1;                       ///< Series; 1 is preferred to 2.
  double working_pressure_angle = 0.0;  ///< alpha_w at the centre distance of the threads [rad].
  /// x_N - x_R (standard) or x_S + x_R (inverted), in modules, that brings reference gears to that centre distance; the
  /// designer chooses how to share it.
  double profile_shift = 0.0;
  int most_rollers = 0;  ///< Largest number of rollers whose threads and pinions clear each other.
};

/// Gears that fit a centre distance c [m] (Sandu 2018, (2.1) with the operating pitch radii c Gamma/(1 -+ Gamma)). With
/// the reference centre distance a = m (z_body -+ z_R)/2:
///
///     cos(alpha_w) = (a/c) cos(20 deg),
///     profile shift = (z_body -+ z_R)(inv alpha_w - inv 20 deg)/(2 tan 20 deg).
///
/// Modules of ISO 54, below 1 mm of DIN 780-1, from 0.2 to 10 mm. Pinions of 12 to 40 teeth (below 18, x_R >= 1 - z_R
/// sin(20 deg)^2/2 avoids undercut); profile shifts up to 1, half a module for either gear. `gap` [m] is kept free
/// between the tips of neighbours, m above the operating pitch circle. Strength is not checked, nor whether the teeth
/// are higher than the threads. None of rollers with grooves.
///
/// The pairs that allow most rollers come first, then those of series 1, then those of least shift, to a tenth of the
/// module, and of fewest teeth.
std::vector<GearPair> gear_pairs(const Mechanism& m, double centre_distance, double gap);

/// Data of a mechanism before it is designed. SI units.
struct ConfigurationQuery {
  double screw_diameter = 0.0;                   ///< Pitch diameter [m], > 0 without a nut's diameter.
  std::optional<double> nut_diameter = {};       ///< Outer diameter of the nut, from which the screw's follows [m].
  double lead = 0.0;                             ///< Lead [m], not 0; > 0 right-handed.
  double flank_angle = 0.25 * std::numbers::pi;  ///< alpha_n of all parts [rad].
  std::optional<Mechanism::Type> type;           ///< Absent: all types.
  std::optional<int> screw_starts;               ///< Absent: those usual for the type.
  std::optional<int> roller_starts;              ///< Absent: 1 to 3; 0 of rollers with grooves.
  std::optional<int> rollers;                    ///< Absent: as many as fit.
  double gap = 0.0;                              ///< Smallest gap between the crests of neighbouring rollers [m].
  std::optional<double> roller_profile_radius;   ///< r_BR [m]; absent: arcs about the axis.
};

/// A mechanism whose helix angles and gear ratio agree.
struct Configuration {
  /// Design mode, no backlash; straight screw and nut, convex rollers, sharp threads.
  Mechanism mechanism;
  /// Diameters that follow from the starts (Jung 2017, (2.16), (2.26); Sandu 2018, (1.52), (1.53)):
  /// d_S, d_R, d_N = d_S + 2 d_R [m].
  PerPart<double> rolling_diameter;
  /// Pitch diameters for no backlash [m]: the screw's is corrected in a standard mechanism, the
  /// nut's in an inverted one.
  PerPart<double> pitch_diameter;
  double centre_distance = 0.0;        ///< c [m], for no backlash.
  double gear_ratio = 0.0;             ///< Gamma = n_R/n_S = d_R/d_N or d_R/d_S (2.1).
  PerPart<double> lead;                ///< Lead, < 0 left-handed [m].
  PerPart<double> helix_angle;         ///< Helix angle with the sign of the lead [rad].
  int most_rollers = 0;                ///< Largest number of rollers that fit with the gap; any smaller number meshes.
  double crest_gap = 0.0;              ///< Gap between neighbours with mechanism.rollers [m].
  std::optional<double> nut_diameter;  ///< Outer diameter of the nut that the query states [m].
  double outer_diameter = 0.0;         ///< Outer diameter of the nut of the written case [m].
  double dynamic_capacity = 0.0;       ///< Lemor's C_a of the written case [N].
  double greatest_speed = 0.0;  ///< Speed of screw against nut at the makers' limit of speed times diameter [rad/s].
  double moderate_force = 0.0;  ///< Axial force for `kModeratePressure` with equal shares [N].
  std::vector<int> alike;       ///< Numbers of rollers that can all be assembled at one angle.
  std::vector<GearPair> gears;  ///< Gears, most suitable first.
};

/// Starts that give no consistent mechanism, and the reason.
struct LeftOut {
  Mechanism::Type type = Mechanism::Type::standard;
  Mechanism::Starts starts;
  std::string reason;
  std::string detail;  ///< The reason with its numbers; may be empty.
};

struct Configurations {
  std::vector<Configuration> found;  ///< By type, then by starts.
  std::vector<LeftOut> left_out;
};

/// Every combination of starts that gives a consistent mechanism: rollers no thicker than the screw, at least three of
/// them (or the requested number) with the gap between their crests, point contact at both interfaces with no backlash,
/// no warning of `prs check`, and a case that `configuration_case` can write.
Configurations configurations(const ConfigurationQuery& query);

/// Data of a screw before there is a case, mainly from catalogues. SI units; absent values follow by rule.
struct ScrewData {
  Mechanism::Type type = Mechanism::Type::standard;
  double screw_diameter = 0.0;                   ///< Nominal diameter, the pitch diameter d [m], > 0.
  double lead = 0.0;                             ///< l of screw and nut [m]; < 0 left-handed.
  std::optional<int> starts = {};                ///< n of screw and nut.
  int roller_starts = 1;                         ///< n_R; not used for rollers with grooves.
  double flank_angle = 0.25 * std::numbers::pi;  ///< Flank angle of all parts [rad].
  std::optional<double> nut_diameter = {};       ///< D, outer diameter of a plain cylinder [m].
  /// L [m] of the whole nut; for an inverted screw of the tube in which the rollers travel.
  std::optional<double> nut_length = {};
  std::optional<int> rollers = {};
  std::optional<double> roller_profile_radius = {};  ///< r_B of the roller's convex flanks [m].
  std::optional<double> roller_diameter = {};        ///< Pitch diameter of rollers with grooves [m].
  std::optional<double> load = {};                   ///< Axial load [N], > 0.
  std::optional<double> speed = {};                  ///< Speed of screw against nut [rad/s], > 0.
  /// Numbers as the user wrote them, by the names of these members: `lead` -> `1/2 in`.
  std::map<std::string, std::string> as_written = {};
};

/// A screw with all inputs of the load distribution, and related results. SI units.
struct CompleteScrew {
  ScrewData data;
  /// Mechanism (design mode, no backlash), structure and materials; without load cases.
  Case c;
  PerPart<double> pitch_diameter;
  double centre_distance = 0.0;
  int most_rollers = 0;         ///< Largest number that fits before crests touch.
  std::vector<GearPair> gears;  ///< Gears, most suitable first.
  double position = 0.0;        ///< Position of the first contact on the nut, rollers in the middle [m].
  double load = 0.0, speed = 0.0;
};

/// Case-hardened bearing steel; its density is that in the catalogue in validation/standard_screws.
inline constexpr Material kSteel{210e9, 0.3, 7800.0, 11.5e-6};

/// Peak pressure of a first proposal [Pa]: 9 % of the load at which 4.0 GPa are reached.
inline constexpr double kModeratePressure = 1.8e9;
/// Largest stress in the screw for a proposed load [Pa]: threads of slender screws share unevenly.
inline constexpr double kModerateStress = 50e6;

/// Largest share of the load that brings an ellipse to the end of a flank with equal shares: the most loaded thread of
/// a slender screw carries twice the mean and more.
inline constexpr double kModerateEdgeShare = 0.25;

/// Share of the nut's length with threads. This and the following rules are from the 24 standard screws in
/// validation/standard_screws; d_N is the nut's pitch diameter.

inline constexpr double kThreadedShare = 0.68;
/// r_B of the roller's flanks in pitches: with it C_0 hardly depends on the lead, as in makers' catalogues.
inline constexpr double kProfileRadius = 5.0;
/// Nut of D = 1.155 d_N + 5.8 mm, 0.96 to 1.03 times the printed ones, and L = 1.26 d_N + 20.5 mm,
/// 0.84 to 1.15 times: least squares of the ratios.
inline constexpr double kNutDiameterSlope = 1.155, kNutDiameterOffset = 5.8e-3;
inline constexpr double kNutLengthSlope = 1.26, kNutLengthOffset = 20.5e-3;
/// Largest length of a roller's threads in a nut by rule, in roller diameters; the catalogue has up to 8.
inline constexpr double kSlendernessOfRollers = 15.0;
/// Toothed ends of the rollers: part of the length that the threads leave in the nut, and their
/// diameter over the roller's, so that the rollers' inertia is 0.83 to 1.18 times the printed ones.
inline constexpr double kRollerEndsShare = 0.9, kRollerEndDiameter = 0.92;
/// Friction of the flanks with which efficiencies, mixed friction of the heads included, are 0.89 to 1.05 times the
/// printed ones, and equal in the mean.
inline constexpr double kFlankFriction = 0.1;
/// Heads of the rollers in the carrier, over the roller's diameter; a short bearing.
inline constexpr double kHeadLength = 0.5, kHeadDiameter = 0.6, kHeadClearance = 0.005;
/// Thinnest roller of the catalogue [m], which has fewer than 5 starts only where rollers would be
/// thinner.
inline constexpr double kThinnestRoller = 4e-3;
/// Length of an inverted screw's roller threads in screw diameters, and of its nut in such lengths: about as in Abevi
/// 2015.
inline constexpr double kInvertedThreads = 1.6, kInvertedNut = 3.0;
/// Share of the makers' limit of speed times diameter.
inline constexpr double kSpeedShare = 0.5;

/// Peak pressure with equal shares beyond which a load is refused [Pa]: twice the static capacity
/// by 4.0 GPa, as makers' capacities are up to 1.5 times the computed ones.
inline constexpr double kGreatestPressure = 5.0e9;
/// Share of a maker's crest height that arcs must reach before they become parallel to the axis.
inline constexpr double kLeastThreadHeight = 0.5;

/// Radii of screw, rollers and nut [m] from which crests are counted: d/2, d_R/2, d/2 + d_R. The pitch radii without
/// play differ from them by up to 0.04 pitches, at the screw or, for inverted screws, the nut.
PerPart<double> nominal_radii(const ScrewData& data, double roller_diameter);

/// Axial force at which equal shares reach `kModeratePressure` [N]; both contacts must be Hertz's.
double moderate_force(const Mechanism& m, const Contacts& contacts);

/// Completes a screw:
///
///     standard d_R = d/(n/n_R - 2), inverted d_R = d n_R/n,  d_N = d + 2 d_R     (1.52), (1.53)
///     rollers with grooves: d_R of a standard screw of three starts, n = 1, one of them unloaded
///     n: the largest of 5, 4, 3 whose rollers are 4 mm or thicker; p = |l|/n
///     rollers: as many as fit with half a pitch between their crests
///     contacts: over 0.68 L, inverted over 1.6 d but no more than that; in the middle of the nut
///     heights of groove.h, crests from d, d_R, d_N; flanks straight, of the rollers r_B = 5 p
///     load that gives 1.8 GPa with equal shares, no more than 50 MPa in the screw and a fourth of
///     what brings an ellipse to the end of a flank; speed half of n d = 150,000 mm/min
///
/// The nut, a plain cylinder, is held at its near end in tension, at its far one in compression.
/// Throws CaseError with the name of a member of `ScrewData` where nothing can have these numbers,
/// with the nearest that can.
CompleteScrew complete_screw(const ScrewData& data);

/// Thermal conductivity of bearing steel [W/(m K)].
inline constexpr double kSteelConductivity = 46.0;

/// Conductances of a screw of which only sizes are known, in still air and without a housing: a first guess on the safe
/// side. With h = `kStillAir` and k = `kSteelConductivity`:
///
///     nut      h times its surface without the bore
///     screw    two fins of the shaft's length beyond the nut, sqrt(h P k A) tanh(L sqrt(h P/(k A)))
///     contact  2 k sqrt(a b) for each ellipse under equal shares of the proposed load, both bodies
///              half spaces (Holm, Electric Contacts, 1967; a circle of the same area)
///
/// Grease in the gaps and the motion of the contacts, which both conduct more, are left out.
Heat::Conductance estimated_conductance(const CompleteScrew& screw, double shaft_length);

/// Lemor's capacity, which `prs life` needs [N]. Throws CaseError if the ratio of diameters is outside of it.
double required_capacity(const CompleteScrew& screw);

/// Data of the screw of a line of `prs configurations`.
ScrewData data_of(const Configuration& c);

}  // namespace prs
