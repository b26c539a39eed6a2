#pragma once

#include <array>

#include "contact/contact_point.h"

namespace contact {

enum class MechanismType : std::int64_t {
  standard,       ///< The nut is geared to the rollers and matches their helix angle.
  inverted,       ///< The screw is geared to the rollers; their helix angles are opposite.
  recirculating,  ///< Rollers with grooves and without teeth; a recess leads them back by a lead per orbit.
};
inline constexpr std::array kMechanismTypes = {MechanismType::standard, MechanismType::inverted,
                                               MechanismType::recirculating};

/// Facts that distinguish a type of mechanism from the others.
struct TypeFacts {
  std::string_view name;
  std::string_view meaning;
  /// Whether the carrier keeps its place on the nut, and the screw turns; else it keeps its place on the screw, and the
  /// nut turns. Rollers with teeth are geared to that part.
  bool carrier_on_nut;
  int roller_hand;  ///< Hand of the rollers' threads over that of the screw; 0: grooves, and no teeth.
  /// Ratio of the starts of screw and roller less that of their pitch diameters, in a matched mechanism.
  int starts_over_diameters;
  int fewest_starts, most_starts;  ///< Usual starts of the screw.
  int unloaded_rollers;            ///< Usual number of rollers that carry nothing.
};

// The numbers of a row: hand of the rollers, starts over diameters, fewest and most starts, unloaded rollers.
inline constexpr TypeFacts kTypeFacts[] = {
    {"standard", "the rollers stay in place on the nut", true, 1, 2, 3, 10, 0},
    {"inverted", "the rollers stay in place on the screw", false, -1, 0, 1, 10, 0},
    {"recirculating", "rollers with grooves run along the nut, which leads them back", true, 0, 0, 1, 2, 1}};
constexpr const TypeFacts& facts_of(MechanismType type) { return kTypeFacts[static_cast<std::size_t>(type)]; }
constexpr bool is_grooved(MechanismType type) { return facts_of(type).roller_hand == 0; }
/// The type of this name, if there is one.
std::optional<MechanismType> type_named(std::string_view name);

/// The three threads of a planetary roller screw and the distance of their axes.
struct MechanismGeometry {
  MechanismType type = MechanismType::standard;
  Thread screw;
  Thread roller;
  Thread nut;                    ///< `internal`
  double centre_distance = 0.0;  ///< c [m]
};

inline ThreadPair screw_pair(const MechanismGeometry& m) {
  return {ThreadSurface(m.screw), ThreadSurface(m.roller), m.centre_distance};
}
inline ThreadPair nut_pair(const MechanismGeometry& m) {
  return {ThreadSurface(m.nut), ThreadSurface(m.roller), m.centre_distance};
}

/// Contact geometry of both interfaces.
struct MechanismContact {
  InterfaceGeometry screw;  ///< I
  InterfaceGeometry nut;    ///< J

  bool ok() const { return screw.ok() && nut.ok(); }
};

MechanismContact mechanism_contact(const MechanismGeometry& mechanism, Configuration configuration);

/// Lead of the roller [m]: pitch times starts, with the hand of the screw in a standard and the
/// opposite one in an inverted mechanism (Sandu 2018, (1.50)); 0 of grooves.
double roller_lead(MechanismType type, double screw_lead, double roller_pitch, int roller_starts);

/// Pitch radii that match helix angles, for a screw's pitch radius [m]: roller and nut in a standard mechanism (1.52),
/// roller and screw in an inverted one (1.53); the third follows from r_N = r_S + 2 r_R. A standard mechanism needs
/// more than two screw starts per roller start; otherwise the roller's radius becomes negative or infinite. Rollers
/// with grooves match any radius.
struct PitchRadii {
  double screw = 0.0;
  double roller = 0.0;
  double nut = 0.0;
};
PitchRadii matched_pitch_radii(MechanismType type, double screw_radius, int screw_starts, int roller_starts);

/// Deviations of a mechanism from rolling without sliding of its pitch cylinders and without migration of its rollers
/// (Sandu 2018, section 2.2.2).
struct KinematicConsistency {
  double lead_difference = 0.0;      ///< l_N - l_S [m]
  double gear_ratio = 0.0;           ///< Gamma by the pitch radii: r_R/r_N or r_R/r_S (2.1).
  double gear_ratio_by_leads = 0.0;  ///< |l_R/l_S|; (2.14) requires equality.
};
KinematicConsistency kinematic_consistency(const MechanismGeometry& mechanism);

/// Largest number of rollers that fit without touching each other at the crests (Sandu 2018, (1.47)); 1 if not even two
/// would.
int largest_roller_count(const MechanismGeometry& mechanism);
/// Number of rollers with this crest radius [m] that fit at equal spacing without touching.
int largest_roller_count(double crest_radius, double centre_distance);

/// Heights of the screw's and the nut's origin above the roller's [m] when the faces of one
/// configuration touch (Sandu 2018, (1.41) to (1.44)). All three parts must have the same pitch.
struct AxialPositions {
  double screw = 0.0;  ///< O_R O_S
  double nut = 0.0;    ///< O_R O_N
};
AxialPositions axial_positions(const MechanismGeometry& mechanism, const MechanismContact& contact,
                               Configuration configuration);

/// Required axial play [m], negative for preload.
struct Backlash {
  double screw = 0.0;  ///< D_zS
  double nut = 0.0;    ///< D_zN
};

enum class DesignStatus {
  ok,
  not_solved,
  pitches_differ,        ///< Backlash is undefined then.
  too_few_screw_starts,  ///< Standard: (1.52) needs n_S > 2 n_R.
  no_screw_contact,      ///< No admissible contact point there; `contact.screw.point` gives the reason.
  no_nut_contact,        ///< No admissible contact point at the nut.
  not_converged,
};

std::string_view name(DesignStatus status);

/// A mechanism designed for its backlash, and the outcome of the design, initially a failure.
struct DesignResult {
  DesignStatus status = DesignStatus::not_solved;
  MechanismGeometry mechanism;
  MechanismContact contact;  ///< Contact of I1J2; after a failure the last points.
  int iterations = 0;        ///< Number of contact points solved for.

  bool ok() const { return status == DesignStatus::ok; }
};

/// Design mode of Sandu 2018, table 1.3: from a draft whose screw has the target pitch radius, and
/// whose threads have lead, pitch and profile, finds the roller's and nut's pitch radii, the centre
/// distance and the one rectified radius that give the wanted backlash. Standard: roller and nut
/// matched (1.52), c by the nut's backlash, then the *screw's* radius rectified. Inverted: roller
/// matched to the screw (1.53), c by the screw's backlash, then the *nut's* radius rectified. Rollers with grooves have
/// the draft's radius, and c and the screw's radius follow as of a standard mechanism.
/// Newton with exact derivatives (at the minimum of the clearance, its total and its partial
/// derivative agree), to 1e-14 m; 2 to 4 steps each.
DesignResult design_by_backlash(const MechanismGeometry& draft, int screw_starts, int roller_starts,
                                const Backlash& backlash);

}  // namespace contact
