#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/hertz.h"
#include "prs/loads/contact_parts.h"
#include "prs/loads/load_record.h"

namespace prs {
namespace {

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

/// An ellipse as it is drawn: in mm, or with the major semi-axis 1 where there is no load.
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

DrawnEllipse loaded_ellipse(const LoadedThread& at, Interface i) {
  const InterfaceLoads& loads = (*at.load_case->threads)[i];
  const std::size_t k = at.thread;
  return {loads.semi_major[k] * per_si::millimetre, loads.semi_minor[k] * per_si::millimetre,
          fmt::format("{:.4g} N, {:.3f} GPa", loads.normal_load[k],
                      loads.peak_pressure[k] * per_si::gigapascal)};
}

/// Absent where the relative curvatures give no ellipse.
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

Polyline diameter(double angle, double half_length) {
  return {polar(-half_length, angle), polar(half_length, angle)};
}

/// Styles of the figure in the order of their legend; of the directions, the second follows.
enum EllipseStyle : std::size_t {
  kInside,
  kOutline,
  kScrew,
  kRoller = kScrew + 2,
  kNut = kRoller + 2
};

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
  if (loaded)
    panel.labels.push_back({fmt::format("a = {:.4f} mm, b = {:.4f} mm", a, b), 0.03, 0.04, true});
}

Panel ellipse_panel(const contact::InterfaceGeometry& geometry, const DrawnEllipse& ellipse,
                    Interface i, bool loaded) {
  const double a = ellipse.semi_major, b = ellipse.semi_minor;
  const double major = geometry.relative.angle;
  const Polyline ellipse_line = prs::ellipse(0.0, 0.0, a, b, major);
  Panel panel;
  panel.title = fmt::format("{}: {}", interface_title(i), ellipse.state);
  panel.series.push_back({kInside, {ellipse_line}});
  add_directions(panel, i == Interface::screw ? kScrew : kNut, geometry.body.angle, 1.35 * a);
  add_directions(panel, kRoller, geometry.roller.angle, 1.2 * a);
  panel.series.push_back(
      {kOutline, {ellipse_line, diameter(major, a), diameter(major + kQuarterTurn, b)}});
  add_semi_axis_labels(panel, ellipse, major, loaded);
  return panel;
}

std::string state_title(const PerInterface<std::optional<LoadedThread>>& at) {
  if (!at.screw || !at.nut) return "shape without load";
  const LoadCaseResult* load_case = at.screw->load_case;
  if (load_case != at.nut->load_case) return "largest normal loads";
  return "load case " + shown_name(load_case->load_case.name);
}

}  // namespace

/// Both contact ellipses with the principal directions of both bodies, in the tangent planes and
/// seen from outside the roller (Sandu 2018, fig. 1.16; Yao 2023, fig. 5): under the largest normal
/// load of the cases, or of unit major semi-axes where no case has ellipses. Absent also where the
/// relative curvatures give no ellipse.
Figures contact_ellipses(const Result& result, const FigureOptions&) {
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
    const std::optional<DrawnEllipse> drawn =
        loaded ? loaded_ellipse(*at[i], i) : unit_ellipse(geometry);
    if (!drawn) return {};
    figure.panels.push_back(ellipse_panel(geometry, *drawn, i, loaded));
    largest = std::max(largest, drawn->semi_major);
  }
  const char* unit = loaded ? "mm" : "semi-major axes";
  figure.x = {"along the roller helix", unit, -1.55 * largest, 1.55 * largest};
  figure.y = {"across the flank", unit, -1.55 * largest, 1.55 * largest};
  return {std::move(figure)};
}

}  // namespace prs
