#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/contact_point.h"
#include "contact/thread_surface.h"
#include "prs/loads/contact_parts.h"

namespace prs {
namespace {

constexpr int kFlankPoints = 24;

/// One side of a thread, cut by a plane parallel to the axes. The thread's material or, for a nut,
/// the air inside it lies between axis and outline. SI units.
struct Cut {
  contact::Thread thread;
  double axis = 0.0;    ///< x of the thread's axis.
  double side = 1.0;    ///< +1 where x grows away from that axis, else -1.
  double plane = 0.0;   ///< y of the section.
  double origin = 0.0;  ///< z of the thread's origin.
};

/// Both threads of an interface, cut through the contact point, the roller's origin at z = 0.
struct InterfaceCut {
  Cut body;
  Cut roller;
  double contact_z = 0.0;  ///< Of the contact point next to z = 0.
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
  const auto face = static_cast<double>(i == Interface::screw ? roller_face_at_screw(kLoaded)
                                                              : roller_face_at_nut(kLoaded));
  const double on_roller = height(pair.roller, face, point.radius_on_roller, point.angle_on_roller);
  const double on_body =
      height(pair.body, -pair.body.side * face, point.radius_on_body, point.angle_on_body);

  InterfaceCut cut;
  cut.contact_z = std::remainder(on_roller, pair.roller.pitch);
  cut.contact_x = point.position.x;
  cut.body = {i == Interface::screw ? contacts.threads.screw : contacts.threads.nut, 0.0, 1.0,
              point.position.y, cut.contact_z - on_body};
  cut.roller = {contacts.threads.roller, pair.centre_distance, i == Interface::screw ? -1.0 : 1.0,
                point.position.y, 0.0};
  return cut;
}

/// Radii on the flank from root to crest, away from the ends where an arc may stand square.
std::array<double, kFlankPoints> flank_radii(const contact::Thread& thread) {
  const contact::RadiusLimits usable = contact::usable_limits(contact::ThreadSurface(thread));
  const contact::RadiusLimits sharp = contact::sharp_limits(thread);
  const double from = std::max(usable.smallest, sharp.smallest);
  const double to = std::min(usable.largest, sharp.largest);
  std::array<double, kFlankPoints> radii;
  for (int k = 0; k < kFlankPoints; ++k)
    radii[static_cast<std::size_t>(k)] =
        std::lerp(from, to, std::clamp(k / (kFlankPoints - 1.0), 1e-9, 1.0 - 1e-9));
  return radii;
}

/// The thread's outline from about -half_length to half_length: (z, x) in mm.
Polyline outline(const Cut& cut, double half_length) {
  const contact::ThreadSurface surface(cut.thread);
  const auto radii = flank_radii(cut.thread);
  const auto point = [&](double radius, double rise) {
    const double from_axis =
        cut.side * std::sqrt(std::max(0.0, radius * radius - cut.plane * cut.plane));
    const double angle = std::atan2(cut.plane, from_axis);
    return point_mm(cut.origin + rise + angle * surface.reduced_lead, cut.axis + from_axis);
  };
  const double middle = point(surface.pitch_radius, 0.0)[0] / per_si::millimetre;
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

/// The material between the outline and a line parallel to the axis.
Polyline filled_to(const Polyline& outline, double x) {
  Polyline polygon = outline;
  polygon.push_back({outline.back()[0], x * per_si::millimetre});
  polygon.push_back({outline.front()[0], x * per_si::millimetre});
  return polygon;
}

/// Contact points along the axis; parts of different pitch touch at one thread.
Polyline contact_points(const InterfaceCut& cut, double half_length) {
  const double pitch = cut.roller.thread.pitch;
  const bool same = contact::same_pitch(cut.body.thread.pitch, pitch);
  const int each_side = same ? static_cast<int>(half_length / pitch) : 0;
  Polyline points;
  for (int k = -each_side; k <= each_side; ++k)
    points.push_back(point_mm(cut.contact_z + k * pitch, cut.contact_x));
  return points;
}

/// What is drawn, whole; the panels show parts of it.
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
  // Enough for panels up to twice as wide as high, and the material goes on beyond them.
  const double length = 2.0 * (section.outside - section.inside);
  const auto& [at_screw, at_nut] = section.cuts;
  const Polyline screw = outline(at_screw.body, length);
  const Polyline nut = outline(at_nut.body, length);
  const std::vector<Polyline> roller = {outline(at_screw.roller, length),
                                        outline(at_nut.roller, length)};
  const double axis = at_screw.roller.axis;
  std::vector<Series> lines;
  lines.push_back(polygons(figure, Part::screw, {filled_to(screw, section.inside - length)}));
  lines.push_back(
      polygons(figure, Part::roller, {filled_to(roller[0], axis), filled_to(roller[1], axis)}));
  lines.push_back(polygons(figure, Part::nut, {filled_to(nut, section.outside + length)}));
  lines.push_back(outlines(figure, Part::screw, {screw}));
  lines.push_back(outlines(figure, Part::roller, roller));
  lines.push_back(outlines(figure, Part::nut, {nut}));
  lines.push_back({figure.add("roller axis", kAxisLine),
                   {{point_mm(-2.0 * length, axis), point_mm(2.0 * length, axis)}}});
  lines.push_back({figure.add("contact points I, J", kContactMark),
                   {contact_points(at_screw, length), contact_points(at_nut, length)}});
  return lines;
}

/// The other two faces come closest on the other side of the plane of the axes, by symmetry; the
/// gap in this section is then not the backlash.
void add_backlash(Panel& panel, const InterfaceCut& cut, double backlash) {
  constexpr double kVisible = 1e-6;  // [m]
  if (!contact::same_pitch(cut.body.thread.pitch, cut.roller.thread.pitch)) return;
  panel.labels.push_back(
      {fmt::format("backlash {} mm", number(backlash * per_si::millimetre, 3)), 0.03, 0.93, true});
  if (std::abs(cut.body.plane) > kVisible)
    panel.labels.push_back({"other flanks nearest at −y", 0.03, 0.85, true});
}

Panel contact_panel(const Contacts& contacts, const InterfaceCut& cut, Interface i,
                    const std::vector<Series>& lines) {
  const double half = 0.45 * cut.roller.thread.pitch;
  Panel panel;
  panel.title = fmt::format("{} at {}, y = {} mm", interface_title(i), letter(i),
                            number(cut.body.plane * per_si::millimetre, 3));
  panel.series = lines;
  panel.labels.push_back({letter(i), (cut.contact_z + 0.12 * half) * per_si::millimetre,
                          cut.contact_x * per_si::millimetre});
  add_backlash(panel, cut, contacts.interfaces[i].geometry.point.backlash);
  panel.x = axis_about("z", cut.contact_z, half);
  panel.y = axis_about("x", cut.contact_x, half);
  return panel;
}

}  // namespace

/// The three threads cut parallel to their axes: the section is stepped at the roller's axis and
/// passes through the contact points on both sides, so that the loaded flanks touch where they do
/// in space. An overview and each contact enlarged (Sandu 2018, figs. 1.8, 1.9). Parts of different
/// pitch touch at one thread.
Figures contact_axial_section(const Contacts& contacts) {
  if (!has_contact_points(contacts)) return {};
  const Section section = section_of(contacts);
  Figure figure{"contact_axial_section",
                "Section through I and J, configuration I1J2, " + mechanism_title(contacts)};
  figure.columns = 2;
  figure.overview = 1.1;
  figure.to_scale = true;
  const std::vector<Series> lines = section_lines(figure, section);
  const double half = 0.5 * (section.outside - section.inside);
  Panel& whole = figure.panels.emplace_back();
  whole.title = "Section stepped at the roller axis";
  whole.series = lines;
  whole.x = axis_about("z", 0.0, 0.1 * half);
  whole.y = axis_about("x from the screw axis", section.inside + half, half);
  for (const Interface i : {Interface::nut, Interface::screw})
    figure.panels.push_back(contact_panel(contacts, section.cuts[i], i, lines));
  return {std::move(figure)};
}

}  // namespace prs
