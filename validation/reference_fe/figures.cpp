#include "validation/reference_fe/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prs/model/units.h"
#include "prs/record/figure_parts.h"

namespace prs::reference_fe {
namespace {

/// Told apart by dash in grey print; the thinner ones lie on top.
constexpr Style kModelStyles[] = {line_of(Colour::orange, Dash::dash_dotted, Weight::strong),
                                  line_of(Colour::vermillion, Dash::dashed, Weight::strong),
                                  line_of(Colour::blue)};
constexpr Style kPointStyle = points_of(Colour::ink, Mark::circle, Weight::thin);
constexpr Style kBarStyle = line_of(Colour::ink, Dash::solid, Weight::thin);

bool is_drawn(const Setup& setup) {
  return setup.contacts == ModelOptions::RollerContacts::opposite;
}

/// `both end nodes`
std::string guidance_title(const Setup& setup) {
  std::string title = words(setup)[2];
  std::ranges::replace(title, '_', ' ');
  return title;
}

std::string case_title(const Setup& setup) {
  return fmt::format("CONFIG {}, {}", setup.config, prs::name(setup.direction));
}

/// Styles and legend: the models by their indices, then points and bars of the reference.
struct StyleIndices {
  std::size_t points = 0;
  std::size_t bars = 0;
};

StyleIndices add_styles(Figure& figure, const std::vector<Model>& models) {
  for (std::size_t m = 0; m < models.size(); ++m)
    figure.add(models[m].name, kModelStyles[m % std::size(kModelStyles)]);
  StyleIndices styles;
  styles.points = figure.add("reference with its error bar", kPointStyle);
  styles.bars = figure.add(kBarStyle);
  return styles;
}

/// A vertical stroke at each point, as long as its half widths say.
Series error_bars(std::size_t style, const Polyline& points,
                  const std::vector<double>& half_widths) {
  Series line{style};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto [x, y] = points[k];
    line.parts.push_back({{x, y - half_widths[k]}, {x, y + half_widths[k]}});
  }
  return line;
}

/// Load rates less those of `base`, in %.
Polyline differences(const std::vector<double>& rates, const std::vector<double>& base) {
  Polyline points;
  for (std::size_t k = 0; k < rates.size(); ++k)
    points.push_back({static_cast<double>(k + 1), (rates[k] - base[k]) * per_si::percent});
  return points;
}

/// Rates of all models and the reference, less those of `base`.
Panel rate_panel(const std::vector<Model>& models, std::size_t curve, const CurvePoint& reference,
                 Interface i, const std::vector<double>& base, const StyleIndices& styles,
                 const ErrorBar& error) {
  Panel panel;
  for (std::size_t m = 0; m < models.size(); ++m) {
    const CurvePoint& point = models[m].curves[curve].points.back();
    if (point.is_solved()) panel.series.push_back({m, {differences(point.load_rate[i], base)}});
  }
  const Polyline points = differences(reference.load_rate[i], base);
  panel.series.push_back(error_bars(
      styles.bars, points, std::vector<double>(points.size(), error.load_rate * per_si::percent)));
  panel.series.push_back({styles.points, {points}});
  return panel;
}

/// As wide as its lines on both sides of zero.
Axis difference_axis(const std::vector<const Panel*>& panels) {
  Range range;
  for (const Panel* panel : panels) range.include(range_of_y(panel->series));
  const double widest = std::max(std::abs(range.from), std::abs(range.to));
  return {"Less the reference", "%", -1.08 * widest, 1.08 * widest};
}

Figure load_rate_figure(const std::vector<Model>& models, std::size_t curve, const Curve& reference,
                        const ErrorBar& error) {
  const CurvePoint& point = reference.points.back();
  const std::size_t threads = point.load_rate.screw.size();
  Figure figure;
  const auto w = words(reference.setup);
  figure.name = fmt::format("load_rate_config{}_{}_{}", w[0], w[1], w[2]);
  figure.title = fmt::format("{}, {:.4g} kN, guidance: {}", case_title(reference.setup),
                             point.load * per_si::kilonewton, guidance_title(reference.setup));
  figure.x = thread_axis(threads);
  figure.y = {"Share of the load", "%"};
  figure.columns = std::size(kInterfaces);
  const StyleIndices styles = add_styles(figure, models);
  for (const Interface i : kInterfaces) {
    figure.panels.push_back(
        rate_panel(models, curve, point, i, std::vector<double>(threads, 0.0), styles, error));
    figure.panels.back().title = interface_title(i);
  }
  fit_y_range(figure);
  for (const Interface i : kInterfaces)
    figure.panels.push_back(rate_panel(models, curve, point, i, point.load_rate[i], styles, error));
  const Axis difference = difference_axis({&figure.panels[2], &figure.panels[3]});
  for (std::size_t k : {2u, 3u}) figure.panels[k].y = difference;
  figure.panels[3].y->label.clear();
  return figure;
}

Polyline over_load(const Curve& curve) {
  Polyline points{{0.0, 0.0}};
  for (const CurvePoint& point : curve.points)
    if (point.is_solved())
      points.push_back({point.load * per_si::kilonewton, point.displacement * per_si::micrometre});
  return points;
}

Panel displacement_panel(const std::vector<Model>& models, std::size_t curve,
                         const Curve& reference, const StyleIndices& styles,
                         const ErrorBar& error) {
  Panel panel;
  panel.title = case_title(reference.setup);
  for (std::size_t m = 0; m < models.size(); ++m)
    panel.series.push_back({m, {over_load(models[m].curves[curve])}});
  Polyline points = over_load(reference);
  points.erase(points.begin());
  std::vector<double> half_widths;
  for (const auto& [load, displacement] : points)
    half_widths.push_back(error.stiffness * displacement);
  panel.series.push_back(error_bars(styles.bars, points, half_widths));
  panel.series.push_back({styles.points, {std::move(points)}});
  return panel;
}

}  // namespace

std::vector<Figure> load_rate_figures(const std::vector<Model>& models,
                                      const std::vector<Curve>& reference, const ErrorBar& error) {
  std::vector<Figure> figures;
  for (std::size_t k = 0; k < reference.size(); ++k)
    if (is_drawn(reference[k].setup))
      figures.push_back(load_rate_figure(models, k, reference[k], error));
  return figures;
}

std::vector<Figure> displacement_figures(const std::vector<Model>& models,
                                         const std::vector<Curve>& reference,
                                         const ErrorBar& error) {
  std::vector<Figure> figures;
  for (const Guidance::Kind guidance :
       {Guidance::Kind::both_end_nodes, Guidance::Kind::outer_node}) {
    Figure figure;
    const Setup shown{1, Direction::tension, guidance, {}};
    figure.name = "displacement_" + words(shown)[2];
    figure.title = "Axial displacement, guidance: " + guidance_title(shown);
    figure.x = {"Axial load", "kN", 0.0};
    figure.y = {"Axial displacement", "µm"};
    figure.columns = 2;
    const StyleIndices styles = add_styles(figure, models);
    for (std::size_t k = 0; k < reference.size(); ++k) {
      const Setup& setup = reference[k].setup;
      if (!is_drawn(setup) || setup.guidance != guidance) continue;
      figure.x.to = reference[k].points.back().load * per_si::kilonewton;
      figure.panels.push_back(displacement_panel(models, k, reference[k], styles, error));
    }
    fit_y_range(figure);
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace prs::reference_fe
