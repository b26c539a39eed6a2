#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/hertz.h"
#include "prs/quantities/quantities.h"
#include "prs/model/units.h"
#include "prs/figures/contact_figures.h"
#include "prs/figures/contact_figures_style.h"
#include "prs/figures/figure_style.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

/// An ellipse as it is drawn: in mm, or with the major semi-axis 1 where there is no load.
struct Ellipse {
  double semi_major = 1.0;
  double semi_minor = 1.0;
  std::string state;  ///< Load and pressure, or the ellipticity.
};

/// A thread under load.
struct LoadedThread {
  const LoadCaseResult* load_case = nullptr;
  std::size_t thread = 0;
};

/// The one with the largest normal load among those that have an ellipse at the interface.
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

Ellipse loaded_ellipse(const LoadedThread& at, Interface i) {
  const InterfaceLoads& loads = (*at.load_case->threads)[i];
  const std::size_t k = at.thread;
  return {loads.semi_major[k] * per_si::millimetre, loads.semi_minor[k] * per_si::millimetre,
          fmt::format("{:.4g} N, {:.3f} GPa", loads.normal_load[k],
                      loads.peak_pressure[k] * per_si::gigapascal)};
}

/// Absent where the relative curvatures give no ellipse.
std::optional<Ellipse> unit_ellipse(const contact::InterfaceGeometry& geometry) {
  const double ratio = geometry.relative.first / geometry.relative.second;
  if (!(ratio > 0.0 && ratio <= 1.0)) return std::nullopt;
  const double ellipticity = contact::ellipticity(ratio);
  return Ellipse{1.0, ellipticity, fmt::format("b/a = {:.4f}", ellipticity)};
}

/// Point of the tangent plane in its frame (helix tangent, n x helix tangent), `angle` from the
/// first.
std::array<double, 2> polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Polyline diameter(double angle, double half_length) {
  return {polar(-half_length, angle), polar(half_length, angle)};
}

Polyline outline(const Ellipse& ellipse, double major_angle) {
  constexpr int kPoints = 120;
  const double c = std::cos(major_angle), s = std::sin(major_angle);
  Polyline points;
  for (int k = 0; k <= kPoints; ++k) {
    const double t = 2.0 * std::numbers::pi * k / kPoints;
    const double u = ellipse.semi_major * std::cos(t), v = ellipse.semi_minor * std::sin(t);
    points.push_back({c * u - s * v, s * u + c * v});
  }
  return points;
}

/// Styles of the figure in the order of their legend; of the directions, the second follows.
enum Style : std::size_t { kInside, kOutline, kScrew, kRoller = kScrew + 2, kNut = kRoller + 2 };

void add_styles(Figure& figure) {
  add_to_legend(figure, "contact ellipse", fill_of("#dddddd"));
  add_to_legend(figure, "semi-axes", {"#000000", 1, 0, 1.6});
  for (const Part part : kParts) {
    const std::string_view colour = kPartColours[part].outline;
    add_to_legend(figure, fmt::format("{}, direction 1", title(part)), {colour, 1, 0, 2.0});
    add_to_legend(figure, fmt::format("{}, direction 2", title(part)), {colour, 2, 0, 1.4});
  }
}

void add_directions(Panel& panel, std::size_t style, double first_angle, double half_length) {
  panel.lines.push_back({style, {diameter(first_angle, half_length)}});
  panel.lines.push_back({style + 1, {diameter(first_angle + kQuarterTurn, half_length)}});
}

void add_semi_axis_labels(Panel& panel, const Ellipse& ellipse, double major, bool loaded) {
  const double a = ellipse.semi_major, b = ellipse.semi_minor;
  const auto letter_at = [&](const char* letter, double radius, double angle) {
    const auto [x, y] = polar(radius + 0.1 * a, angle);
    panel.labels.push_back({letter, x, y, false, true});
  };
  letter_at("a", a, major);
  letter_at("b", b, major + kQuarterTurn);
  if (loaded)
    panel.labels.push_back({fmt::format("a = {:.4f} mm, b = {:.4f} mm", a, b), 0.03, 0.04, true});
}

Panel ellipse_panel(const contact::InterfaceGeometry& geometry, const Ellipse& ellipse, Interface i,
                    bool loaded) {
  const double a = ellipse.semi_major, b = ellipse.semi_minor;
  const double major = geometry.relative.angle;
  const Polyline ellipse_line = outline(ellipse, major);
  Panel panel;
  panel.title = fmt::format("{}: {}", interface_title(i), ellipse.state);
  panel.lines.push_back({kInside, {ellipse_line}});
  add_directions(panel, i == Interface::screw ? kScrew : kNut, geometry.body.angle, 1.35 * a);
  add_directions(panel, kRoller, geometry.roller.angle, 1.2 * a);
  panel.lines.push_back(
      {kOutline, {ellipse_line, diameter(major, a), diameter(major + kQuarterTurn, b)}});
  add_semi_axis_labels(panel, ellipse, major, loaded);
  return panel;
}

std::string state_title(const PerInterface<std::optional<LoadedThread>>& at) {
  if (!at.screw || !at.nut) return "shape without load";
  const LoadCaseResult* load_case = at.screw->load_case;
  if (load_case != at.nut->load_case) return "largest normal loads";
  return "load case " + shortened(printable(load_case->load_case.name), kMaxCaseName);
}

}  // namespace

std::optional<Figure> contact_ellipse_figure(const Result& result) {
  const Contacts& contacts = result.contacts;
  if (!has_contact_points(contacts)) return std::nullopt;
  const PerInterface<std::optional<LoadedThread>> at = {most_loaded(result, Interface::screw),
                                                        most_loaded(result, Interface::nut)};
  const bool loaded = at.screw && at.nut;
  Figure figure;
  figure.name = "contact_ellipses";
  figure.title = "Contact ellipses, " + state_title(at);
  figure.columns = std::size(kInterfaces);
  figure.panel_height = 345;
  figure.to_scale = true;
  add_styles(figure);
  double largest = 0.0;
  for (const Interface i : kInterfaces) {
    const contact::InterfaceGeometry& geometry = contacts.interfaces[i].geometry;
    const std::optional<Ellipse> ellipse =
        loaded ? loaded_ellipse(*at[i], i) : unit_ellipse(geometry);
    if (!ellipse) return std::nullopt;
    figure.panels.push_back(ellipse_panel(geometry, *ellipse, i, loaded));
    largest = std::max(largest, ellipse->semi_major);
  }
  const char* unit = loaded ? " (mm)" : " (semi-major axes)";
  figure.x = {fmt::format("along the roller helix{}", unit), -1.55 * largest, 1.55 * largest};
  figure.y = {fmt::format("across the flank{}", unit), -1.55 * largest, 1.55 * largest};
  return figure;
}

std::vector<Figure> contact_figures(const Result& result) {
  return drawable(contact_section_figure(result), contact_xy_figure(result),
                  contact_ellipse_figure(result));
}

std::vector<std::string> contacts_without_figure(const Result& result) {
  std::vector<std::string> notes;
  for (const Interface i : kInterfaces)
    if (!result.contacts.interfaces[i].geometry.ok())
      notes.push_back(fmt::format(
          "pictures of the contacts were not drawn: the {} threads have no contact point ({})",
          label(i), failure(result.contacts, i).reason));
  return notes;
}

}  // namespace prs
