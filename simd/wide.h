#pragma once

#include "simd/inlined.h"
#include "simd/lanes.h"

namespace simd {

/// x y + z, rounded once, on processors with fused multiply-add; xsimd 8 rounds twice with AVX-512.
template <class Real>
PRS_INLINED inline Real fused(const Real& x, const Real& y, const Real& z) {
  double a[kLanes<Real>], b[kLanes<Real>], c[kLanes<Real>];
  std::memcpy(a, &x, sizeof a);
  std::memcpy(b, &y, sizeof b);
  std::memcpy(c, &z, sizeof c);
  for (std::size_t l = 0; l < kLanes<Real>; ++l) c[l] = __builtin_fma(a[l], b[l], c[l]);
  Real result;
  std::memcpy(static_cast<void*>(&result), c, sizeof c);
  return result;
}

/// An unevaluated sum of two numbers, of about 106 bits, for a number or a batch of numbers (Dekker, Numer. Math. 18,
/// 1971). Used for differences of nearly equal numbers.
template <class Real>
struct Wide {
  Real head{};
  Real tail{};

  Wide() = default;
  Wide(const Real& of_head) : head(of_head), tail(0.0) {}
  Wide(const Real& of_head, const Real& of_tail) : head(of_head), tail(of_tail) {}

  /// of_head + of_tail, where the first is the larger one.
  static Wide joined(const Real& of_head, const Real& of_tail) {
    const Real sum = of_head + of_tail;
    return {sum, of_tail - (sum - of_head)};
  }
  Real rounded() const { return head + tail; }

  Wide operator-() const { return {-head, -tail}; }
  Wide operator+(const Wide& other) const {
    const Real sum = head + other.head, part = sum - head;
    const Real left = (head - (sum - part)) + (other.head - part);
    return joined(sum, left + (tail + other.tail));
  }
  Wide operator-(const Wide& other) const { return *this + -other; }
  Wide operator*(const Wide& other) const {
    const Wide heads = product(head, other.head);
    return joined(heads.head, heads.tail + (head * other.tail + tail * other.head));
  }
  /// Product with a power of two.
  Wide scaled(double power) const { return {head * power, tail * power}; }
  Wide inverse() const {
    const Wide guess(1.0 / head);
    return guess + guess * (Wide(Real(1.0)) - *this * guess);
  }

 private:
  static Wide product(const Real& x, const Real& y) {
    const Real all = x * y;
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
    return {all, fused(x, y, Real(-all))};
#else
    const auto half = [](const Real& number) {
      const Real c = 134217729.0 * number;
      return c - (c - number);
    };
    const Real x1 = half(x), x2 = x - x1, y1 = half(y), y2 = y - y1;
    return {all, ((x1 * y1 - all) + x1 * y2 + x2 * y1) + x2 * y2};
#endif
  }
};

}  // namespace simd
