#pragma once

#include <limits>

#include "contact/contact_point.h"

/// Contact point, curvatures and directions of a pair of flanks: one set of formulas for numbers and for batches, one
/// design per lane. Numbers that a status leaves undefined are arbitrary.
namespace contact {

/// Slope and second derivatives over x, y of one part of the clearance, side f(r) + twist theta.
template <class Real>
struct Relief {
  Vector2<Real> slope;
  TensorOf<Real> curvature;
};
template <class Real>
Relief<Real> operator+(const Relief<Real>& a, const Relief<Real>& b) {
  return {a.slope + b.slope, a.curvature + b.curvature};
}
template <class Real>
Relief<Real> select(const simd::Lanes<Real>& which, const Relief<Real>& a, const Relief<Real>& b) {
  return {{select(which, a.slope.x, b.slope.x), select(which, a.slope.y, b.slope.y)},
          {select(which, a.curvature.xx, b.curvature.xx), select(which, a.curvature.xy, b.curvature.xy),
           select(which, a.curvature.yy, b.curvature.yy)}};
}

/// Relief of a flank at a point, which is measured from the thread's own axis.
template <class Real>
Relief<Real> relief(const Flank<Real>& flank, const Real& side, const Real& twist, const Vector2<Real>& point) {
  const Real r = point.norm();
  const Real c = point.x / r, s = point.y / r;
  const ProfileAt<Real> f = flank.profile(r);
  // Components in the polar frame (e_r, e_theta).
  const Real slope_r = side * f.slope, slope_t = twist / r;
  const Real rr = side * f.slope_rate, rt = -twist / (r * r), tt = slope_r / r;
  return {{c * slope_r - s * slope_t, s * slope_r + c * slope_t},
          {c * c * rr - 2.0 * c * s * rt + s * s * tt, c * s * (rr - tt) + (c * c - s * s) * rt,
           s * s * rr + 2.0 * c * s * rt + c * c * tt}};
}

/// A pair of flanks that face each other. `gamma` is that of the roller's face.
template <class Real>
struct FlankPair {
  const Flank<Real>& body;
  const Flank<Real>& roller;
  const Real& centre_distance;
  double gamma;

