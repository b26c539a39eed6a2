#include "contact/contact_point.h"

#include <cmath>

#include "contact/contact_formulas.h"

namespace contact {

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

ContactPoint contact_point_of(const PointNumbers<double>& n) {
  ContactPoint p;
  p.status = static_cast<ContactPointStatus>(static_cast<int>(n.status));
  p.iterations = static_cast<int>(n.iterations);
  p.residual = n.residual;
  p.position = {n.position.x, n.position.y};
  p.radius_on_body = n.radius_on_body;
  p.radius_on_roller = n.radius_on_roller;
  p.angle_on_body = n.angle_on_body;
  p.angle_on_roller = n.angle_on_roller;
  p.normal = {n.normal.x, n.normal.y, n.normal.z};
  p.clearance_hessian = n.clearance_hessian;
  p.backlash = n.backlash;
  return p;
}

ContactPoint find_contact_point(const ThreadPair& pair, RollerFace face) {
  const PointNumbers<double> numbers = point_numbers<double>(
      {pair.body, pair.roller, pair.centre_distance, static_cast<double>(face)});
  ContactPoint p = contact_point_of(numbers);
  if (p.status == ContactPointStatus::straight_on_straight ||
      p.status == ContactPointStatus::out_of_reach) {
    ContactPoint failed;
    failed.status = p.status;
    return failed;
  }
  if (p.status == ContactPointStatus::outside_flank) {
    p.violations.add(pair.body, false, p.radius_on_body, p.radius_on_body);
    p.violations.add(pair.roller, true, p.radius_on_roller, p.radius_on_roller);
  }
  return p;
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
