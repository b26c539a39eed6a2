#include "prs/loads/contact_figures.h"

#include "prs/loads/load_record.h"
#include "prs/record/table_units.h"

namespace prs {
namespace {

// Pictures of the contacts are drawings to scale in configuration I1J2 (Sandu 2018, section 1.3):
// frame of the screw, z along its axis, x towards the axis of the first roller.

constexpr Style kContactMark = points_of(Colour::ink, Mark::circle);
constexpr Style kAxisLine = line_of(Colour::reference, Dash::dash_dotted, Weight::thin);

/// Sandu's letter for the contact point.
constexpr const char* letter(Interface i) { return i == Interface::screw ? "I" : "J"; }

bool has_contact_points(const Contacts& contacts) {
  return contacts.interfaces.screw.geometry.ok() && contacts.interfaces.nut.geometry.ok();
}

/// Name of the drawn mechanism: `inverted screw 21 × 5 mm`.
std::string mechanism_title(const Contacts& contacts) {
  const contact::MechanismGeometry& threads = contacts.threads;
  return fmt::format("{}{} screw {} × {}", threads.screw.lead < 0.0 ? "left-handed " : "",
                     contact::facts_of(threads.type).name,
                     table_number(fmt::format("{:.4g}", 2.0 * threads.screw.pitch_radius * "mm"_per_si), "mm"),
                     in_table_unit(fmt::format("{:.4g} mm", std::abs(threads.screw.lead) * "mm"_per_si)));
}

/// A range about its middle [m], shown in mm.
Axis axis_about(std::string label, double middle, double half) {
  return {std::move(label), "mm", (middle - half) * "mm"_per_si, (middle + half) * "mm"_per_si};
}

/// A point of a drawing [mm], from its coordinates [m].
std::array<double, 2> point_mm(double x, double y) { return {x * "mm"_per_si, y * "mm"_per_si}; }

constexpr int kFlankPoints = 24;

/// One side of a thread, cut by a plane parallel to the axes. The thread's material or, for a nut,
/// the air inside it lies between axis and outline. SI units.
struct Cut {
  contact::Thread thread;
  double axis = 0.0;    ///< x of the thread's axis.
  double side = 1.0;    ///< +1 where x grows away from that axis, else -1.
  double plane = 0.0;   ///< y of the section plane.
  double origin = 0.0;  ///< z of the thread's origin.
};

/// Both threads of an interface, cut through the contact point, the roller's origin at z = 0.
struct InterfaceCut {
  Cut body;
  Cut roller;
  double contact_z = 0.0;  ///< Contact point next to z = 0.
  double contact_x = 0.0;
};

/// z of a point of a thread above its origin, on the bottom (+1) or top (-1) face.
double height(const contact::ThreadSurface& surface, double face, double radius, double angle) {
  return face * surface.profile(radius).height + angle * surface.reduced_lead;
}

InterfaceCut cut_through_contact(const Contacts& contacts, Interface i) {
  const contact::ContactPoint& point = contacts.interfaces[i].geometry.point;
  const contact::ThreadPair pair = pair_of(contacts.threads, i);
  constexpr auto kLoaded = contact::Configuration::i1_j2;
  const auto face =
      static_cast<double>(i == Interface::screw ? roller_face_at_screw(kLoaded) : roller_face_at_nut(kLoaded));
  const double on_roller = height(pair.roller, face, point.radius_on_roller, point.angle_on_roller);
  const double on_body = height(pair.body, -pair.body.side * face, point.radius_on_body, point.angle_on_body);

  InterfaceCut cut;
  cut.contact_z = std::remainder(on_roller, pair.roller.pitch);
  cut.contact_x = point.position.x;
  cut.body = {i == Interface::screw ? contacts.threads.screw : contacts.threads.nut, 0.0, 1.0, point.position.y,
              cut.contact_z - on_body};
  cut.roller = {contacts.threads.roller, pair.centre_distance, i == Interface::screw ? -1.0 : 1.0, point.position.y,
                0.0};
  return cut;
}

/// Radii on the flank from root to crest, without the ends where an arc may be perpendicular.
std::array<double, kFlankPoints> flank_radii(const contact::Thread& thread) {
  const contact::RadiusLimits usable = contact::usable_limits(contact::ThreadSurface(thread));
  const contact::RadiusLimits sharp = contact::sharp_limits(thread);
  const double from = std::max(usable.smallest, sharp.smallest);
  const double to = std::min(usable.largest, sharp.largest);
  std::array<double, kFlankPoints> radii;
  for (int k = 0; k < kFlankPoints; ++k)
    radii[static_cast<std::size_t>(k)] = std::lerp(from, to, std::clamp(k / (kFlankPoints - 1.0), 1e-9, 1.0 - 1e-9));
  return radii;
}

/// The thread's outline from about -half_length to half_length: (z, x) in mm.
Polyline outline(const Cut& cut, double half_length) {
  const contact::ThreadSurface surface(cut.thread);
  const auto radii = flank_radii(cut.thread);
  const auto point = [&](double radius, double rise) {
    const double from_axis = cut.side * std::sqrt(std::max(0.0, radius * radius - cut.plane * cut.plane));
    const double angle = std::atan2(cut.plane, from_axis);
    return point_mm(cut.origin + rise + angle * surface.reduced_lead, cut.axis + from_axis);
  };
  const double middle = point(surface.pitch_radius, 0.0)[0] / "mm"_per_si;
  const double first = std::floor((-half_length - middle) / surface.pitch) - 1.0;
  const double last = std::ceil((half_length - middle) / surface.pitch);
  Polyline line;
  for (double groove = first; groove <= last; ++groove) {
    for (auto r = radii.begin(); r != radii.end(); ++r)
      line.push_back(point(*r, groove * surface.pitch + surface.profile(*r).height));
    for (auto r = radii.rbegin(); r != radii.rend(); ++r)
      line.push_back(point(*r, (groove + 1.0) * surface.pitch - surface.profile(*r).height));
  }
  return line;
}

/// Area of the material between the outline and a line parallel to the axis.
Polyline filled_to(const Polyline& outline, double x) {
  Polyline polygon = outline;
  polygon.push_back({outline.back()[0], x * "mm"_per_si});
  polygon.push_back({outline.front()[0], x * "mm"_per_si});
  return polygon;
}

/// Contact points along the axis; parts of different pitch touch at one thread.
Polyline contact_points(const InterfaceCut& cut, double half_length) {
  const double pitch = cut.roller.thread.pitch;
  const bool same = contact::same_pitch(cut.body.thread.pitch, pitch);
  const int each_side = same ? static_cast<int>(half_length / pitch) : 0;
  Polyline points;
  for (int k = -each_side; k <= each_side; ++k) points.push_back(point_mm(cut.contact_z + k * pitch, cut.contact_x));
  return points;
}

/// The complete drawing; the panels show parts of it.
struct Section {
  PerInterface<InterfaceCut> cuts;
  double inside = 0.0;   ///< x, inside the screw's root.
  double outside = 0.0;  ///< x, outside the nut's root.
};

Section section_of(const Contacts& contacts) {
  Section section;
  for (const Interface i : kInterfaces) section.cuts[i] = cut_through_contact(contacts, i);
  const contact::MechanismGeometry& threads = contacts.threads;
  const double margin = 0.5 * threads.roller.pitch;
  section.inside = contact::flank_limits(threads.screw).smallest - margin;
  section.outside = contact::flank_limits(threads.nut).largest + margin;
  return section;
}

Series polygons(Figure& figure, Part part, std::vector<Polyline> parts) {
  Style style = area_of(colour_of(part));
  style.pale = true;
  return {figure.add(std::string(title(part)), style), std::move(parts)};
}

Series outlines(Figure& figure, Part part, std::vector<Polyline> parts) {
  return {figure.add(line_of(colour_of(part))), std::move(parts)};
}

std::vector<Series> section_lines(Figure& figure, const Section& section) {
  // Long enough for panels up to twice as wide as high, with material beyond them.
  const double length = 2.0 * (section.outside - section.inside);
  const auto& [at_screw, at_nut] = section.cuts;
  const Polyline screw = outline(at_screw.body, length);
  const Polyline nut = outline(at_nut.body, length);
  const std::vector<Polyline> roller = {outline(at_screw.roller, length), outline(at_nut.roller, length)};
  const double axis = at_screw.roller.axis;
  std::vector<Series> lines;
  lines.push_back(polygons(figure, Part::screw, {filled_to(screw, section.inside - length)}));
  lines.push_back(polygons(figure, Part::roller, {filled_to(roller[0], axis), filled_to(roller[1], axis)}));
  lines.push_back(polygons(figure, Part::nut, {filled_to(nut, section.outside + length)}));
  lines.push_back(outlines(figure, Part::screw, {screw}));
  lines.push_back(outlines(figure, Part::roller, roller));
  lines.push_back(outlines(figure, Part::nut, {nut}));
  lines.push_back(
      {figure.add("roller axis", kAxisLine), {{point_mm(-2.0 * length, axis), point_mm(2.0 * length, axis)}}});
  lines.push_back({figure.add("contact points I, J", kContactMark),
                   {contact_points(at_screw, length), contact_points(at_nut, length)}});
  return lines;
}

/// Adds the backlash. The other two faces are closest on the other side of the plane of the axes, by symmetry; the gap
/// in this section is then not the backlash.
void add_backlash(Panel& panel, const InterfaceCut& cut, double backlash) {
  constexpr double kVisible = 1e-6;  // [m]
  if (!contact::same_pitch(cut.body.thread.pitch, cut.roller.thread.pitch)) return;
  panel.labels.push_back({"backlash " + in_table_unit(number(backlash * "mm"_per_si, 3) + " mm"), 0.03, 0.93, true});
  if (std::abs(cut.body.plane) > kVisible) panel.labels.push_back({"other flanks nearest at −y", 0.03, 0.85, true});
}

Panel contact_panel(const Contacts& contacts, const InterfaceCut& cut, Interface i, const std::vector<Series>& lines) {
  const double half = 0.45 * cut.roller.thread.pitch;
  Panel panel{fmt::format("{} at {}, y = {}", interface_title(i), letter(i),
                          in_table_unit(number(cut.body.plane * "mm"_per_si, 3) + " mm"))};
  panel.series = lines;
  panel.labels.push_back({letter(i), (cut.contact_z + 0.12 * half) * "mm"_per_si, cut.contact_x * "mm"_per_si});
  add_backlash(panel, cut, contacts.interfaces[i].geometry.point.backlash);
  panel.x = axis_about("z", cut.contact_z, half);
  panel.y = axis_about("x", cut.contact_x, half);
  return panel;
}

/// The three threads cut parallel to their axes: the section is stepped at the roller's axis and passes through the
/// contact points on both sides, so that the loaded flanks touch as they do in space. An overview and each contact
/// enlarged (Sandu 2018, figs. 1.8, 1.9). Parts of different pitch touch at one thread.
Figure contact_axial_section(const Contacts& contacts) {
  if (!has_contact_points(contacts)) return {};
  const Section section = section_of(contacts);
  Figure figure{"contact_axial_section", "Section through I and J, configuration I1J2, " + mechanism_title(contacts)};
  figure.columns = 2;
  figure.overview = 1.1;
  figure.to_scale = true;
  const std::vector<Series> lines = section_lines(figure, section);
  const double half = 0.5 * (section.outside - section.inside);
  Panel& whole = figure.panels.emplace_back(Panel{"Section stepped at the roller axis"});
  whole.series = lines;
  whole.x = axis_about("z", 0.0, 0.1 * half);
  whole.y = axis_about("x from the screw axis", section.inside + half, half);
  for (const Interface i : {Interface::nut, Interface::screw})
    figure.panels.push_back(contact_panel(contacts, section.cuts[i], i, lines));
  return figure;
}

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
    points.push_back(point_mm(circle.x + circle.radius * std::cos(angle), circle.y + circle.radius * std::sin(angle)));
  }
  return points;
}

