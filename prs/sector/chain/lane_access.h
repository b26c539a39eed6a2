#pragma once

#include <cstddef>
#include <cstring>
#include <span>

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

/// A batch of solves, one per lane: `first`, `first + step`, .. of `size` solves whose numbers
/// stand in arrays. Lanes beyond the end repeat the last solve and deliver nothing.
struct LaneRange {
  std::size_t first = 0;
  std::size_t step = 1;
  std::size_t size = 0;

  std::size_t place(std::size_t lane) const { return first + lane * step; }

  /// Number `offset` of each solve, `stride` numbers a solve; zeros from an empty array.
  template <class Real>
  [[gnu::always_inline]] Real load(std::span<const double> values, std::size_t stride = 1,
                                   std::size_t offset = 0) const {
    if (values.empty()) return Real(0.0);
    if (step == 1 && stride == 1 && first + kLanes<Real> <= size)
      return from_lanes<Real>(values.data() + first + offset);
    double lanes[kLanes<Real>];
    for (std::size_t l = 0; l < kLanes<Real>; ++l)
      lanes[l] = values[(place(l) < size ? place(l) : size - 1) * stride + offset];
    return from_lanes<Real>(lanes);
  }

  template <class Real, class T>
  [[gnu::always_inline]] void store(const Real& x, std::span<T> values, std::size_t stride = 1,
                                    std::size_t offset = 0) const {
    if (values.empty()) return;
    double lanes[kLanes<Real>];
    to_lanes(x, lanes);
    for (std::size_t l = 0; l < kLanes<Real> && place(l) < size; ++l)
      values[place(l) * stride + offset] = static_cast<T>(lanes[l]);
  }
};

}  // namespace prs