  Vector2<Real> from_roller(const Vector2<Real>& p) const { return {p.x - centre_distance, p.y}; }
  simd::Lanes<Real> exists_at(const Vector2<Real>& p) const {
    return body.exists_at(p.norm()) && roller.exists_at(from_roller(p).norm());
  }
  Relief<Real> of_roller(const Vector2<Real>& p) const {
    return relief(roller, Real(1.0), Real(gamma * roller.reduced_lead), from_roller(p));
  }
  /// The axial clearance of the pair.
  Relief<Real> clearance(const Vector2<Real>& p) const {
    return relief(body, body.side, Real(-gamma * body.reduced_lead), p) + of_roller(p);
  }
};

/// Newton direction -H^-1 g; if H is not positive definite, a shift of its diagonal that makes it clearly so turns the
/// step into a descent.
template <class Real>
Vector2<Real> descent_direction(TensorOf<Real> h, const Vector2<Real>& slope) {
  const Real trace = h.trace();
  const auto definite = trace > 0.0 && h.determinant() > 1e-9 * trace * trace;
  if (any(!definite)) {
    const PrincipalOf<Real> p = principal_ascending(h);
    const Real shift = select(definite, Real(0.0), Real(1e-3 * max(Real(abs(p.first)), Real(abs(p.second))) - p.first));
    h.xx += shift;
    h.yy += shift;
  }
  const Real det = h.determinant();
  return {-(h.yy * slope.x - h.xy * slope.y) / det, -(h.xx * slope.y - h.xy * slope.x) / det};
}

template <class Real>
struct Descent {
  Vector2<Real> point;
  Relief<Real> relief;
  Real iterations{};
  simd::Lanes<Real> converged{};
};

/// Newton's method in the `wanted` lanes, each with its own convergence.
template <class Real>
Descent<Real> descend(const FlankPair<Real>& pair, const Vector2<Real>& start, const simd::Lanes<Real>& wanted) {
  constexpr int kMaxIterations = 50;
  constexpr int kMaxHalvings = 20;
  constexpr double kRounding = std::numeric_limits<double>::epsilon();
  Descent<Real> d{.point = start, .relief = pair.clearance(start)};
  d.iterations = Real(0.0);
  d.converged = wanted && !wanted;
  simd::Lanes<Real> active = wanted;
  for (int iteration = 0;; ++iteration) {
    const Relief<Real>& here = d.relief;
    const Real hessian_scale = abs(here.curvature.xx) + abs(here.curvature.yy);
    const Real rounding = 2.0 * kRounding * (1.0 + hessian_scale * d.point.norm());
    const auto flat = max(Real(abs(here.slope.x)), Real(abs(here.slope.y))) <= rounding;
    d.converged = d.converged || (active && flat);
    active = active && !flat;
    if (!any(active) || iteration == kMaxIterations) return d;

    Vector2<Real> step = descent_direction(here.curvature, here.slope);
    const Real descent = abs(here.slope.dot(step));
    d.iterations += select(active, Real(1.0), Real(0.0));
    simd::Lanes<Real> searching = active;
    double full_over_step = 1.0;
    for (int halving = 0; halving <= kMaxHalvings && any(searching); ++halving) {
      const Vector2<Real> trial = d.point + step;
      const Relief<Real> there = pair.clearance(trial);
      // Past the minimum along the step and steeper than before: too far.
      const auto taken =
          searching && pair.exists_at(trial) && !(there.slope.dot(step) * full_over_step > 0.9 * descent);
      d.point = {select(taken, trial.x, d.point.x), select(taken, trial.y, d.point.y)};
      d.relief = select<Real>(taken, there, d.relief);
      searching = searching && !taken;
      step = {0.5 * step.x, 0.5 * step.y};
      full_over_step *= 2.0;
    }
    active = active && !searching;
  }
}

/// Part of the line of centres on both flanks [m].
template <class Real>
RadiiOf<Real> overlap(const Flank<Real>& body, const Flank<Real>& roller, const Real& c) {
  const RadiiOf<Real> on_body = usable_limits(body), on_roller = usable_limits(roller);
  const auto external = body.side > 0.0;
  return {max(on_body.smallest, Real(c + select(external, -on_roller.largest, on_roller.smallest))),
          min(on_body.largest, Real(c + select(external, -on_roller.smallest, on_roller.largest)))};
}

template <class Real>
ContactPointOf<Real> contact_point(const FlankPair<Real>& pair) {
  using Status = simd::EnumOf<ContactPointStatus, Real>;
  using enum ContactPointStatus;
  const auto &body = pair.body, &roller = pair.roller;
  const Real& c = pair.centre_distance;
  const auto external = body.side > 0.0;

  const RadiiOf<Real> reach = overlap(body, roller, c);
  const auto curved = body.arc_curvature != 0.0 || roller.arc_curvature != 0.0;
  const auto reachable = reach.smallest < reach.largest;
  const Real on_roller = c - body.side * roller.pitch_radius;
  const Real margin = 0.01 * (reach.largest - reach.smallest);
  const Real start = min(max(Real(0.5 * (body.pitch_radius + on_roller)), Real(reach.smallest + margin)),
                         Real(reach.largest - margin));
  const Descent<Real> d = descend<Real>(pair, {start, Real(0.0)}, simd::Lanes<Real>(curved && reachable));
  const Vector2<Real> from_roller = pair.from_roller(d.point);

  ContactPointOf<Real> p;
  p.iterations = d.iterations;
  p.residual = max(Real(abs(d.relief.slope.x)), Real(abs(d.relief.slope.y)));
  p.position = d.point;
  p.radius_on_body = d.point.norm();
  p.radius_on_roller = from_roller.norm();
  p.clearance_hessian = d.relief.curvature;

  // Angles from the line of centres, where the two parts face each other.
  const Real facing = select(external, Real(-1.0), Real(1.0));
  p.angle_on_body = atan2(d.point.y, d.point.x);
  const Real roller_turn = atan2(Real(facing * from_roller.y), Real(facing * from_roller.x));
  p.angle_on_roller = select(external, Real(roller_turn + pair.gamma * std::numbers::pi), roller_turn);

  const Vector2<Real> slope = pair.of_roller(d.point).slope;
  p.normal = Vector3<Real>{slope.x, slope.y, Real(-pair.gamma)}.over(Real(sqrt(1.0 + slope.dot(slope))));

  const Real value = roller.profile(p.radius_on_roller).height + body.side * body.profile(p.radius_on_body).height -
                     pair.gamma * (body.reduced_lead * p.angle_on_body - roller.reduced_lead * roller_turn);
  const Real backlash = 2.0 * value - select(external, roller.pitch, Real(0.0));
  // Rounding of its terms, from the radii, counts as zero play.
  const Real rounding = 4.0 * std::numeric_limits<double>::epsilon() * (p.radius_on_body + p.radius_on_roller + c);
  p.backlash = select(abs(backlash) <= rounding, Real(0.0), backlash);

  const auto beyond = [](const Flank<Real>& flank, const Real& radius) {
    return flank.smallest_radius > radius || radius > flank.largest_radius;
  };
  const auto outside = beyond(body, p.radius_on_body) || beyond(roller, p.radius_on_roller);
  const TensorOf<Real>& h = p.clearance_hessian;
  const auto saddle = h.determinant() <= 0.0 || h.trace() <= 0.0;
  p.status = select(outside, Status(outside_flank), Status(ok));
  p.status = select(saddle, Status(not_a_minimum), p.status);
  p.status = select(d.converged, p.status, Status(not_converged));
  p.status = select(reachable, p.status, Status(out_of_reach));
  p.status = select(curved, p.status, Status(straight_on_straight));
  return p;
}

/// Unit tangent of the helix through a point of a thread, towards growing theta.
template <class Real>
Vector3<Real> helix_tangent(const Flank<Real>& flank, const Vector2<Real>& from_axis) {
  const Vector3<Real> t{-from_axis.y, from_axis.x, flank.reduced_lead};
  return t.over(sqrt(t.dot(t)));
}

/// Curvatures and directions at a point that is `ok`.
template <class Real>
InterfaceGeometryOf<Real> interface_at(const FlankPair<Real>& pair, const ContactPointOf<Real>& point) {
  InterfaceGeometryOf<Real> g;
  g.point = point;
  const Vector3<Real>& n = point.normal;
  const Vector3<Real> body_tangent = helix_tangent(pair.body, point.position);
  g.helix_tangent = helix_tangent(pair.roller, pair.from_roller(point.position));

  // Both tensors in the frame (roller's helix tangent, n x it). A screw's own frame is seen from
  // its other side here, since its normal is -n; the air in a nut has the roller's normal.
  const Real turn = atan2(n.dot(g.helix_tangent.cross(body_tangent)), g.helix_tangent.dot(body_tangent));
  const TensorOf<Real> of_roller = curvature_tensor(pair.roller, point.radius_on_roller);
  TensorOf<Real> in_own_frame = curvature_tensor(pair.body, point.radius_on_body);
  in_own_frame.xy = select(pair.body.side > 0.0, -in_own_frame.xy, in_own_frame.xy);
  const TensorOf<Real> of_body = in_turned_axes(in_own_frame, -turn);

  g.body = principal_by_magnitude(of_body);
  g.roller = principal_by_magnitude(of_roller);
  g.relative = principal_ascending(of_body + of_roller);
  const Vector3<Real> across = n.cross(g.helix_tangent);
  const auto [sine, cosine] = sincos(g.relative.angle);
  g.major_axis = cosine * g.helix_tangent + sine * across;
  g.minor_axis = n.cross(g.major_axis);
  return g;
}

}  // namespace contact
