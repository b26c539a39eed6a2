#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "prs/model/lateral.h"

namespace prs {

enum class Direction { tension, compression };

/// Sense of the axial load on the screw along x, which points from the loaded end into the
/// mechanism: -1 in tension, +1 in compression.
constexpr double sense(Direction d) { return d == Direction::tension ? -1.0 : 1.0; }

constexpr std::string_view name(Direction d) {
  return d == Direction::tension ? "tension" : "compression";
}

/// Whose power goes into the mechanism: force x speed x lead > 0 of a screw that drives its load.
enum class DrivenBy { screw, load };

constexpr std::string_view name(DrivenBy by) { return by == DrivenBy::screw ? "screw" : "load"; }

/// What acts on a full mechanism besides the axial force, and how its parts stand.
struct SpatialLoad {
  /// A side force [N] or a moment [N m] on the screw; at the loaded section where `at` is absent.
  struct Across {
    Lateral value;
    std::optional<double> at;  ///< x, on the nut's axis [m].

    bool operator==(const Across&) const = default;
  };
  /// A turn of the carrier by one spacing of the rollers.
  struct Orbit {
    int steps = 8;
    double exponent = 3.0;  ///< Exponent of equivalent loads.

    bool operator==(const Orbit&) const = default;
  };
  double carrier_angle = 0.0;  ///< Azimuth of the first roller, from y towards z [rad].
  Lateral eccentricity;        ///< Point of the loaded section where the axial force acts [m].
  Across side_force;
  Across moment;
  Lateral nut_tilt;    ///< Rotation of the seat of the nut [rad].
  Lateral nut_offset;  ///< Displacement of the seat of the nut [m].
  std::optional<Orbit> orbit;

  bool operator==(const SpatialLoad&) const = default;
};

/// One load on the mechanism. A range in the input has been expanded to one case per point.
struct LoadCase {
  /// How the load spreads over the threads: solved from the structure, or equal by assumption.
  enum class Share { solved, equal };

  std::string name;
  double axial_force = 0.0;  ///< [N]; > 0 with `direction`, else signed (I2J1 if < 0).
  std::optional<Direction> direction;
  std::optional<double> position;  ///< First roller contact on the nut [m].
  Share share = Share::solved;
  std::optional<double> speed;  ///< [rad/s], overrides the operation's.
  SpatialLoad spatial = {};
  std::string input_path;  ///< Path of the case in the input, e.g. `load_cases[2]`.

  bool is_solved() const { return share == Share::solved; }
};

/// Path of one of its inputs: `load_cases[2].axial_force`.
inline std::string path_in(const LoadCase& c, std::string_view key) {
  std::string path = c.input_path.empty() ? "load_cases[]" : c.input_path;
  return path.append(".").append(key);
}

/// F_N [N] of Sandu 2018: > 0 in tension (contacts I1J2), < 0 in compression (I2J1).
inline double axial_force_on_nut(const LoadCase& c) {
  return c.direction == Direction::compression ? -c.axial_force : c.axial_force;
}

}  // namespace prs
