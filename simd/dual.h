#pragma once

#include "simd/inlined.h"
#include "simd/lanes.h"

/// Numbers with their slope along one variable, for Newton's method: formulas that are templates
/// over a number give both (forward differentiation).
namespace simd {

/// Always inlined: kernels for one instruction set then leave no copy that others would run.
template <class Real>
struct Dual {
  Real value{};
  Real slope{};

  Dual() = default;
  PRS_INLINED Dual(const Real& constant) : value(constant), slope(0.0) {}
  PRS_INLINED Dual(const Real& of_value, const Real& of_slope) : value(of_value), slope(of_slope) {}

  PRS_INLINED friend Dual operator-(const Dual& x) { return {-x.value, -x.slope}; }
  PRS_INLINED friend Dual operator+(const Dual& x, const Dual& y) { return {x.value + y.value, x.slope + y.slope}; }
  PRS_INLINED friend Dual operator+(const Dual& x, const Real& y) { return {x.value + y, x.slope}; }
  PRS_INLINED friend Dual operator+(const Real& x, const Dual& y) { return y + x; }
  PRS_INLINED friend Dual operator-(const Dual& x, const Dual& y) { return {x.value - y.value, x.slope - y.slope}; }
  PRS_INLINED friend Dual operator-(const Dual& x, const Real& y) { return {x.value - y, x.slope}; }
  PRS_INLINED friend Dual operator-(const Real& x, const Dual& y) { return {x - y.value, -y.slope}; }
  PRS_INLINED friend Dual operator*(const Dual& x, const Dual& y) {
    return {x.value * y.value, x.value * y.slope + x.slope * y.value};
  }
  PRS_INLINED friend Dual operator*(const Dual& x, const Real& y) { return {x.value * y, x.slope * y}; }
  PRS_INLINED friend Dual operator*(const Real& x, const Dual& y) { return y * x; }
  PRS_INLINED friend Dual operator/(const Dual& x, const Dual& y) {
    const Real inverse = 1.0 / y.value, ratio = x.value * inverse;
    return {ratio, (x.slope - ratio * y.slope) * inverse};
  }
  PRS_INLINED friend Dual operator/(const Dual& x, const Real& y) { return {x.value / y, x.slope / y}; }
  PRS_INLINED friend Dual operator/(const Real& x, const Dual& y) { return Dual(x) / y; }
  PRS_INLINED Dual& operator+=(const Dual& x) { return *this = *this + x; }
  PRS_INLINED Dual& operator-=(const Dual& x) { return *this = *this - x; }
  PRS_INLINED friend auto operator<(const Dual& x, const Dual& y) { return x.value < y.value; }
};

/// Value of a number with or without its slope.
template <class Real>
PRS_INLINED inline const Real& value(const Real& x) {
  return x;
}
template <class Real>
PRS_INLINED inline const Real& value(const Dual<Real>& x) {
  return x.value;
}
template <class Number>
using ValueOf = std::remove_cvref_t<decltype(value(std::declval<Number>()))>;

template <class Real>
PRS_INLINED inline Dual<Real> select(const Lanes<Real>& which, const Dual<Real>& a, const Dual<Real>& b) {
  return {select(which, a.value, b.value), select(which, a.slope, b.slope)};
}
template <class Real>
PRS_INLINED inline Dual<Real> abs(const Dual<Real>& x) {
  return select<Real>(x.value < Real(0.0), -x, x);
}
/// Slope undefined at 0.
template <class Real>
PRS_INLINED inline Dual<Real> sqrt(const Dual<Real>& x) {
  const Real root = sqrt(x.value);
  return {root, 0.5 * x.slope * (1.0 / root)};
}
/// |(x, y)|
template <class Real>
PRS_INLINED inline Dual<Real> length(const Dual<Real>& x, const Dual<Real>& y) {
  const Real root = sqrt(Real(x.value * x.value + y.value * y.value));
  return {root, (x.value * x.slope + y.value * y.slope) * (1.0 / root)};
}
template <class Real>
PRS_INLINED inline Real length(const Real& x, const Real& y) {
  return sqrt(Real(x * x + y * y));
}
template <class Real>
PRS_INLINED inline Dual<Real> exp(const Dual<Real>& x) {
  const Real y = exp(x.value);
  return {y, y * x.slope};
}

/// asinh(x) of x >= 0; of batches in simd/asinh.h.
PRS_INLINED inline double asinh_of_positive(double x) { return __builtin_asinh(x); }
template <class Batch>
Batch asinh_of_positive(const Batch& x);
template <class Batch>
Dual<Batch> asinh_of_positive(const Dual<Batch>& x);

/// x^p for x >= 0 and a constant p.
PRS_INLINED inline double power(double x, double p) { return __builtin_pow(x, p); }
template <class Batch>
requires requires(Batch x) { pow(x, x); }
Batch power(const Batch& x, const Batch& p) { return pow(x, p); }
template <class Real>
PRS_INLINED inline Dual<Real> power(const Dual<Real>& x, const Real& p) {
  const Real y = power(x.value, p);
  return {y, p * y / x.value * x.slope};
}
template <class Real>
PRS_INLINED inline Dual<Real> power(const Dual<Real>& x, const Dual<Real>& p) {
  const Real y = power(x.value, p.value);
  return {y, y * (p.value / x.value * x.slope + log(x.value) * p.slope)};
}

}  // namespace simd