Polyline whole(const Circle& circle) { return arc(circle, 0.0, 2.0 * std::numbers::pi); }

/// Part of the circle within `reach` of its intersection with the line of centres.
Polyline near_line_of_centres(const Circle& circle, double side, double reach) {
  const double middle = side > 0.0 ? 0.0 : std::numbers::pi;
  const double half = std::min(reach / circle.radius, std::numbers::pi);
  return arc(circle, middle - half, middle + half);
}

Circle body_circle(const contact::MechanismGeometry& threads, Part part) {
  return {part, 0.0, 0.0, part == Part::screw ? threads.screw.pitch_radius : threads.nut.pitch_radius};
}

Circle roller_circle(const contact::MechanismGeometry& threads, double angle) {
  return {Part::roller, threads.centre_distance * std::cos(angle), threads.centre_distance * std::sin(angle),
          threads.roller.pitch_radius};
}

std::array<double, 2> contact_mm(const Contacts& contacts, Interface i) {
  const contact::Vector2<double>& position = contacts.interfaces[i].geometry.point.position;
  return point_mm(position.x, position.y);
}

/// Styles of the figure in the order of their legend.
enum CircleStyle : std::size_t { kScrewCircle, kRollerCircle, kNutCircle, kCentres, kRadii, kContactPoints };

