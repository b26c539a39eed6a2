#include "contact/contact_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace contact {

namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon();

/// Slope and second derivatives over x, y of one part of the clearance, side f(r) + twist theta.
struct Relief {
  Eigen::Vector2d slope;
  SymmetricTensor curvature;
};

/// `point` is measured from the thread's own axis.
Relief relief(const ThreadSurface& surface, double side, double twist,
              const Eigen::Vector2d& point) {
  const double r = point.norm();
  const double c = point.x() / r, s = point.y() / r;
  const ProfilePoint f = surface.profile(r);
  // In the polar frame (e_r, e_theta).
  const double slope_r = side * f.slope, slope_t = twist / r;
  const double rr = side * f.slope_rate, rt = -twist / (r * r), tt = slope_r / r;
  return {{c * slope_r - s * slope_t, s * slope_r + c * slope_t},
          {c * c * rr - 2.0 * c * s * rt + s * s * tt, c * s * (rr - tt) + (c * c - s * s) * rt,
           s * s * rr + 2.0 * c * s * rt + c * c * tt}};
}

/// The clearance of a pair as a function of the point.
class Clearance {
 public:
  Clearance(const ThreadPair& pair, RollerFace face)
      : body_(pair.body),
        roller_(pair.roller),
        centre_(pair.centre_distance, 0.0),
        gamma_(static_cast<double>(face)) {}

  bool exists_at(const Eigen::Vector2d& p) const {
    return body_.exists_at(p.norm()) && roller_.exists_at((p - centre_).norm());
  }
  Relief of_body(const Eigen::Vector2d& p) const {
    return relief(body_, body_.side, -gamma_ * body_.reduced_lead, p);
  }
  Relief of_roller(const Eigen::Vector2d& p) const {
    return relief(roller_, 1.0, gamma_ * roller_.reduced_lead, p - centre_);
  }

 private:
  const ThreadSurface& body_;
  const ThreadSurface& roller_;
  Eigen::Vector2d centre_;
  double gamma_;
};

Relief operator+(const Relief& a, const Relief& b) {
  return {a.slope + b.slope, a.curvature + b.curvature};
}

/// Newton direction -H^-1 g; where H is not positive definite, a shift of its diagonal that makes
/// it clearly so turns the step into a descent.
Eigen::Vector2d descent_direction(const SymmetricTensor& hessian, const Eigen::Vector2d& slope) {
  SymmetricTensor h = hessian;
  const double trace = h.trace();
  if (!(trace > 0.0 && h.determinant() > 1e-9 * trace * trace)) {
    const PrincipalValues p = principal_ascending(h);
    const double shift = 1e-3 * std::max(std::abs(p.first), std::abs(p.second)) - p.first;
    h.xx += shift;
    h.yy += shift;
  }
  const double det = h.determinant();
  return {-(h.yy * slope.x() - h.xy * slope.y()) / det,
          -(h.xx * slope.y() - h.xy * slope.x()) / det};
}

struct Descent {
  Eigen::Vector2d point;
  Relief relief;
  int iterations = 0;
  bool converged = false;
};

Descent descend(const Clearance& clearance, const Eigen::Vector2d& start) {
  constexpr int kMaxIterations = 50;
  constexpr int kMaxHalvings = 20;
  Descent d{.point = start, .relief = clearance.of_body(start) + clearance.of_roller(start)};
  for (;;) {
    const double hessian_scale = std::abs(d.relief.curvature.xx) + std::abs(d.relief.curvature.yy);
    const double rounding = 2.0 * kRounding * (1.0 + hessian_scale * d.point.norm());
    const double slope_now = d.relief.slope.cwiseAbs().maxCoeff();
    if (slope_now <= rounding) {
      d.converged = true;
      return d;
    }
    if (d.iterations == kMaxIterations) return d;

    Eigen::Vector2d step = descent_direction(d.relief.curvature, d.relief.slope);
    const double descent = d.relief.slope.dot(step);
    ++d.iterations;
    bool accepted = false;
    for (int halving = 0; halving <= kMaxHalvings; ++halving, step *= 0.5) {
      const Eigen::Vector2d trial = d.point + step;
      if (!clearance.exists_at(trial)) continue;
      const Relief there = clearance.of_body(trial) + clearance.of_roller(trial);
      // Past the minimum along the step and steeper than before: too far.
      const double length = std::ldexp(1.0, halving);
      if (there.slope.dot(step) * length > 0.9 * std::abs(descent)) continue;
      d.point = trial;
      d.relief = there;
      accepted = true;
      break;
    }
    if (!accepted) return d;
  }
}

