#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "prs/study/study_pictures.h"

namespace prs {
namespace {

constexpr std::size_t kMostBars = 14;
constexpr std::size_t kMostClouds = 6;     // Factors whose designs are drawn.
constexpr std::size_t kMostPoints = 1000;  // Of a cloud.

Figure kind_of_figure(const StudyResult& result, std::size_t response, std::string_view kind) {
  Figure figure = response_figure(result.study.responses, response);
  figure.name = fmt::format("{}_{}", kind, figure.name);
  return figure;
}

/// Yao et al. 2023, figs. 8, 9.
Figure surface_figure(const StudyResult& result, std::size_t response, const LinearFit& fit) {
  Figure figure = kind_of_figure(result, response, "contributions");
  figure.title += fmt::format(": linear surface, R² = {:.4f}", fit.r_squared);
  figure.x = {"Contribution |b| / sum of |b|, with the sign of b", "%"};
  std::vector<std::string> names;
  std::vector<double> values;
  for (const FactorEffect& effect : fit.effects) {
    if (names.size() == kMostBars) break;
    names.push_back(factor_name(result.study.factors[effect.factor]));
    values.push_back(effect.coefficient < 0.0 ? -effect.contribution_percent
                                              : effect.contribution_percent);
  }
  return ranked_bars(std::move(figure), names, values);
}

/// The estimate as a bar and its interval as a line with caps [%].
void add_estimate(const Estimate& estimate, double at, Series& bars, Series& intervals) {
  constexpr double kHalfBar = 0.18, kCap = 0.10;
  const double value = 100.0 * estimate.value;
  bars.parts.push_back(rectangle(0.0, value, at - kHalfBar, at + kHalfBar));
  if (!estimate.half_width) return;
  const double from = std::max(value - 100.0 * *estimate.half_width, -20.0);
  const double to = std::min(value + 100.0 * *estimate.half_width, 120.0);
  intervals.parts.push_back({{from, at}, {to, at}});
  for (const double end : {from, to})
    intervals.parts.push_back({{end, at - kCap}, {end, at + kCap}});
}

Figure variance_figure(const StudyResult& result, std::size_t response,
                       const ResponseIndices& indices) {
  Figure figure = kind_of_figure(result, response, "variance");
  figure.title += fmt::format(": shares of the variance, {} samples", indices.samples);
  figure.x = {"Share of the variance", "%"};
  Series first{figure.add("alone (first)", area_of(Colour::blue))};
  Series total{figure.add("alone and with others (total)", area_of(Colour::orange))};
  Series intervals{figure.add("95 %", line_of(Colour::ink, Dash::solid, Weight::thin))};
  const std::size_t bars = std::min(indices.factors.size(), kMostBars);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < bars; ++k) {
    const FactorIndices& factor = indices.factors[k];
    names.push_back(factor_name(result.study.factors[factor.factor]));
    add_estimate(factor.first, rank_position(k, bars) + 0.2, first, intervals);
    add_estimate(factor.total, rank_position(k, bars) - 0.2, total, intervals);
  }
  Panel panel;
  panel.series = {std::move(first), std::move(total), std::move(intervals)};
  panel.references.push_back({figure.add(kZeroStyle), 0.0, true});
  figure.y = ranked_axis(names);
  figure.aspect = 0.08 + 0.065 * static_cast<double>(bars);
  figure.panels.push_back(std::move(panel));
  return figure;
}

/// Value of a factor in a drawn design.
std::optional<double> value_of(const StudyRow& row, std::size_t factor) {
  const auto setting = std::ranges::find(row.design.settings, factor, &Setting::factor);
  return setting == row.design.settings.end() ? std::nullopt : setting->level.number;
}

/// What the surface gives over one factor, the others in the middle of their ranges.
Polyline line_of_fit(const FactorEffect& effect, double intercept, const NormalisedFactor& x,
                     double from, double to) {
  return {{from, intercept + effect.coefficient * x(from)},
          {to, intercept + effect.coefficient * x(to)}};
}

/// The designs over the factors that matter most, so many of them.
Figure cloud_figure(const StudyResult& result, std::size_t response, const LinearFit& fit,
                    std::size_t most) {
  const std::vector<NormalisedFactor> normalised = normalised_factors(result.study);
  Figure figure = kind_of_figure(result, response, "designs");
  const std::size_t dots =
      figure.add("designs", points_of(Colour::sky, Mark::circle, Weight::thin));
  const std::size_t line =
      figure.add("linear surface, others in the middle", line_of(Colour::vermillion));
  const std::size_t panels = std::min(fit.effects.size(), most);
  figure.columns = columns_for(panels);
  for (std::size_t rank = 0; rank < panels; ++rank) {
    const std::size_t factor = fit.effects[rank].factor;
    Panel& panel = figure.panels.emplace_back();
    Series cloud{dots, {{}}};
    std::vector<double> values;
    for (std::size_t k = 1; k < result.rows.size() && values.size() < kMostPoints; ++k) {
      const std::optional<double> x = value_of(result.rows[k], factor);
      const std::optional<double>& y = result.rows[k].responses[response];
      if (!x || !y) continue;
      values.push_back(*x);
      cloud.parts[0].push_back({*x, *y});
    }
    panel.x = factor_axis(result.study.factors[factor], values);
    panel.x->ticks.clear();
    panel.series.push_back(std::move(cloud));
    const NormalisedFactor& x = *std::ranges::find(normalised, factor, &NormalisedFactor::factor);
    panel.series.push_back(
        {line, {line_of_fit(fit.effects[rank], fit.intercept, x, panel.x->from, panel.x->to)}});
  }
  fit_y_range(figure);
  return figure;
}

Panel histogram_panel(const StudyResult& result, std::size_t response) {
  const ResponseStatistics& s = result.summary.statistics[response];
  const Histogram& h = s.histogram;
  Panel panel;
  Series bars{0};
  const double width = (h.to - h.from) / static_cast<double>(h.counts.size());
  Range counts{0.0, 0.0};
  for (std::size_t k = 0; k < h.counts.size(); ++k) {
    const double left = h.from + width * static_cast<double>(k);
    const auto count = static_cast<double>(h.counts[k]);
    counts.include(count);
    bars.parts.push_back(rectangle(left, left + width, 0.0, count));
  }
  panel.series.push_back(std::move(bars));
  Range shown{h.from, h.to};
  shown.widen(0.03);
  panel.x = response_axis(result.study.responses[response]);
  panel.x->from = shown.from;
  panel.x->to = shown.to;
  panel.y = Axis{"Designs", "", 0.0, 1.06 * counts.to};
  panel.references = {
      {1, s.quantiles[1], true}, {1, s.quantiles[3], true}, {2, s.quantiles[2], true}};
  const std::optional<double>& base = result.base().responses[response];
  if (base && *base >= shown.from && *base <= shown.to)
    panel.references.push_back({3, *base, true});
  return panel;
}

const LinearFit* fit_of(const StudyResult& result, std::size_t response) {
  const auto& surfaces = result.summary.surfaces;
  if (!surfaces || surfaces->fits.empty() || !surfaces->fits[response]) return nullptr;
  return &*surfaces->fits[response];
}

}  // namespace

