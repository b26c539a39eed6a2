#pragma once

#include "contact/mechanism_geometry.h"
#include "prs/model/part.h"

namespace prs {

/// Thread profile of the material in its profile plane: a straight flank or a circular arc.
struct Profile {
  enum class Shape {
    straight,
    convex,
    concave,
    centred,  ///< Convex arc about a point on the part's axis, r_B = r / sin(alpha_n).
  };
  Shape shape = Shape::straight;
  double radius = 0.0;  ///< Arc radius r_B [m] where convex or concave.
};

/// Truncated thread [m]: radial heights from the pitch radius; the nut's addendum points inwards.
struct ThreadHeight {
  double addendum = 0.0;
  double dedendum = 0.0;
  std::optional<double> thickness = std::nullopt;  ///< Axial thickness at the pitch radius; half a pitch if absent.
};

/// Threads of a planetary roller screw as the designer states them. SI units, angles in radians.
struct Mechanism {
  using Type = contact::MechanismType;
  /// `simulation`: all radii and the centre distance are given; `design`: the backlash is given
  /// and radii follow (Sandu 2018, table 1.3).
  enum class Geometry { simulation, design };
  /// Plane in which flank angle and profile radius are measured: normal to the helix (Sandu) or through the axis (Yao).
  enum class ProfilePlane { normal, axial };
  struct Starts {
    int screw = 0;   ///< Starts of the screw and of the nut.
    int roller = 1;  ///< Starts of a roller; 0: grooves.
  };

  Type type = Type::inverted;
  Geometry geometry = Geometry::simulation;
  ProfilePlane profile_plane = ProfilePlane::normal;
  double lead = 0.0;  ///< Lead of screw and nut [m]; > 0 right-handed.
  Starts starts;
  PerPart<std::optional<double>> pitch;  ///< Measured axial pitch [m] where it differs from the nominal one.
  PerPart<double> flank_angle;           ///< alpha_n (or axial), against the radial plane [rad].
  /// Pitch diameter [m]; `design` gives the screw's only, and that of rollers with grooves.
  PerPart<std::optional<double>> pitch_diameter;
  std::optional<double> centre_distance;  ///< Distance of the axes [m], `simulation` only.
  PerInterface<double> backlash;          ///< Axial play [m], `design` only.
  PerPart<Profile> profile;
  PerPart<std::optional<ThreadHeight>> thread;
  int rollers = 0;
  std::optional<int> rollers_unloaded;  ///< Rollers in the recess of a recirculating screw; if absent: 1.
  int contacts_per_roller = 0;          ///< N_c at each interface.
};

/// Rollers that carry load, in equal shares.
inline int loaded_rollers(const Mechanism& m) {
  return m.rollers - m.rollers_unloaded.value_or(contact::facts_of(m.type).unloaded_rollers);
}

/// Axial spacing of neighbouring threads of screw and nut [m].
inline double axial_pitch(const Mechanism& m) { return std::abs(m.lead) / m.starts.screw; }

/// The part on which the carrier keeps its place, and to which rollers with teeth are geared; the other one turns.
constexpr Part carrier_part(Mechanism::Type type) {
  return contact::facts_of(type).carrier_on_nut ? Part::nut : Part::screw;
}

/// Gamma of the gears, whose teeth must mesh with every start of the threads: n_R/n_S, for any diameters. Rollers
/// without teeth roll off on the nut: d_R/d_N of a resolved mechanism.
inline double gear_ratio(const Mechanism& m) {
  return contact::is_grooved(m.type) ? *m.pitch_diameter.roller / *m.pitch_diameter.nut
                                     : static_cast<double>(m.starts.roller) / m.starts.screw;
}

/// Axial pitch of each part [m]: the measured one, else lead/starts. Pitches that differ by rounding only
/// (`contact::kSamePitch`) become one number.
PerPart<double> axial_pitches(const Mechanism& mechanism);

/// Threads of a mechanism as contact/ takes them; members that a design has yet to compute are 0.
contact::MechanismGeometry threads_of(const Mechanism& mechanism);

}  // namespace prs
