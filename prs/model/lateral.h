#pragma once

#include <cmath>
#include <limits>

namespace prs {

/// Components across the axis. A rotation turns about y or z, from z to x and from x to y.
struct Lateral {
  double y = 0.0;
  double z = 0.0;

  bool operator==(const Lateral&) const = default;
};

/// Along the direction at the azimuth `angle`, from y towards z.
inline double along(const Lateral& l, double angle) {
  return l.y * std::cos(angle) + l.z * std::sin(angle);
}

/// Stiffness of a support that does not give.
inline constexpr double kRigid = std::numeric_limits<double>::infinity();

/// At the near and at the far end of the rollers.
template <class T>
struct PerEnd {
  T near{};
  T far{};
};

}  // namespace prs
