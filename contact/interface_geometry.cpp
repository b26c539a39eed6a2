#include "contact/interface_geometry.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/contact_formulas.h"
#include "contact/flank_edge.h"

namespace contact {

namespace {

Eigen::Vector3d vector_of(const Vector3<double>& v) { return {v.x, v.y, v.z}; }

/// The contact point as one of the two flanks sees it.
struct FlankSpot {
  const ThreadSurface* surface;
  bool of_roller;
  double radius;             ///< From the axis of its part [m].
  Eigen::Vector2d outwards;  ///< Unit vector.
};

std::array<FlankSpot, 2> spots_on_flanks(const ThreadPair& pair, const InterfaceGeometry& g) {
  const Eigen::Vector2d on_body = g.point.position;
  const Eigen::Vector2d on_roller = on_body - Eigen::Vector2d(pair.centre_distance, 0.0);
  return {{{&pair.body, false, on_body.norm(), on_body.normalized()},
           {&pair.roller, true, on_roller.norm(), on_roller.normalized()}}};
}

/// Largest radial distance of the ellipse's points from its centre, in the tangent plane [m].
double radial_reach(const InterfaceGeometry& g, const FlankSpot& spot, double semi_major,
                    double semi_minor) {
  return std::hypot(semi_major * g.major_axis.head<2>().dot(spot.outwards),
                    semi_minor * g.minor_axis.head<2>().dot(spot.outwards));
}

}  // namespace

Eigen::Vector3d InterfaceGeometry::direction(double angle) const {
  return std::cos(angle) * helix_tangent + std::sin(angle) * point.normal.cross(helix_tangent);
}

double InterfaceGeometry::first_directions_angle() const {
  return std::abs(std::remainder(body.angle - roller.angle, std::numbers::pi));
}

InterfaceGeometry interface_geometry_of(const InterfaceNumbers<double>& numbers) {
  InterfaceGeometry g;
  g.point = contact_point_of(numbers.point);
  g.body = numbers.body;
  g.roller = numbers.roller;
  g.relative = numbers.relative;
  g.helix_tangent = vector_of(numbers.helix_tangent);
  g.major_axis = vector_of(numbers.major_axis);
  g.minor_axis = vector_of(numbers.minor_axis);
  return g;
}

InterfaceGeometry interface_geometry(const ThreadPair& pair, RollerFace face) {
  const FlankPair<double> flanks{pair.body, pair.roller, pair.centre_distance,
                                 static_cast<double>(face)};
  const PointNumbers<double> point = point_numbers(flanks);
  if (point.status == static_cast<double>(ContactPointStatus::ok))
    return interface_geometry_of(interface_numbers(flanks, point));
  InterfaceGeometry none;
  none.point = find_contact_point(pair, face);
  return none;
}

FlankViolations ellipse_beyond_flanks(const ThreadPair& pair, const InterfaceGeometry& interface,
                                      double semi_major, double semi_minor) {
  FlankViolations violations;
  for (const FlankSpot& spot : spots_on_flanks(pair, interface)) {
    const double reach = radial_reach(interface, spot, semi_major, semi_minor);
    violations.add(*spot.surface, spot.of_roller, spot.radius - reach, spot.radius + reach);
  }
  return violations;
}

FlankEdge nearest_flank_edge(const ThreadPair& pair, const InterfaceGeometry& interface,
                             double semi_major, double semi_minor) {
  FlankEdge nearest{.scale = std::numeric_limits<double>::infinity()};
  for (const FlankSpot& spot : spots_on_flanks(pair, interface)) {
    const double reach = radial_reach(interface, spot, semi_major, semi_minor);
    const bool internal = spot.surface->side < 0.0;
    const double inwards = (spot.radius - spot.surface->smallest_radius) / reach;
    const double outwards = (spot.surface->largest_radius - spot.radius) / reach;
    if (inwards < nearest.scale)
      nearest = {spot.of_roller, internal ? FlankEnd::crest : FlankEnd::root, inwards};
    if (outwards < nearest.scale)
      nearest = {spot.of_roller, internal ? FlankEnd::root : FlankEnd::crest, outwards};
  }
  return nearest;
}

InterfaceGeometry on_other_faces(const InterfaceGeometry& interface) {
  // A half turn about x, (x, y, z) -> (x, -y, -z), then all tangents reversed, so that the one of
  // the helix points to growing theta again. Angles about the normal stay.
  const auto turned = [](const Eigen::Vector3d& tangent) {
    return Eigen::Vector3d(-tangent.x(), tangent.y(), tangent.z());
  };
  InterfaceGeometry other = interface;
  other.point = on_other_faces(interface.point);
  other.helix_tangent = turned(interface.helix_tangent);
  other.major_axis = turned(interface.major_axis);
  other.minor_axis = turned(interface.minor_axis);
  return other;
}

}  // namespace contact
