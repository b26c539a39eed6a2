#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "prs/loads/contact_parts.h"

namespace prs {
namespace {

/// A pitch circle in the projection along the axis [m].
struct Circle {
  Part part = Part::screw;
  double x = 0.0;
  double y = 0.0;
  double radius = 0.0;
};

/// The circle from the angle `from` to `to` [rad].
Polyline arc(const Circle& circle, double from, double to) {
  constexpr int kPoints = 180;
  Polyline points;
  for (int k = 0; k <= kPoints; ++k) {
    const double angle = std::lerp(from, to, static_cast<double>(k) / kPoints);
    points.push_back(point_mm(circle.x + circle.radius * std::cos(angle),
                              circle.y + circle.radius * std::sin(angle)));
  }
  return points;
}

Polyline whole(const Circle& circle) { return arc(circle, 0.0, 2.0 * std::numbers::pi); }

/// The part of the circle that lies within `reach` of the point where it meets the line of centres.
Polyline near_line_of_centres(const Circle& circle, double side, double reach) {
  const double middle = side > 0.0 ? 0.0 : std::numbers::pi;
  const double half = std::min(reach / circle.radius, std::numbers::pi);
  return arc(circle, middle - half, middle + half);
}

Circle body_circle(const contact::MechanismGeometry& threads, Part part) {
  return {part, 0.0, 0.0,
          part == Part::screw ? threads.screw.pitch_radius : threads.nut.pitch_radius};
}

Circle roller_circle(const contact::MechanismGeometry& threads, double angle) {
  return {Part::roller, threads.centre_distance * std::cos(angle),
          threads.centre_distance * std::sin(angle), threads.roller.pitch_radius};
}

std::array<double, 2> contact_mm(const Contacts& contacts, Interface i) {
  const contact::Vector2<double>& position = contacts.interfaces[i].geometry.point.position;
  return point_mm(position.x, position.y);
}

/// Styles of the figure in the order of their legend.
enum CircleStyle : std::size_t {
  kScrewCircle,
  kRollerCircle,
  kNutCircle,
  kCentres,
  kRadii,
  kContactPoints
};

void add_circle_styles(Figure& figure) {
  for (const Part part : kParts)
    figure.add(fmt::format("pitch circle, {}", title(part)), line_of(colour_of(part)));
  figure.add("line of centres", kAxisLine);
  figure.add("radii to the contact", line_of(Colour::ink, Dash::dashed, Weight::thin));
  figure.add("contact points I, J", kContactMark);
}

std::size_t style_of(Part part) { return static_cast<std::size_t>(part); }

/// Names the contact point next to its mark, on the roller and above the lines.
Label mark_label(const Contacts& contacts, Interface i, double distance) {
  const auto [x, y] = contact_mm(contacts, i);
  const double up = distance * per_si::millimetre;
  return {letter(i), x + (i == Interface::screw ? up : -up), y + up, false, Label::Anchor::centre};
}

Panel mechanism_panel(const Contacts& contacts) {
  const contact::MechanismGeometry& threads = contacts.threads;
  Panel panel;
  panel.title = "Projection along the axis";
  for (const Part part : {Part::screw, Part::nut})
    panel.series.push_back({style_of(part), {whole(body_circle(threads, part))}});
  Series rollers{kRollerCircle, {}};
  const int count = std::max(1, contacts.mechanism.rollers);
  for (int k = 0; k < count; ++k)
    rollers.parts.push_back(whole(roller_circle(threads, 2.0 * std::numbers::pi * k / count)));
  panel.series.push_back(std::move(rollers));
  const double reach = 1.06 * threads.nut.pitch_radius;
  panel.series.push_back({kCentres,
                          {{point_mm(-reach, 0.0), point_mm(reach, 0.0)},
                           {point_mm(0.0, -reach), point_mm(0.0, reach)}}});
  panel.series.push_back(
      {kContactPoints,
       {{contact_mm(contacts, Interface::screw)}, {contact_mm(contacts, Interface::nut)}}});
  for (const Interface i : kInterfaces)
    panel.labels.push_back(mark_label(contacts, i, 0.3 * threads.roller.pitch_radius));
  panel.x = axis_about("x", 0.0, reach);
  panel.y = axis_about("y", 0.0, reach);
  return panel;
}

Panel contact_panel(const Contacts& contacts, Interface i) {
  const contact::MechanismGeometry& threads = contacts.threads;
  const contact::ContactPoint& point = contacts.interfaces[i].geometry.point;
  const Circle body = body_circle(threads, body_of(i));
  const Circle roller = roller_circle(threads, 0.0);
  // Between the contact point and the point where the body's pitch circle meets the centre line.
  const double dx = point.position.x - body.radius;
  const double dy = point.position.y;
  const double half = std::max(0.75 * std::hypot(dx, dy), 0.04 * roller.radius);
  const double reach = 8.0 * half;

  Panel panel;
  panel.title = fmt::format("{}: {}° {}, {}° roller", letter(i),
                            number(point.angle_on_body * per_si::degree, 2), title(body.part),
                            number(point.angle_on_roller * per_si::degree, 2));
  panel.series.push_back({style_of(body.part), {near_line_of_centres(body, 1.0, reach)}});
  panel.series.push_back(
      {kRollerCircle, {near_line_of_centres(roller, i == Interface::screw ? -1.0 : 1.0, reach)}});
  panel.series.push_back(
      {kCentres, {{point_mm(0.0, 0.0), point_mm(threads.nut.pitch_radius + reach, 0.0)}}});
  const auto at = contact_mm(contacts, i);
  panel.series.push_back({kRadii, {{point_mm(0.0, 0.0), at}, {point_mm(roller.x, 0.0), at}}});
  panel.series.push_back({kContactPoints, {{at}}});
  panel.labels.push_back(mark_label(contacts, i, 0.15 * half));
  panel.x = axis_about("x", body.radius + 0.5 * dx, half);
  panel.y = axis_about("y", 0.5 * dy, half);
  return panel;
}

}  // namespace

/// Pitch circles of all parts along the axis and each contact point enlarged, with the angles
/// between the line of centres and the point about both axes.
Figures contact_xy(const Contacts& contacts) {
  if (!has_contact_points(contacts)) return {};
  Figure figure{"contact_xy", "Contact points seen along the axis, " + mechanism_title(contacts)};
  figure.columns = 2;
  figure.overview = 1.75;
  figure.to_scale = true;
  add_circle_styles(figure);
  figure.panels = {mechanism_panel(contacts), contact_panel(contacts, Interface::nut),
                   contact_panel(contacts, Interface::screw)};
  return {std::move(figure)};
}

}  // namespace prs
