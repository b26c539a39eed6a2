#include "validation/extensions.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "prs/model/units.h"
#include "validation/yao_2023/sensitivity.h"

namespace prs::yao_2023 {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegree = std::numbers::pi / 180.0;

/// Acute angle between two lines [rad].
double acute(double angle) { return std::abs(std::remainder(angle, std::numbers::pi)); }

/// e and the angles of the major axis (x) from the first directions of roller and body.
Json ellipse(const InterfaceContact& contact) {
  const contact::InterfaceGeometry& g = contact.geometry;
  const double k = contact.hertz.ellipticity;
  return {{"eccentricity", std::sqrt((1.0 - k) * (1.0 + k))},
          {"major_axis_from_roller_deg", acute(g.relative.angle - g.roller.angle) * per_si::degree},
          {"major_axis_from_body_deg", acute(g.relative.angle - g.body.angle) * per_si::degree}};
}

/// Yao counts the roller's deflection at the screw from the line to the screw: pi - theta (25).
double deflection_at_screw(const contact::ContactPoint& point) {
  return std::remainder(std::numbers::pi - point.angle_on_roller, 2.0 * std::numbers::pi);
}

Json derived(const Result& result) {
  const PerInterface<InterfaceContact>& interfaces = result.contacts.interfaces;
  return {{"screw", ellipse(interfaces.screw)},
          {"nut", ellipse(interfaces.nut)},
          {"roller_deflection_at_screw_deg",
           deflection_at_screw(interfaces.screw.geometry.point) * per_si::degree}};
}

/// A contact point as table 2 prints it: radius [mm] and deflection [deg] on body and roller.
struct PrintedPoint {
  const char* label;
  double side;  ///< Side of the roller's axis with the point: -1 at the screw, +1 at the nut.
  double body_radius, body_angle, roller_radius, roller_angle;
};

/// Components of the gap between the two printed points, (25) and (26), lines 3 and 4 [mm].
ValidationTable::Row closure(const PrintedPoint& p) {
  constexpr double kCentreDistance = 32.0;
  const double across = p.body_radius * std::sin(p.body_angle * kDegree) -
                        p.roller_radius * std::sin(p.roller_angle * kDegree);
  const double along = p.body_radius * std::cos(p.body_angle * kDegree) -
                       p.side * p.roller_radius * std::cos(p.roller_angle * kDegree) -
                       kCentreDistance;
  return {p.label, {across, along, std::hypot(across, along)}};
}

ValidationTable closure_of_printed_points() {
  ValidationTable table{
      "Tables 1 and 2: gap between the two printed contact points, which should be one, in mm",
      {"point", "across centres", "along centres", "distance"},
      {}};
  for (const PrintedPoint& p :
       {PrintedPoint{"initial, screw-roller", -1, 24.1710, -3.6995, 8.0336, -11.2727},
        PrintedPoint{"initial, nut-roller", 1, 40, 0, 8, 0},
        PrintedPoint{"optimum, screw-roller", -1, 23.8722, -4.1559, 8.3843, -11.8005},
        PrintedPoint{"optimum, nut-roller", 1, 39.9948, -0.0090, 7.9434, -0.0242}})
    table.rows.push_back(closure(p));
  return table;
}

}  // namespace

SourceExtension extension() {
  return {.folder = "yao_2023",
          .derived = derived,
          .tables = [] { return std::vector{closure_of_printed_points()}; },
          .supplement = [](const Case& initial,
                           const std::filesystem::path&) { return sensitivity(initial); }};
}

}  // namespace prs::yao_2023