ContactPoint assess(const ThreadPair& pair, RollerFace face, const Clearance& clearance,
                    const Descent& descent) {
  const Eigen::Vector2d from_roller = descent.point - Eigen::Vector2d(pair.centre_distance, 0.0);
  const double gamma = static_cast<double>(face);
  const bool external = pair.body.side > 0.0;

  ContactPoint p;
  p.iterations = descent.iterations;
  p.residual = descent.relief.slope.cwiseAbs().maxCoeff();
  p.position = descent.point;
  p.radius_on_body = descent.point.norm();
  p.radius_on_roller = from_roller.norm();
  p.clearance_hessian = descent.relief.curvature;

  // Angles from the line of centres, where the two parts face each other.
  const double body_turn = std::atan2(descent.point.y(), descent.point.x());
  const double roller_turn = external ? std::atan2(-from_roller.y(), -from_roller.x())
                                      : std::atan2(from_roller.y(), from_roller.x());
  p.angle_on_body = body_turn;
  p.angle_on_roller = external ? roller_turn + gamma * std::numbers::pi : roller_turn;

  const Eigen::Vector2d slope = clearance.of_roller(descent.point).slope;
  p.normal = Eigen::Vector3d(slope.x(), slope.y(), -gamma) / std::sqrt(1.0 + slope.squaredNorm());

  const double value =
      pair.roller.profile(p.radius_on_roller).height +
      pair.body.side * pair.body.profile(p.radius_on_body).height -
      gamma * (pair.body.reduced_lead * body_turn - pair.roller.reduced_lead * roller_turn);
  p.backlash = 2.0 * value - (external ? pair.roller.pitch : 0.0);
  // Its terms come from the radii, whose rounding stands for a play of zero.
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() *
                          (p.radius_on_body + p.radius_on_roller + pair.centre_distance);
  if (std::abs(p.backlash) <= rounding) p.backlash = 0.0;

  const SymmetricTensor& h = p.clearance_hessian;
  if (!descent.converged) {
    p.status = ContactPointStatus::not_converged;
  } else if (h.determinant() <= 0.0 || h.trace() <= 0.0) {
    p.status = ContactPointStatus::not_a_minimum;
  } else {
    p.violations.add(pair.body, false, p.radius_on_body, p.radius_on_body);
    p.violations.add(pair.roller, true, p.radius_on_roller, p.radius_on_roller);
    p.status = p.violations.empty() ? ContactPointStatus::ok : ContactPointStatus::outside_flank;
  }
  return p;
}

/// The stretch of the line of centres that lies on both flanks [m].
RadiusLimits overlap(const ThreadPair& pair) {
  const RadiusLimits body = usable_limits(pair.body), roller = usable_limits(pair.roller);
  const double c = pair.centre_distance;
  return pair.body.side > 0.0 ? RadiusLimits{std::max(body.smallest, c - roller.largest),
                                             std::min(body.largest, c - roller.smallest)}
                              : RadiusLimits{std::max(body.smallest, c + roller.smallest),
                                             std::min(body.largest, c + roller.largest)};
}

}  // namespace

std::string_view name(ContactPointStatus status) {
  constexpr std::string_view kNames[] = {"ok",           "not_computed",  "straight_on_straight",
                                         "out_of_reach", "outside_flank", "not_a_minimum",
                                         "not_converged"};
  return kNames[static_cast<std::size_t>(status)];
}

void FlankViolations::add(const ThreadSurface& surface, bool of_roller, double innermost,
                          double outermost) {
  const bool internal = surface.side < 0.0;
  const double beyond_inner = surface.smallest_radius - innermost;
  const double beyond_outer = outermost - surface.largest_radius;
  if (beyond_inner > 0.0) {
    list_[size_++] = {of_roller, internal ? FlankEnd::crest : FlankEnd::root, beyond_inner};
  }
  if (beyond_outer > 0.0) {
    list_[size_++] = {of_roller, internal ? FlankEnd::root : FlankEnd::crest, beyond_outer};
  }
}

double ContactPoint::normal_angle() const {
  return std::atan2(normal.head<2>().norm(), std::abs(normal.z()));
}

ContactPoint find_contact_point(const ThreadPair& pair, RollerFace face) {
  ContactPoint failed;
  if (pair.body.arc_curvature == 0.0 && pair.roller.arc_curvature == 0.0) {
    failed.status = ContactPointStatus::straight_on_straight;
    return failed;
  }
  const RadiusLimits reach = overlap(pair);
  if (!(reach.smallest < reach.largest)) {
    failed.status = ContactPointStatus::out_of_reach;
    return failed;
  }

  const Clearance clearance(pair, face);
  const double on_roller = pair.centre_distance - pair.body.side * pair.roller.pitch_radius;
  const double margin = 0.01 * (reach.largest - reach.smallest);
  const double start = std::clamp(0.5 * (pair.body.pitch_radius + on_roller),
                                  reach.smallest + margin, reach.largest - margin);
  return assess(pair, face, clearance, descend(clearance, {start, 0.0}));
}

ContactPoint on_other_faces(const ContactPoint& point) {
  ContactPoint m = point;
  m.position.y() = -point.position.y();
  m.angle_on_body = -point.angle_on_body;
  m.angle_on_roller = -point.angle_on_roller;
  m.normal.y() = -point.normal.y();
  m.normal.z() = -point.normal.z();
  m.clearance_hessian.xy = -point.clearance_hessian.xy;
  return m;
}

}  // namespace contact