void add_circle_styles(Figure& figure) {
  for (const Part part : kParts) figure.add(fmt::format("pitch circle, {}", title(part)), line_of(colour_of(part)));
  figure.add("line of centres", kAxisLine);
  figure.add("radii to the contact", line_of(Colour::ink, Dash::dashed, Weight::thin));
  figure.add("contact points I, J", kContactMark);
}

std::size_t style_of(Part part) { return static_cast<std::size_t>(part); }

/// Label of the contact point next to its mark, on the roller and above the lines.
Label mark_label(const Contacts& contacts, Interface i, double distance) {
  const auto [x, y] = contact_mm(contacts, i);
  const double up = distance * "mm"_per_si;
  return {letter(i), x + (i == Interface::screw ? up : -up), y + up, false, Label::Anchor::centre};
}

Panel mechanism_panel(const Contacts& contacts) {
  const contact::MechanismGeometry& threads = contacts.threads;
  Panel panel{"Projection along the axis"};
  for (const Part part : {Part::screw, Part::nut})
    panel.series.push_back({style_of(part), {whole(body_circle(threads, part))}});
  Series rollers{kRollerCircle, {}};
  const int count = std::max(1, contacts.mechanism.rollers);
  for (int k = 0; k < count; ++k)
    rollers.parts.push_back(whole(roller_circle(threads, 2.0 * std::numbers::pi * k / count)));
  panel.series.push_back(std::move(rollers));
  const double reach = 1.06 * threads.nut.pitch_radius;
  panel.series.push_back(
      {kCentres, {{point_mm(-reach, 0.0), point_mm(reach, 0.0)}, {point_mm(0.0, -reach), point_mm(0.0, reach)}}});
  panel.series.push_back(
      {kContactPoints, {{contact_mm(contacts, Interface::screw)}, {contact_mm(contacts, Interface::nut)}}});
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

  Panel panel{fmt::format("{}: {}° {}, {}° roller", letter(i), number(point.angle_on_body * "deg"_per_si, 2),
                          title(body.part), number(point.angle_on_roller * "deg"_per_si, 2))};
  panel.series.push_back({style_of(body.part), {near_line_of_centres(body, 1.0, reach)}});
  panel.series.push_back({kRollerCircle, {near_line_of_centres(roller, i == Interface::screw ? -1.0 : 1.0, reach)}});
  panel.series.push_back({kCentres, {{point_mm(0.0, 0.0), point_mm(threads.nut.pitch_radius + reach, 0.0)}}});
  const auto at = contact_mm(contacts, i);
  panel.series.push_back({kRadii, {{point_mm(0.0, 0.0), at}, {point_mm(roller.x, 0.0), at}}});
  panel.series.push_back({kContactPoints, {{at}}});
  panel.labels.push_back(mark_label(contacts, i, 0.15 * half));
  panel.x = axis_about("x", body.radius + 0.5 * dx, half);
  panel.y = axis_about("y", 0.5 * dy, half);
  return panel;
}

