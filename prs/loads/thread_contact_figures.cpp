#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/subsurface.h"
#include "prs/loads/contact_parts.h"
#include "prs/loads/load_record.h"
#include "prs/loads/thread_parts.h"
#include "prs/model/case.h"

namespace prs {
namespace {

bool has_threads(const LoadCaseResult& result) { return result.threads.has_value(); }

/// `thread 3` or `roller 2, thread 3`.
std::string words_of_thread(const ChosenThread& chosen) {
  const auto threads = static_cast<std::size_t>(chosen.at(Interface::screw).threads_per_roller);
  return threads == 0 ? fmt::format("thread {}", chosen.thread + 1)
                      : fmt::format("roller {}, thread {}", chosen.thread / threads + 1,
                                    chosen.thread % threads + 1);
}

std::string picture_title(const char* what, const ChosenThread& chosen) {
  return fmt::format("{}, {}, {}", what, words_of_thread(chosen),
                     shown_name(chosen.load_case->load_case.name));
}

}  // namespace

std::optional<ChosenThread> chosen_thread(const Result& result, const FigureOptions& options,
                                          bool (*has)(const LoadCaseResult&)) {
  const LoadCaseResult* load_case = chosen_case(result, options, has);
  if (!load_case || !has(*load_case)) return std::nullopt;
  const std::vector<double>& loads = load_case->threads->screw.normal_load;
  if (loads.empty()) return std::nullopt;
  const std::size_t thread = options.thread.value_or(*index_of_largest(loads));
  if (thread >= loads.size())
    throw NoFigure(fmt::format("thread: got {}; expected 0 to {}", thread, loads.size() - 1));
  return ChosenThread{load_case, thread};
}

/// Hertz' pressure p_0 sqrt(1 - (x/a)^2 - (y/b)^2) over both ellipses of a thread.
Figures thread_pressure(const Result& result, const FigureOptions& options) {
  const auto chosen = chosen_thread(result, options, has_threads);
  if (!chosen) return {};
  constexpr int kRings = 12;
  Figure figure{"thread_pressure", picture_title("Contact ellipses", *chosen)};
  const std::size_t rings = figure.add(area_of(Colour::ink));
  double half = 0.0, most = 0.0;
  for (const Interface i : kInterfaces) {
    if (!chosen->has_ellipse(i)) continue;
    const InterfaceLoads& loads = chosen->at(i);
    const double a = loads.semi_major[chosen->thread] * per_si::millimetre;
    const double b = loads.semi_minor[chosen->thread] * per_si::millimetre;
    const double peak = loads.peak_pressure[chosen->thread] * per_si::megapascal;
    Panel& panel = figure.panels.emplace_back();
    panel.title =
        fmt::format("{}: {:.4g} N", interface_title(i), loads.normal_load[chosen->thread]);
    Series series{rings};
    for (int k = 0; k < kRings; ++k) {
      // Rings of equal steps of pressure, each in the colour of its middle.
      const double outside = std::sqrt(1.0 - std::pow(static_cast<double>(k) / kRings, 2));
      series.parts.push_back(ellipse(0.0, 0.0, outside * a, outside * b, 0.0));
      series.values.push_back(peak * (k + 0.5) / kRings);
    }
    panel.series.push_back(std::move(series));
    panel.labels.push_back({fmt::format("a = {:.4f} mm, b = {:.4f} mm", a, b), 0.03, 0.06, true});
    half = std::max(half, a);
    most = std::max(most, peak);
  }
  if (figure.panels.empty()) return {};
  figure.columns = figure.panels.size();
  figure.x = {"along the major axis", "mm", -1.15 * half, 1.15 * half};
  figure.y = {"along the minor axis", "mm", -1.15 * half, 1.15 * half};
  figure.colours = ColourScale{"Pressure", "MPa", 0.0, most};
  figure.aspect = 0.6;
  figure.to_scale = true;
  return {std::move(figure)};
}

/// Principal stresses and largest shear stress below the centre of both ellipses of a thread, of
/// the body with the smaller Poisson's ratio, see `contact::stress_on_axis`.
Figures thread_stress(const Case& c, const Result& result, const FigureOptions& options) {
  const auto chosen = chosen_thread(result, options, has_threads);
  if (!chosen || !c.materials) return {};
  constexpr int kSteps = 60;
  constexpr double kDepth = 3.0;  // Over the minor semi-axis.
  Figure figure{"thread_stress", picture_title("Stress below the contacts", *chosen)};
  const std::size_t normal = figure.add("along the normal", line_of(Colour::blue));
  const std::size_t major = figure.add("along the major axis", line_of(Colour::green));
  const std::size_t minor = figure.add("along the minor axis", line_of(Colour::purple));
  const std::size_t shear =
      figure.add("largest shear stress", line_of(Colour::vermillion, Dash::solid, Weight::strong));
  const std::size_t deepest = figure.add("its depth", kMeanStyle);
  const std::size_t zero = figure.add(kZeroStyle);
  for (const Interface i : kInterfaces) {
    if (!chosen->has_ellipse(i)) continue;
    const InterfaceLoads& loads = chosen->at(i);
    const double a = loads.semi_major[chosen->thread], b = loads.semi_minor[chosen->thread];
    const double peak = loads.peak_pressure[chosen->thread] * per_si::megapascal;
    const double nu =
        std::min((*c.materials)[body_of(i)].poisson_ratio, c.materials->roller.poisson_ratio);
    Series of_normal{normal}, of_major{major}, of_minor{minor}, of_shear{shear};
    for (int k = 0; k <= kSteps; ++k) {
      const double depth = kDepth * b * k / kSteps;
      const contact::AxisStress s = contact::stress_on_axis(a, b, depth, nu);
      const double x = depth * per_si::micrometre;
      of_normal.add(x, s.along_normal * peak);
      of_major.add(x, s.along_major * peak);
      of_minor.add(x, s.along_minor * peak);
      of_shear.add(x, s.largest_shear() * peak);
    }
    Panel& panel = figure.panels.emplace_back();
    panel.title = interface_title(i);
    panel.series = {of_normal, of_major, of_minor, of_shear};
    panel.references.push_back({zero, 0.0});
    if (!loads.max_shear_depth.empty())
      panel.references.push_back(
          {deepest, loads.max_shear_depth[chosen->thread] * per_si::micrometre, true});
  }
  if (figure.panels.empty()) return {};
  figure.columns = figure.panels.size();
  figure.x = {"Depth", "µm"};
  figure.y = {"Stress", "MPa"};
  return {std::move(figure)};
}

}  // namespace prs
