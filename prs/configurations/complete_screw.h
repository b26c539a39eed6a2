#pragma once

#include <map>

#include "prs/configurations/roller_spacing.h"
#include "prs/model/case.h"
#include "prs/threads/contacts.h"

namespace prs {

/// What is known of a screw before there is a case: what catalogues print, above all. SI units;
/// what is absent follows by rule.
struct ScrewData {
  Mechanism::Type type = Mechanism::Type::standard;
  double screw_diameter = 0.0;                   ///< Nominal, the pitch diameter d [m], > 0.
  double lead = 0.0;                             ///< l of screw and nut [m]; < 0 left-handed.
  std::optional<int> starts = {};                ///< n of screw and nut.
  int roller_starts = 1;                         ///< n_R
  double flank_angle = 0.25 * std::numbers::pi;  ///< Of all parts [rad].
  std::optional<double> nut_diameter = {};       ///< D, outer, of a plain cylinder [m].
  /// L [m]: of the whole nut; inverted of the tube in which the rollers travel.
  std::optional<double> nut_length = {};
  std::optional<int> rollers = {};
  std::optional<double> roller_profile_radius = {};  ///< r_B of the roller's convex flanks [m].
  std::optional<double> load = {};                   ///< Axial [N], > 0.
  std::optional<double> speed = {};                  ///< Screw against nut [rad/s], > 0.
  /// Numbers as somebody wrote them, by the names of these members: `lead` -> `1/2 in`.
  std::map<std::string, std::string> as_written = {};
};

/// A screw with nothing missing for the load distribution, and what goes with it. SI units.
struct CompleteScrew {
  ScrewData data;
  /// Mechanism (design mode, no backlash), structure and materials; without load cases.
  Case c;
  PerPart<double> pitch_diameter;
  double centre_distance = 0.0;
  int most_rollers = 0;         ///< That fit before their crests touch.
  std::vector<GearPair> gears;  ///< Most suitable first.
  double position = 0.0;        ///< Of the first contact on the nut, rollers in the middle [m].
  double load = 0.0, speed = 0.0;
};

/// Case-hardened bearing steel; density that of the catalogue in validation/standard_screws.
inline constexpr Material kSteel{210e9, 0.3, 7800.0, 11.5e-6};

/// Peak pressure of a first proposal [Pa]: 9 % of the load at which 4.0 GPa are reached.
inline constexpr double kModeratePressure = 1.8e9;
/// Greatest stress in the screw of a proposed load [Pa]: threads of slender screws share unevenly.
inline constexpr double kModerateStress = 50e6;

/// Greatest part of the load that brings an ellipse to the end of a flank with equal shares: the
/// most loaded thread of a slender screw carries twice the mean and more.
inline constexpr double kModerateEdgeShare = 0.25;

// Rules, from the 24 standard screws in validation/standard_screws. d_N is the nut's pitch
// diameter.

/// Part of the nut's length that carries threads.
inline constexpr double kThreadedShare = 0.68;
/// r_B of the roller's flanks in pitches: with it C_0 hardly depends on the lead, as makers have
/// it.
inline constexpr double kProfileRadius = 5.0;
/// Nut of D = 1.155 d_N + 5.8 mm, 0.96 to 1.03 times the printed ones, and L = 1.26 d_N + 20.5 mm,
/// 0.84 to 1.15 times: least squares of the ratios.
inline constexpr double kNutDiameterSlope = 1.155, kNutDiameterOffset = 5.8e-3;
inline constexpr double kNutLengthSlope = 1.26, kNutLengthOffset = 20.5e-3;
/// Most threads of a roller in a nut by rule, in roller diameters; the catalogue has up to 8.
inline constexpr double kSlendernessOfRollers = 15.0;
/// Toothed ends of the rollers: part of the length that the threads leave in the nut, and their
/// diameter over the roller's, so that the rollers' inertia is 0.82 to 1.18 times the printed ones.
inline constexpr double kRollerEndsShare = 0.9, kRollerEndDiameter = 0.92;
/// Friction of the flanks with which efficiencies are 0.91 to 1.05 times the printed ones.
inline constexpr double kFlankFriction = 0.1;
/// Thinnest roller of the catalogue [m], which has fewer than 5 starts only where rollers would be
/// thinner.
inline constexpr double kThinnestRoller = 4e-3;
/// Threads of an inverted screw's roller along so many screw diameters, and its nut over so many
/// lengths of these: about as in Abevi 2015.
inline constexpr double kInvertedThreads = 1.6, kInvertedNut = 3.0;
/// Part of the limit that makers set to speed times diameter.
inline constexpr double kSpeedShare = 0.5;

/// Peak pressure with equal shares beyond which a load is refused [Pa]: twice the static capacity
/// by 4.0 GPa, as makers' capacities are up to 1.5 times the computed ones.
inline constexpr double kGreatestPressure = 5.0e9;
/// Part of a maker's crest height that arcs must reach before they turn parallel to the axis.
inline constexpr double kLeastThreadHeight = 0.5;

/// Radii of screw, rollers and nut [m] from which crests are counted: d/2, d_R/2, d/2 + d_R. The
/// pitch radii without play differ from them by up to 0.04 pitches, at the screw or, inverted, the
/// nut.
PerPart<double> nominal_radii(const ScrewData& data, double roller_diameter);

/// Axial force at which equal shares reach `kModeratePressure` [N]; both contacts must be Hertz's.
double moderate_force(const Mechanism& m, const Contacts& contacts);

/// Completes a screw:
///
///     standard d_R = d/(n/n_R - 2), inverted d_R = d n_R/n,  d_N = d + 2 d_R     (1.52), (1.53)
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

/// Conductances of a screw of which only sizes are known, in still air and without a housing: a
/// first guess that is on the safe side. With h = `kStillAir` and k = `kSteelConductivity`:
///
///     nut      h times its surface but the bore
///     screw    two fins of the shaft's length beyond the nut, sqrt(h P k A) tanh(L sqrt(h P/(k
///     A))) contact  2 k sqrt(a b) for each ellipse under equal shares of the proposed load, both
///     bodies
///              half spaces (Holm, Electric Contacts, 1967; a circle of the same area)
///
/// Grease in the gaps and the motion of the contacts, which both conduct more, are left out.
Heat::Conductance estimated_conductance(const CompleteScrew& screw, double shaft_length);

}  // namespace prs