/// Pitch circles of all parts along the axis and each contact point enlarged, with the angles
/// between the line of centres and the point about both axes.
Figure contact_xy(const Contacts& contacts) {
  if (!has_contact_points(contacts)) return {};
  Figure figure{"contact_xy", "Contact points seen along the axis, " + mechanism_title(contacts)};
  figure.columns = 2;
  figure.overview = 1.75;
  figure.to_scale = true;
  add_circle_styles(figure);
  figure.panels = {mechanism_panel(contacts), contact_panel(contacts, Interface::nut),
                   contact_panel(contacts, Interface::screw)};
  return figure;
}

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

/// An ellipse as drawn: in mm, or with the major semi-axis 1 if there is no load.
struct DrawnEllipse {
  double semi_major = 1.0;
  double semi_minor = 1.0;
  std::string state;  ///< Load and pressure, or the ellipticity.
};

/// A thread under load.
struct LoadedThread {
  const LoadCaseResult* load_case = nullptr;
  std::size_t thread = 0;
};

/// Thread with the largest normal load among those with an ellipse at the interface.
std::optional<LoadedThread> most_loaded(const Result& result, Interface i) {
  std::optional<LoadedThread> most;
  double largest = 0.0;
  for (const LoadCaseResult& load_case : result.load_cases) {
    if (!load_case.threads || (*load_case.threads)[i].semi_major.empty()) continue;
    const std::vector<double>& loads = (*load_case.threads)[i].normal_load;
    const std::size_t thread = *index_of_largest(loads);
    if (loads[thread] <= largest) continue;
    largest = loads[thread];
    most = {&load_case, thread};
  }
  return most;
}

