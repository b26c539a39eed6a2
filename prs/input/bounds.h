#pragma once

#include <limits>

namespace prs::input {

/// Interval of admissible values, SI.
struct Bounds {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  bool least_excluded = false;
  bool greatest_excluded = false;
  bool zero_excluded = false;

  constexpr bool contain(double v) const {
    return (least_excluded ? v > least : v >= least) &&
           (greatest_excluded ? v < greatest : v <= greatest) && !(zero_excluded && v == 0.0);
  }
};

inline constexpr Bounds unbounded{};
inline constexpr Bounds positive{.least = 0.0, .least_excluded = true};
inline constexpr Bounds not_negative{.least = 0.0};
inline constexpr Bounds not_zero{.zero_excluded = true};

/// Both ends excluded.
constexpr Bounds between(double least, double greatest) {
  return {least, greatest, true, true, false};
}

/// Bytes of a line of text.
inline constexpr int kLongestText = 100;

}  // namespace prs::input
