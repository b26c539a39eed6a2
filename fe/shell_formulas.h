#pragma once

#include <numbers>

#include "fe/lanes.h"

/// The formulas of fe/shell.h for a number or a batch of numbers: one shell per lane.
namespace fe {

/// Rigidities of the wall of a shell of revolution about the x axis whose sections stay straight:
/// u(x, r) = u(x) - theta(x) (r - r_0), v(x), with r_0 the radius that u belongs to. Per length the
/// energy is half of
///
///     A u'^2 - 2 S u' theta' + B theta'^2 + H v^2 + 2 v (C u' - D theta') + V (v' - theta)^2.
template <class Real>
struct ShellRigidityOf {
  Real axial{};                 ///< A [N]
  Real eccentric{};             ///< S [N m], 0 if r_0 is the wall's centre.
  Real bending{};               ///< B [N m^2]
  Real hoop{};                  ///< H [N/m^2]
  Real axial_hoop{};            ///< C, Poisson's effect [N/m]
  Real bending_hoop{};          ///< D [N]
  Real shear{};                 ///< V [N]
  bool radially_rigid = false;  ///< Whether v = 0 between the nodes; they must be held as well.
};

/// Stiffness of a uniform length over its deformations. Its halves mirror each other, so that even and odd deformations
/// are uncoupled.
template <class Real>
struct ShellBlocks {
  /// Even part, over (u_2 - u_1, theta_2 - theta_1, (v_1 + v_2)/2), upper triangle row by row.
  Real uu{}, ut{}, uv{}, tt{}, tv{}, vv{};
  /// Odd part, over (v_2 - v_1, (theta_1 + theta_2)/2).
  Real dd{}, dm{}, mm{};

  bool operator==(const ShellBlocks&) const = default;
};

template <class Real>
ShellRigidityOf<Real> scaled_rigidity(ShellRigidityOf<Real> r, const Real& share) {
  for (Real* const rigidity : {&r.axial, &r.eccentric, &r.bending, &r.hoop, &r.axial_hoop, &r.bending_hoop, &r.shear})
    *rigidity *= share;
  return r;
}

/// H of a ring whose wall begins at `inner`.
template <class Real>
Real tube_hoop(const Real& inner, const Real& outer, const Real& modulus, const Real& poisson) {
  using simd::log;
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  return modulus / (1.0 - poisson * poisson) * kTwoPi * log(outer / inner);
}

/// Full ring between the radii `inner` and `outer` with r_0 = `reference`, plane stress across the
/// wall:
///
///     (A, S, B) = E' int (1, z, z^2) 2 pi r dr,   H = E' int 2 pi/r dr,
///     (C, D) = nu E' int (1, z) 2 pi dr,   V = 5/6 G A/E',   E' = E/(1 - nu^2), z = r - r_0,
///
/// with Reissner's 5/6. SI units; `poisson` 0 uncouples axial and radial displacement.
template <class Real>
ShellRigidityOf<Real> tube_rigidity(const Real& inner, const Real& outer, const Real& reference, const Real& modulus,
                                    const Real& poisson, const Real& shear_modulus) {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  const Real plane = modulus / (1.0 - poisson * poisson);
  // Moments of the wall about its middle, then about the reference.
  const Real h = outer - inner, middle = 0.5 * (inner + outer), z = middle - reference;
  const Real area = kTwoPi * middle * h;
  const Real about_middle = kTwoPi * h * h * h / 12.0;  // int z r dr, and int z^2 dr
  ShellRigidityOf<Real> s;
  s.axial = plane * area;
  s.eccentric = plane * (about_middle + area * z);
  s.bending = plane * (middle * about_middle + 2.0 * z * about_middle + area * z * z);
  s.hoop = tube_hoop(inner, outer, modulus, poisson);
  s.axial_hoop = poisson * plane * kTwoPi * h;
  s.bending_hoop = poisson * plane * kTwoPi * h * z;
  s.shear = 5.0 / 6.0 * shear_modulus * area;
  return s;
}

/// Degree of the polynomials of a piece.
inline constexpr int kShellDegree = 7;

/// One parity of a piece: functions of v and theta alternately, v first where `kVFirst`. Function 0 is the mean, 1 the
/// difference over the length, k = 2 .. the Legendre polynomials P_k - P_(k-2). At the degree i of Legendre's series
/// function i has the value 1 (1/2 if it is the difference), i + 2 the value -1, and i + 1 the slope 2 (2 i + 1)/length
/// (1/length): three consecutive functions are coupled. u, which has a slope of its own at degrees 1 to 6, is
/// eliminated there.
template <bool kVFirst, class Real>
class ShellBand {
 public:
  ShellBand(const ShellRigidityOf<Real>& s, const Real& length) : rigid_(s.radially_rigid) {
    const Real stretched = 1.0 / s.axial;
    const Real bending = s.bending - s.eccentric * s.eccentric * stretched,
               coupling = s.bending_hoop - s.eccentric * s.axial_hoop * stretched,
               hoop = s.hoop - s.axial_hoop * s.axial_hoop * stretched;
    const Real inverse = 1.0 / length;
    for (int i = 0; i <= kShellDegree; ++i) {
      const bool free = i > 0 && i < kShellDegree;  // u of this degree
      const Real weight = length * (1.0 / (2 * i + 1));
      const Real slope = (i == 0 ? 1.0 : 2.0 * (2 * i + 1)) * inverse;
      const double value = i == 1 ? 0.5 : 1.0;
      // Function i + 1 strains by its slope alone, i and i + 2 by their values.
      const Real by_value = weight * (!is_v(i) ? s.shear : free ? hoop : s.hoop);
      const Real by_slope = weight * slope * slope * (!is_v(i) ? s.shear : free ? bending : s.bending);
      const Real by_both = weight * slope * (!is_v(i) ? s.shear : free ? coupling : s.bending_hoop);
      k_[i][0] += value * value * by_value;
      k_[i][1] -= value * by_both;
      k_[i][2] -= value * by_value;
      k_[i + 1][0] += by_slope;
      k_[i + 1][1] += by_both;
      k_[i + 2][0] += by_value;
    }
    if constexpr (kVFirst) {
      u_[0] = s.axial_hoop;
      u_[1] = -s.eccentric * inverse;
      u_[2] = -s.axial_hoop;
      uu_ = s.axial * inverse;
    }
    for (int p = kShellDegree; p > 1; --p) {
      if (rigid_ && is_v(p)) continue;
      const Real first = k_[p - 2][2], second = k_[p - 1][1], share = 1.0 / k_[p][0];
      k_[p - 1][0] -= second * second * share;
      k_[p - 2][0] -= first * first * share;
      k_[p - 2][1] -= first * second * share;
      if constexpr (kVFirst)
        if (p == 2) {
          u_[0] -= u_[2] * first * share;
          u_[1] -= u_[2] * second * share;
          uu_ -= u_[2] * u_[2] * share;
        }
    }
  }