DrawnEllipse loaded_ellipse(const LoadedThread& at, Interface i) {
  const InterfaceLoads& loads = (*at.load_case->threads)[i];
  const std::size_t k = at.thread;
  return {loads.semi_major[k] * "mm"_per_si, loads.semi_minor[k] * "mm"_per_si,
          fmt::format("{}, {}", in_table_unit(fmt::format("{:.4g} N", loads.normal_load[k])),
                      in_table_unit(fmt::format("{:.3f} GPa", loads.peak_pressure[k] * "GPa"_per_si)))};
}

/// Ellipse without load; absent if the relative curvatures give none.
std::optional<DrawnEllipse> unit_ellipse(const contact::InterfaceGeometry& geometry) {
  const double ratio = geometry.relative.first / geometry.relative.second;
  if (!(ratio > 0.0 && ratio <= 1.0)) return std::nullopt;
  const double ellipticity = contact::ellipticity(ratio);
  return DrawnEllipse{1.0, ellipticity, fmt::format("b/a = {:.4f}", ellipticity)};
}

/// Point of the tangent plane in its frame (helix tangent, n x helix tangent), `angle` from the
/// first.
std::array<double, 2> polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Polyline diameter(double angle, double half_length) { return {polar(-half_length, angle), polar(half_length, angle)}; }

/// Styles of the figure in the order of their legend; of the two directions only the first is listed.
enum EllipseStyle : std::size_t { kInside, kOutline, kScrew, kRoller = kScrew + 2, kNut = kRoller + 2 };

void add_ellipse_styles(Figure& figure) {
  Style inside = area_of(Colour::grey);
  inside.pale = true;
  figure.add("contact ellipse", inside);
  figure.add("semi-axes", line_of(Colour::ink));
  for (const Part part : kParts) {
    const Colour colour = colour_of(part);
    figure.add(fmt::format("{}, direction 1", title(part)), line_of(colour));
    figure.add(fmt::format("{}, direction 2", title(part)), line_of(colour, Dash::dashed));
  }
}

void add_directions(Panel& panel, std::size_t style, double first_angle, double half_length) {
  panel.series.push_back({style, {diameter(first_angle, half_length)}});
  panel.series.push_back({style + 1, {diameter(first_angle + kQuarterTurn, half_length)}});
}

