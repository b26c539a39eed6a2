#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace prs {

enum class Direction { tension, compression };

/// Sense of the axial load on the screw along x, which points from the loaded end into the
/// mechanism: -1 in tension, +1 in compression.
constexpr double sense(Direction d) { return d == Direction::tension ? -1.0 : 1.0; }

constexpr std::string_view name(Direction d) {
  return d == Direction::tension ? "tension" : "compression";
}

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
  std::string input_path;       ///< Where the case stands in the input, e.g. `load_cases[2]`.
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
