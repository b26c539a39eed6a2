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
    int screw = 0;  ///< Starts of the screw and of the nut.
    int roller = 1;
  };

  Type type = Type::inverted;
  Geometry geometry = Geometry::simulation;
  ProfilePlane profile_plane = ProfilePlane::normal;
  double lead = 0.0;  ///< Lead of screw and nut [m]; > 0 right-handed.
  Starts starts;
  PerPart<std::optional<double>> pitch;           ///< Measured axial pitch [m] where it differs from the nominal one.
  PerPart<double> flank_angle;                    ///< alpha_n (or axial), against the radial plane [rad].
  PerPart<std::optional<double>> pitch_diameter;  ///< Pitch diameter [m]; `design` gives the screw's only.
  std::optional<double> centre_distance;          ///< Distance of the axes [m], `simulation` only.
  PerInterface<double> backlash;                  ///< Axial play [m], `design` only.
  PerPart<Profile> profile;
  PerPart<std::optional<ThreadHeight>> thread;
  int rollers = 0;
  int contacts_per_roller = 0;  ///< N_c at each interface.
};

/// Axial spacing of neighbouring threads of screw and nut [m].
inline double axial_pitch(const Mechanism& m) { return std::abs(m.lead) / m.starts.screw; }

/// The part that the rollers are geared to.
constexpr Part geared_part(Mechanism::Type type) { return type == Mechanism::Type::standard ? Part::nut : Part::screw; }

/// Gamma of the gears, whose teeth must mesh with every start of the threads: n_R/n_S, for any diameters.
inline double gear_ratio(const Mechanism& m) { return static_cast<double>(m.starts.roller) / m.starts.screw; }

/// Axial pitch of each part [m]: the measured one, else lead/starts. Pitches that differ by rounding only
/// (`contact::kSamePitch`) become one number.
PerPart<double> axial_pitches(const Mechanism& mechanism);

/// Threads of a mechanism as contact/ takes them; members that a design has yet to compute are 0.
contact::MechanismGeometry threads_of(const Mechanism& mechanism);

}  // namespace prs
