#pragma once

#include <cstddef>
#include <cstring>

#include "simd/lanes.h"

/// Structures of numbers against structures of batches, one structure per lane. `Of` consists of
/// batches alone, `One` of as many numbers in the same order.
namespace simd {

/// The first `size` structures of `values`, one per lane; lanes beyond `size` hold the last one.
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

/// The other way round.
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
