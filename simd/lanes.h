#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "simd/inlined.h"

/// Arithmetic with the same names for a number and for a batch of numbers: functions of xsimd for batches, for single
/// numbers. Formulas are templates over `Real`, which is either.

namespace simd {

/// Boolean for each number of a batch.
template <class Real>
using Lanes = decltype(Real() < Real());

/// Number of values in a batch.
template <class Real>
inline constexpr std::size_t kLanes = sizeof(Real) / sizeof(double);

PRS_INLINED inline double select(bool condition, double a, double b) { return condition ? a : b; }
PRS_INLINED inline bool any(bool condition) { return condition; }
PRS_INLINED inline double sqrt(double x) { return __builtin_sqrt(x); }
PRS_INLINED inline double abs(double x) { return __builtin_fabs(x); }
PRS_INLINED inline double max(double a, double b) { return a > b ? a : b; }
PRS_INLINED inline double min(double a, double b) { return a < b ? a : b; }
PRS_INLINED inline double cbrt(double x) { return __builtin_cbrt(x); }
PRS_INLINED inline double hypot(double x, double y) { return __builtin_hypot(x, y); }
PRS_INLINED inline double atan2(double y, double x) { return __builtin_atan2(y, x); }
PRS_INLINED inline double exp(double x) { return __builtin_exp(x); }
PRS_INLINED inline double log(double x) { return __builtin_log(x); }
PRS_INLINED inline double log10(double x) { return __builtin_log10(x); }
PRS_INLINED inline double fma(double x, double y, double z) { return __builtin_fma(x, y, z); }
PRS_INLINED inline double copysign(double x, double sign) { return __builtin_copysign(x, sign); }
PRS_INLINED inline bool isnan(double x) { return __builtin_isnan(x); }
PRS_INLINED inline std::pair<double, double> sincos(double x) { return {__builtin_sin(x), __builtin_cos(x)}; }

template <class Enum>
requires std::is_enum_v<Enum> PRS_INLINED inline Enum select(bool condition, Enum a, Enum b) {
  return condition ? a : b;
}

/// An enum in each lane of a batch, in place of a number.
template <class Enum, class Real>
class EnumLanes {
 public:
  EnumLanes() = default;
  PRS_INLINED EnumLanes(Enum in_all) : bits_(std::bit_cast<double>(in_all)) {}

  PRS_INLINED friend Lanes<Real> operator==(const EnumLanes& a, const EnumLanes& b) { return a.bits_ == b.bits_; }
  PRS_INLINED friend EnumLanes select(const Lanes<Real>& which, const EnumLanes& a, const EnumLanes& b) {
    EnumLanes chosen;
    chosen.bits_ = select(which, a.bits_, b.bits_);
    return chosen;
  }

 private:
  Real bits_{};
};

/// Enums in lanes are as wide as a number: `enum class Status : std::int64_t`.
template <class Enum, class Real>
using EnumOf = std::conditional_t<std::is_same_v<Real, double>, Enum, EnumLanes<Enum, Real>>;

/// A number, or each number of several, with this value.
template <class Of>
PRS_INLINED constexpr Of filled_with(double x) {
  if constexpr (std::is_same_v<Of, double>) {
    return x;
  } else {
    std::array<double, sizeof(Of) / sizeof(double)> numbers;
    numbers.fill(x);
    return std::bit_cast<Of>(numbers);
  }
}

/// Loads the first `size` structures of `values`, one per lane; lanes beyond `size` get the last one. Here and below,
/// `Of` consists of batches only, `One` of as many numbers in the same order.

template <class Of, class One, std::size_t kLanes = sizeof(Of) / sizeof(One)>
PRS_INLINED inline Of side_by_side(const One* values, std::size_t size) {
  constexpr std::size_t kNumbers = sizeof(One) / sizeof(double);
  Of batches;
  if (kNumbers == 1 && size >= kLanes) {
    std::memcpy(static_cast<void*>(&batches), values, sizeof batches);
    return batches;
  }
  alignas(64) double lanes[kNumbers * kLanes];
  for (std::size_t l = 0; l < kLanes; ++l) {
    double numbers[kNumbers];
    std::memcpy(numbers, values + (l < size ? l : size - 1), sizeof numbers);
    for (std::size_t i = 0; i < kNumbers; ++i) lanes[i * kLanes + l] = numbers[i];
  }
  std::memcpy(static_cast<void*>(&batches), lanes, sizeof batches);
  return batches;
}

/// A structure whose numbers are repeated in all lanes of `Batch`.
template <class Of, class Batch, class One>
PRS_INLINED inline Of in_all_lanes(const One& one) {
  Of of;
  if constexpr (!std::is_empty_v<One>) {
    constexpr std::size_t kNumbers = sizeof(One) / sizeof(double);
    double numbers[kNumbers];
    std::memcpy(numbers, &one, sizeof numbers);
    Batch batches[kNumbers];
    for (std::size_t i = 0; i < kNumbers; ++i) batches[i] = Batch(numbers[i]);
    std::memcpy(static_cast<void*>(&of), batches, sizeof batches);
  }
  return of;
}

/// The numbers of `from` in these lanes of `to`.
template <class Batch, class Of>
PRS_INLINED inline void take_where(const Lanes<Batch>& which, const Of& from, Of& to) {
  Batch a[sizeof(Of) / sizeof(Batch)], b[sizeof(Of) / sizeof(Batch)];
  std::memcpy(static_cast<void*>(a), &from, sizeof a);
  std::memcpy(static_cast<void*>(b), &to, sizeof b);
  for (std::size_t i = 0; i < sizeof(Of) / sizeof(Batch); ++i) b[i] = select(which, a[i], b[i]);
  std::memcpy(static_cast<void*>(&to), b, sizeof b);
}

/// Stores the lanes into structures.
template <class Of, class One, std::size_t kLanes = sizeof(Of) / sizeof(One)>
PRS_INLINED inline void deliver(const Of& batches, One* values, std::size_t size) {
  constexpr std::size_t kNumbers = sizeof(One) / sizeof(double);
  if (kNumbers == 1 && size >= kLanes) {
    std::memcpy(static_cast<void*>(values), &batches, sizeof batches);
    return;
  }
  alignas(64) double lanes[kNumbers * kLanes];
  std::memcpy(lanes, static_cast<const void*>(&batches), sizeof batches);
  for (std::size_t l = 0; l < kLanes && l < size; ++l) {
    double numbers[kNumbers];
    for (std::size_t i = 0; i < kNumbers; ++i) numbers[i] = lanes[i * kLanes + l];
    std::memcpy(static_cast<void*>(values + l), numbers, sizeof numbers);
  }
}

}  // namespace simd