void add_semi_axis_labels(Panel& panel, const DrawnEllipse& ellipse, double major, bool loaded) {
  const double a = ellipse.semi_major, b = ellipse.semi_minor;
  const auto letter_at = [&](const char* name, double radius, double angle) {
    const auto [x, y] = polar(radius + 0.1 * a, angle);
    panel.labels.push_back({name, x, y, false, Label::Anchor::centre});
  };
  letter_at("a", a, major);
  letter_at("b", b, major + kQuarterTurn);
  if (loaded) panel.labels.push_back({semi_axes_text(a, b), 0.03, 0.04, true});
}

Panel ellipse_panel(const contact::InterfaceGeometry& geometry, const DrawnEllipse& ellipse, Interface i, bool loaded) {
  const double a = ellipse.semi_major, b = ellipse.semi_minor;
  const double major = geometry.relative.angle;
  const Polyline ellipse_line = prs::ellipse(0.0, 0.0, a, b, major);
  Panel panel{fmt::format("{}: {}", interface_title(i), ellipse.state)};
  panel.series.push_back({kInside, {ellipse_line}});
  add_directions(panel, i == Interface::screw ? kScrew : kNut, geometry.body.angle, 1.35 * a);
  add_directions(panel, kRoller, geometry.roller.angle, 1.2 * a);
  panel.series.push_back({kOutline, {ellipse_line, diameter(major, a), diameter(major + kQuarterTurn, b)}});
  add_semi_axis_labels(panel, ellipse, major, loaded);
  return panel;
}

std::string state_title(const PerInterface<std::optional<LoadedThread>>& at) {
  if (!at.screw || !at.nut) return "shape without load";
  const LoadCaseResult* load_case = at.screw->load_case;
  if (load_case != at.nut->load_case) return "largest normal loads";
  return "load case " + shown_name(load_case->load_case.name);
}

/// Both contact ellipses with the principal directions of both bodies, in the tangent planes and seen from outside the
/// roller (Sandu 2018, fig. 1.16; Yao 2023, fig. 5): under the largest normal load of the cases, or with unit major
/// semi-axes if no case has ellipses. Absent also if the relative curvatures give no ellipse.
Figure contact_ellipses(const Result& result, const FigureOptions&) {
  const Contacts& contacts = result.contacts;
  if (!has_contact_points(contacts)) return {};
  const PerInterface<std::optional<LoadedThread>> at = {most_loaded(result, Interface::screw),
                                                        most_loaded(result, Interface::nut)};
  const bool loaded = at.screw && at.nut;
  Figure figure{"contact_ellipses", "Contact ellipses, " + state_title(at)};
  figure.columns = std::size(kInterfaces);
  figure.to_scale = true;
  figure.aspect = 0.9;
  add_ellipse_styles(figure);
  double largest = 0.0;
  for (const Interface i : kInterfaces) {
    const contact::InterfaceGeometry& geometry = contacts.interfaces[i].geometry;
    const std::optional<DrawnEllipse> drawn = loaded ? loaded_ellipse(*at[i], i) : unit_ellipse(geometry);
    if (!drawn) return {};
    figure.panels.push_back(ellipse_panel(geometry, *drawn, i, loaded));
    largest = std::max(largest, drawn->semi_major);
  }
  const char* unit = loaded ? "mm" : "semi-major axes";
  figure.x = {"along the roller helix", unit, -1.55 * largest, 1.55 * largest};
  figure.y = {"across the flank", unit, -1.55 * largest, 1.55 * largest};
  return figure;
}

}  // namespace

Pictures contact_drawings(const Result& r) {
  constexpr const char* kNeeds = "a contact point at both interfaces";
  return {{"contact_axial_section", kNeeds, of_result(r.contacts, contact_axial_section)},
          {"contact_xy", kNeeds, of_result(r.contacts, contact_xy)},
          {"contact_ellipses", kNeeds, of_result(r, contact_ellipses)}};
}

std::string semi_axes_text(double a, double b) {
  return fmt::format("a = {}, b = {}", in_table_unit(fmt::format("{:.4f} mm", a)),
                     in_table_unit(fmt::format("{:.4f} mm", b)));
}

}  // namespace prs
