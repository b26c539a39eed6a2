#include "contact/contact_point.h"

#include "contact/contact_formulas.h"

namespace contact {

std::string_view name(ContactPointStatus status) {
  constexpr std::string_view kNames[] = {
      "ok", "not_computed", "straight_on_straight", "out_of_reach", "outside_flank", "not_a_minimum", "not_converged"};
  return kNames[static_cast<std::size_t>(status)];
}

void FlankViolations::add(const ThreadSurface& surface, bool of_roller, double innermost, double outermost) {
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
  const ContactPoint p =
      contact_point<double>({pair.body, pair.roller, pair.centre_distance, static_cast<double>(face)});
  if (p.status == ContactPointStatus::straight_on_straight || p.status == ContactPointStatus::out_of_reach)
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

namespace {

/// Place of the contact point on one of the two flanks.
struct FlankSpot {
  const ThreadSurface* surface;
  bool of_roller;
  double radius;             ///< Distance from the axis of its part [m].
  Vector2<double> outwards;  ///< Unit vector.
};

std::array<FlankSpot, 2> spots_on_flanks(const ThreadPair& pair, const InterfaceGeometry& g) {
  const auto spot = [&](const ThreadSurface& surface, bool of_roller, double axis) {
    const Vector2<double> at{g.point.position.x - axis, g.point.position.y};
    const double radius = at.norm();
    return FlankSpot{&surface, of_roller, radius, {at.x / radius, at.y / radius}};
  };
  return {spot(pair.body, false, 0.0), spot(pair.roller, true, pair.centre_distance)};
}

/// Largest radial distance of the ellipse's points from its centre, in the tangent plane [m].
double radial_reach(const InterfaceGeometry& g, const FlankSpot& spot, double semi_major, double semi_minor) {
  const auto along = [&](const Vector3<double>& axis) { return axis.x * spot.outwards.x + axis.y * spot.outwards.y; };
  return std::hypot(semi_major * along(g.major_axis), semi_minor * along(g.minor_axis));
}

}  // namespace

InterfaceGeometry interface_geometry(const ThreadPair& pair, RollerFace face) {
  const ContactPoint point = find_contact_point(pair, face);
  if (!point.ok()) return {.point = point};
  return interface_at<double>({pair.body, pair.roller, pair.centre_distance, static_cast<double>(face)}, point);
}

FlankViolations ellipse_beyond_flanks(const ThreadPair& pair, const InterfaceGeometry& interface, double semi_major,
                                      double semi_minor) {
  FlankViolations violations;
  for (const FlankSpot& spot : spots_on_flanks(pair, interface)) {
    const double reach = radial_reach(interface, spot, semi_major, semi_minor);
    violations.add(*spot.surface, spot.of_roller, spot.radius - reach, spot.radius + reach);
  }
  return violations;
}

FlankEdge nearest_flank_edge(const ThreadPair& pair, const InterfaceGeometry& interface, double semi_major,
                             double semi_minor) {
  FlankEdge nearest{.scale = std::numeric_limits<double>::infinity()};
  for (const FlankSpot& spot : spots_on_flanks(pair, interface)) {
    const double reach = radial_reach(interface, spot, semi_major, semi_minor);
    const bool internal = spot.surface->side < 0.0;
    const double inwards = (spot.radius - spot.surface->smallest_radius) / reach;
    const double outwards = (spot.surface->largest_radius - spot.radius) / reach;
    if (inwards < nearest.scale) nearest = {spot.of_roller, internal ? FlankEnd::crest : FlankEnd::root, inwards};
    if (outwards < nearest.scale) nearest = {spot.of_roller, internal ? FlankEnd::root : FlankEnd::crest, outwards};
  }
  return nearest;
}

InterfaceGeometry on_other_faces(const InterfaceGeometry& interface) {
  // A half turn about x, (x, y, z) -> (x, -y, -z), then all tangents reversed, so that the tangent of the helix points
  // to growing theta again. Angles about the normal stay.
  const auto turned = [](const Vector3<double>& tangent) { return Vector3<double>{-tangent.x, tangent.y, tangent.z}; };
  InterfaceGeometry other = interface;
  other.point = on_other_faces(interface.point);
  other.helix_tangent = turned(interface.helix_tangent);
  other.major_axis = turned(interface.major_axis);
  other.minor_axis = turned(interface.minor_axis);
  return other;
}

}  // namespace contact
