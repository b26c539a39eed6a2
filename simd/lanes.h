#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

/// Arithmetic with the same names for a number and for a batch of numbers: functions of xsimd for batches, for single
/// numbers. Formulas are templates over `Real`, which is either.

namespace simd {

/// Boolean for each number of a batch.
template <class Real>
using Lanes = decltype(Real() < Real());

/// Number of values in a batch.
template <class Real>
inline constexpr std::size_t kLanes = sizeof(Real) / sizeof(double);

[[gnu::always_inline]] inline double select(bool condition, double a, double b) { return condition ? a : b; }
[[gnu::always_inline]] inline bool any(bool condition) { return condition; }
[[gnu::always_inline]] inline double sqrt(double x) { return __builtin_sqrt(x); }
[[gnu::always_inline]] inline double abs(double x) { return __builtin_fabs(x); }
[[gnu::always_inline]] inline double max(double a, double b) { return a > b ? a : b; }
[[gnu::always_inline]] inline double min(double a, double b) { return a < b ? a : b; }
[[gnu::always_inline]] inline double cbrt(double x) { return __builtin_cbrt(x); }
[[gnu::always_inline]] inline double hypot(double x, double y) { return __builtin_hypot(x, y); }
[[gnu::always_inline]] inline double atan2(double y, double x) { return __builtin_atan2(y, x); }
[[gnu::always_inline]] inline double exp(double x) { return __builtin_exp(x); }
[[gnu::always_inline]] inline double log(double x) { return __builtin_log(x); }
[[gnu::always_inline]] inline double log10(double x) { return __builtin_log10(x); }
[[gnu::always_inline]] inline double fma(double x, double y, double z) { return __builtin_fma(x, y, z); }
[[gnu::always_inline]] inline double copysign(double x, double sign) { return __builtin_copysign(x, sign); }
[[gnu::always_inline]] inline bool isnan(double x) { return __builtin_isnan(x); }
[[gnu::always_inline]] inline std::pair<double, double> sincos(double x) {
  return {__builtin_sin(x), __builtin_cos(x)};
}

template <class Enum>
requires std::is_enum_v<Enum>
[[gnu::always_inline]] inline Enum select(bool condition, Enum a, Enum b) { return condition ? a : b; }

/// An enum in each lane of a batch, in place of a number.
template <class Enum, class Real>
class EnumLanes {
 public:
  EnumLanes() = default;
  [[gnu::always_inline]] EnumLanes(Enum in_all) : bits_(std::bit_cast<double>(in_all)) {}

  [[gnu::always_inline]] friend Lanes<Real> operator==(const EnumLanes& a, const EnumLanes& b) {
    return a.bits_ == b.bits_;
  }
  [[gnu::always_inline]] friend EnumLanes select(const Lanes<Real>& which, const EnumLanes& a, const EnumLanes& b) {
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
[[gnu::always_inline]] constexpr Of filled_with(double x) {
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
[[gnu::always_inline]] inline Of side_by_side(const One* values, std::size_t size) {
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
[[gnu::always_inline]] inline Of in_all_lanes(const One& one) {
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
[[gnu::always_inline]] inline void take_where(const Lanes<Batch>& which, const Of& from, Of& to) {
  Batch a[sizeof(Of) / sizeof(Batch)], b[sizeof(Of) / sizeof(Batch)];
  std::memcpy(static_cast<void*>(a), &from, sizeof a);
  std::memcpy(static_cast<void*>(b), &to, sizeof b);
  for (std::size_t i = 0; i < sizeof(Of) / sizeof(Batch); ++i) b[i] = select(which, a[i], b[i]);
  std::memcpy(static_cast<void*>(&to), b, sizeof b);
}

/// Stores the lanes into structures.
template <class Of, class One, std::size_t kLanes = sizeof(Of) / sizeof(One)>
[[gnu::always_inline]] inline void deliver(const Of& batches, One* values, std::size_t size) {
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