/// What each factor contributes to the responses: to their linear surfaces, or to their variance.
Figures contributions(const StudyResult& result, const FigureOptions& options) {
  const StudySummary& summary = result.summary;
  Figures figures;
  for (const std::size_t k : chosen_responses(result.study.responses, options)) {
    if (!summary.indices.empty() && !summary.indices[k].factors.empty())
      figures.push_back(variance_figure(result, k, summary.indices[k]));
    else if (const LinearFit* fit = fit_of(result, k))
      figures.push_back(surface_figure(result, k, *fit));
  }
  return figures;
}

Figures design_clouds(const StudyResult& result, const FigureOptions& options) {
  Figures figures;
  for (const std::size_t k : chosen_responses(result.study.responses, options))
    if (const LinearFit* fit = fit_of(result, k))
      figures.push_back(cloud_figure(result, k, *fit, options.one_panel ? 1 : kMostClouds));
  return figures;
}

/// How the responses scatter, the first of them in one figure.
Figures histograms(const StudyResult& result, const FigureOptions& options) {
  std::vector<std::size_t> varying;
  for (const std::size_t k : chosen_responses(result.study.responses, options))
    if (!result.summary.statistics[k].histogram.counts.empty()) varying.push_back(k);
  if (varying.empty()) return {};
  Figure figure{"histograms", "How the responses scatter"};
  keep_first(varying, kMostStudyPanels, figure.title);
  figure.add("designs", area_of(Colour::sky));
  figure.add("5 %, 95 %", line_of(Colour::ink, Dash::dashed, Weight::thin));
  figure.add("median", line_of(Colour::ink, Dash::solid, Weight::thin));
  figure.add(kBaseTitle, line_of(Colour::vermillion));
  figure.columns = std::min<std::size_t>(varying.size(), 2);
  for (const std::size_t k : varying) figure.panels.push_back(histogram_panel(result, k));
  return {std::move(figure)};
}

}  // namespace prs
