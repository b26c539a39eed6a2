#pragma once

#include "simd/lanes.h"

namespace contact {

template <class Real>
struct Vector2 {
  Real x{}, y{};

  Real dot(const Vector2& v) const { return x * v.x + y * v.y; }
  Real norm() const {
    using simd::sqrt;
    return sqrt(dot(*this));
  }
  bool operator==(const Vector2&) const = default;
};
template <class Real>
Vector2<Real> operator+(const Vector2<Real>& a, const Vector2<Real>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <class Real>
Vector2<Real> operator-(const Vector2<Real>& a, const Vector2<Real>& b) {
  return {a.x - b.x, a.y - b.y};
}

template <class Real>
struct Vector3 {
  Real x{}, y{}, z{};

  Real dot(const Vector3& v) const { return x * v.x + y * v.y + z * v.z; }
  Real norm() const {
    using simd::sqrt;
    return sqrt(dot(*this));
  }
  Vector3 cross(const Vector3& v) const { return {y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x}; }
  Vector3 over(const Real& length) const { return {x / length, y / length, z / length}; }
  bool operator==(const Vector3&) const = default;
};
template <class Real>
Vector3<Real> operator+(const Vector3<Real>& a, const Vector3<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
Vector3<Real> operator-(const Vector3<Real>& a, const Vector3<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
Vector3<Real> operator*(const Real& factor, const Vector3<Real>& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

}  // namespace contact
