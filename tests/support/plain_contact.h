#pragma once

#include <array>
#include <cmath>

/// Hertz constants of two threads, in an independent and simple implementation: extended precision, no header of the
/// program, another way through the geometry. Flanks are heights z(x, y) over the plane across the axes; they touch at
/// their smallest clearance, where its second derivatives are the relative curvatures. SI units.
namespace plain {

using Number = long double;
using Pair = std::array<Number, 2>;

/// A thread whose flank is drawn in the plane normal to the helix at the pitch radius.
struct Flank {
  Number pitch_radius = 0;
  Number lead = 0;            ///< > 0 right-handed.
  Number flank_angle = 0;     ///< Angle against the plane across the axis.
  Number profile_radius = 0;  ///< Radius of the convex arc; 0: straight.
  Number axis = 0;            ///< x of the part's axis.
};

/// First and second derivatives of a height.
struct Slopes {
  Number x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

/// Slopes of f(r) + hand lead chi/(2 pi) about the part's axis. In the normal plane the flank's tangent leaves the
/// radius by phi, sin(phi) = sin(alpha) + (r - r_T)/r_B; along the axis it is longer by 1/cos(beta), tan(beta) =
/// lead/(2 pi r_T).
inline Slopes slopes(const Flank& f, Number hand, Number x, Number y) {
  const Number dx = x - f.axis, r = std::hypot(dx, y), c = dx / r, s = y / r;
  const Number turn = f.lead / (2 * std::acos(Number(-1)));
  const Number stretch = std::hypot(Number(1), turn / f.pitch_radius);
  const Number bend = f.profile_radius > 0 ? 1 / f.profile_radius : 0;
  const Number sine = std::sin(f.flank_angle) + (r - f.pitch_radius) * bend;
  const Number cosine = std::sqrt(1 - sine * sine);
  const Number first = stretch * sine / cosine;                       // df/dr
  const Number second = stretch * bend / (cosine * cosine * cosine);  // d2f/dr2
  const Number helix = hand * turn;
  Slopes z;
  z.x = first * c - helix * s / r;
  z.y = first * s + helix * c / r;
  z.xx = second * c * c + first / r * s * s + 2 * helix * c * s / (r * r);
  z.xy = (second - first / r) * c * s + helix * (s * s - c * c) / (r * r);
  z.yy = second * s * s + first / r * c * c - 2 * helix * c * s / (r * r);
  return z;
}

/// Contact of two flanks: relative principal curvatures, the smaller one first, and the angle between normal and axis.
struct Touch {
  Number smaller = 0, larger = 0, normal_angle = 0;
};

/// `outward`: whether the body is a screw, whose flank rises away from its axis towards the roller's; else a nut around
/// the roller. Newton's method from the pitch point.
inline Touch touch(const Flank& body, const Flank& roller, bool outward) {
  // Screw: the body's lower flank on the roller's upper one. Nut: the roller's lower flank on the
  // body's upper one, which is the lower one of the air.
  const auto clearance = [&](Number x, Number y) {
    const Slopes b = slopes(body, 1, x, y), r = slopes(roller, outward ? -1 : 1, x, y);
    const Number sign = outward ? 1 : -1;
    return Slopes{sign * b.x + r.x, sign * b.y + r.y, sign * b.xx + r.xx, sign * b.xy + r.xy, sign * b.yy + r.yy};
  };
  Number x = body.pitch_radius, y = 0;
  for (int k = 0; k < 50; ++k) {
    const Slopes g = clearance(x, y);
    const Number determinant = g.xx * g.yy - g.xy * g.xy;
    x -= (g.yy * g.x - g.xy * g.y) / determinant;
    y -= (g.xx * g.y - g.xy * g.x) / determinant;
  }
  const Slopes g = clearance(x, y), z = slopes(body, 1, x, y);
  const Number steep = std::sqrt(1 + z.x * z.x + z.y * z.y);
  // Eigenvalues of G^-1 H/steep, metric G = 1 + grad z grad z', H the clearance's second
  // derivatives: kappa^2 - trace kappa + product = 0.
  const Number a = 1 + z.x * z.x, b = z.x * z.y, d = 1 + z.y * z.y, metric = a * d - b * b;
  const Number trace = (d * g.xx - 2 * b * g.xy + a * g.yy) / (metric * steep);
  const Number product = (g.xx * g.yy - g.xy * g.xy) / (metric * steep * steep);
  const Number root = std::sqrt(trace * trace / 4 - product);
  return {trace / 2 - root, trace / 2 + root, std::acos(1 / steep)};
}

/// Complete elliptic integrals K and E of the parameter m = 1 - k'^2, by the arithmetic-geometric
/// mean (Abramowitz and Stegun 17.6).
inline Pair elliptic_integrals(Number complementary_modulus) {
  Number a = 1, g = complementary_modulus, power = 1;
  Number sum = 1 - g * g;  // 2^n c_n^2, c_0^2 = m
  for (int n = 0; n < 60; ++n) {
    const Number c = (a - g) / 2, mean = (a + g) / 2;
    g = std::sqrt(a * g);
    a = mean;
    power *= 2;
    sum += power * c * c;
  }
  const Number k = std::acos(Number(-1)) / (2 * a);
  return {k, k * (1 - sum / 2)};
}

/// k_0 of N = k_0 delta^1.5 after Johnson, Contact Mechanics (1985), (4.25), (4.26), (4.28).
inline Number hertz_constant(const Touch& t, Number contact_modulus) {
  const auto ratio = [](Number axes) {  // smaller over larger curvature for b/a
    const auto [k, e] = elliptic_integrals(axes);
    return (k - e) / (e / (axes * axes) - k);
  };
  Number low = 1e-3L, high = 1 - 1e-12L;
  for (int n = 0; n < 200; ++n) {
    const Number middle = (low + high) / 2;
    (ratio(middle) < t.smaller / t.larger ? low : high) = middle;
  }
  const Number half_turn = std::acos(Number(-1)), m = 1 - low * low;
  const auto [k, e] = elliptic_integrals(low);
  const Number a3 = 3 * (k - e) / (half_turn * t.smaller * contact_modulus * m);  // a^3/N
  return std::pow(2 * half_turn * contact_modulus / (3 * k), Number(1.5)) * std::sqrt(a3);
}

/// Both contacts of Abevi's screw (2015) with a roller profile of radius 3.5 mm/sin 45 deg (not in
/// the paper), as lesson 4 writes it, helix included.
inline Touch abevi_touch(bool screw) {
  const Number alpha = std::acos(Number(0)) / 2;
  const Flank roller{3.5e-3L, -5e-3L / 3, alpha, 4.949747468e-3L, 14e-3L};
  return touch({screw ? 10.5e-3L : 17.5e-3L, 5e-3L, alpha, 0, 0}, roller, screw);
}

/// k_0 of these contacts with E = 209 GPa and nu = 0.3 [N/m^1.5]: the 318,655 and 361,611 N/mm^1.5 beside table 2 in
/// validation/abevi_2015; the normal angles are 45.1636 and 45.0592 deg.
inline Number abevi_hertz_constant(bool screw) {
  return hertz_constant(abevi_touch(screw), 209e9L / (2 * (1 - 0.3L * 0.3L)));
}

}  // namespace plain