  /// Stiffness between mean (0) and difference (1).
  const Real& operator()(int i, int j) const { return k_[i][j - i]; }
  const Real& with_u(int i) const { return u_[i]; }
  const Real& uu() const { return uu_; }

 private:
  static constexpr bool is_v(int i) { return (i % 2 == 0) == kVFirst; }

  bool rigid_;
  Real k_[kShellDegree + 3][3] = {};  ///< Products of function i with i, i + 1, i + 2.
  Real u_[3] = {};                    ///< Products of u_2 - u_1 with functions 0 to 2.
  Real uu_{};
};

template <class Real>
ShellBlocks<Real> shell_piece(const ShellRigidityOf<Real>& s, const Real& length) {
  const ShellBand<true, Real> even(s, length);
  const ShellBand<false, Real> odd(s, length);
  return {even.uu(),  even.with_u(1), even.with_u(0), even(1, 1), even(0, 1),
          even(0, 0), odd(1, 1),      odd(0, 1),      odd(0, 0)};
}

/// Two equal lengths in a row with the node between them eliminated: there v is free if the ends mirror each other, u
/// and theta if they do not.
template <class Real>
ShellBlocks<Real> doubled(const ShellBlocks<Real>& k, bool radially_rigid) {
  ShellBlocks<Real> w;
  w.uu = 0.5 * k.uu;
  w.ut = 0.5 * k.ut;
  w.uv = k.uv;
  w.tt = 0.5 * k.tt + 0.125 * k.mm;
  w.tv = k.tv;
  w.vv = 2.0 * k.vv;
  if (!radially_rigid) {
    const Real share = 1.0 / (0.5 * k.vv + 2.0 * k.dd);
    const Real u = 0.5 * k.uv, t = 0.5 * (k.tv - k.dm), v = k.vv;
    w.uu -= u * u * share;
    w.ut -= u * t * share;
    w.uv -= u * v * share;
    w.tt -= t * t * share;
    w.tv -= t * v * share;
    w.vv -= v * v * share;
  }
  const Real of_u = 1.0 / k.uu;
  const Real share = 1.0 / (k.tt + 0.25 * k.mm - k.ut * k.ut * of_u);
  const Real d = 0.25 * (k.dm - k.tv + k.ut * k.uv * of_u), m = 0.5 * k.mm;
  w.dd = 0.5 * k.dd + 0.125 * (k.vv - k.uv * k.uv * of_u) - 2.0 * d * d * share;
  w.dm = k.dm - 2.0 * d * m * share;
  w.mm = 2.0 * k.mm - 2.0 * m * m * share;
  return w;
}

/// Stiffness of a uniform length, exact to about 1e-10: polynomials of degree 7 on pieces no longer than the shortest
/// wave of the wall, their inner freedoms and the nodes between pieces eliminated. Positive definite for positive
/// rigidities with H A > C^2.
template <class Real>
ShellBlocks<Real> shell_blocks(const ShellRigidityOf<Real>& s, const Real& length) {
  using simd::any, simd::max, simd::select, simd::sqrt;
  const Real bending = s.bending - s.eccentric * s.eccentric / s.axial;
  const Real wave_number = sqrt(max(max(Real(s.shear / bending), sqrt(s.hoop / bending)), Real(s.hoop / s.shear)));
  Real piece = length, halvings(0.0);
  int most = 0;
  for (; most != 30; ++most) {
    const auto longer = piece * wave_number > 1.0;
    if (!any(longer)) break;
    piece = select(longer, 0.5 * piece, piece);
    halvings = select(longer, halvings + 1.0, halvings);
  }
  ShellBlocks<Real> k = shell_piece(s, piece);
  for (int i = 0; i < most; ++i) {
    const auto again = halvings > static_cast<double>(i);
    const ShellBlocks<Real> w = doubled(k, s.radially_rigid);
    k = {select(again, w.uu, k.uu), select(again, w.ut, k.ut), select(again, w.uv, k.uv),
         select(again, w.tt, k.tt), select(again, w.tv, k.tv), select(again, w.vv, k.vv),
         select(again, w.dd, k.dd), select(again, w.dm, k.dm), select(again, w.mm, k.mm)};
  }
  return k;
}

/// The blocks with u taken at the radius r_0 + `shift`.
template <class Real>
ShellBlocks<Real> about(ShellBlocks<Real> k, const Real& shift) {
  k.tt += shift * (2.0 * k.ut + shift * k.uu);
  k.ut += shift * k.uu;
  k.tv += shift * k.uv;
  return k;
}

}  // namespace fe
