#include "contact/contact_point.h"

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

ContactPoint find_contact_point(const ThreadPair& pair, RollerFace face) {
  const ContactPoint p = contact_point<double>(
      {pair.body, pair.roller, pair.centre_distance, static_cast<double>(face)});
  if (p.status == ContactPointStatus::straight_on_straight ||
      p.status == ContactPointStatus::out_of_reach)
    return {.status = p.status};
  return p;
}

FlankViolations point_beyond_flanks(const ThreadPair& pair, const ContactPoint& point) {
  FlankViolations violations;
  violations.add(pair.body, false, point.radius_on_body, point.radius_on_body);
  violations.add(pair.roller, true, point.radius_on_roller, point.radius_on_roller);
  return violations;
}

ContactPoint on_other_faces(const ContactPoint& point) {
  ContactPoint m = point;
  m.position.y = -point.position.y;
  m.angle_on_body = -point.angle_on_body;
  m.angle_on_roller = -point.angle_on_roller;
  m.normal.y = -point.normal.y;
  m.normal.z = -point.normal.z;
  m.clearance_hessian.xy = -point.clearance_hessian.xy;
  return m;
}

}  // namespace contact
