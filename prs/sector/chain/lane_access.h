#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "fe/lanes.h"

namespace prs {

using fe::abs, fe::any, fe::max, fe::min, fe::select;  // of single numbers, beside those of batches

/// Numbers side by side in a batch.
template <class Real>
inline constexpr std::size_t kLanes = sizeof(Real) / sizeof(double);

/// values[0], values[1], ..
template <class Real>
[[gnu::always_inline]] inline Real from_lanes(const double* values) {
  Real x;
  std::memcpy(&x, values, sizeof x);
  return x;
}

template <class Real>
[[gnu::always_inline]] inline void to_lanes(const Real& x, double* values) {
  std::memcpy(values, &x, sizeof x);
}

template <class Real>
[[gnu::always_inline]] inline double lane(const Real& x, std::size_t l) {
  double value;
  std::memcpy(&value, reinterpret_cast<const char*>(&x) + l * sizeof value, sizeof value);
  return value;
}

/// A batch of solves, one per lane, from `first` on of `size` solves whose numbers stand in arrays.
/// Lanes beyond the end repeat the last solve and deliver nothing.
struct LaneRange {
  std::size_t first = 0;
  std::size_t size = 0;

  /// Number `offset` of each solve, `stride` numbers a solve; zeros from an empty array.
  template <class Real>
  [[gnu::always_inline]] Real load(std::span<const double> values, std::size_t stride = 1,
                                   std::size_t offset = 0) const {
    if (values.empty()) return Real(0.0);
    if (stride == 1 && first + kLanes<Real> <= size)
      return from_lanes<Real>(values.data() + first + offset);
    double lanes[kLanes<Real>];
    for (std::size_t l = 0; l < kLanes<Real>; ++l)
      lanes[l] = values[(first + l < size ? first + l : size - 1) * stride + offset];
    return from_lanes<Real>(lanes);
  }
  template <class Real, class T>
  [[gnu::always_inline]] void store(const Real& x, std::vector<T>& values, std::size_t stride = 1,
                                    std::size_t offset = 0) const {
    double lanes[kLanes<Real>];
    to_lanes(x, lanes);
    for (std::size_t l = 0; l < kLanes<Real> && first + l < size; ++l)
      values[(first + l) * stride + offset] = static_cast<T>(lanes[l]);
  }
};

}  // namespace prs
