#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "prs/figures/figure_style.h"
#include "prs/quantities/response_title.h"
#include "prs/figures/study_figure_parts.h"
#include "prs/study/study_text.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kMostBars = 10;
constexpr std::size_t kMostClouds = 6;     // Factors whose designs are drawn.
constexpr std::size_t kMostPoints = 1000;  // Of a cloud.
constexpr double kLabelRoom = -62.0;       // Where bars of 100 % leave room for labels.
constexpr int kBarHeight = 26;             // [pixels]
constexpr std::size_t kMaxLabel = 34;

// The colours of Yao's bars: blue where the response grows with the factor, red where it falls.
constexpr std::string_view kBlue = "#004488";
constexpr std::string_view kRed = "#bb5566";

Panel ranked_panel(const Study& study, const std::vector<std::size_t>& factors) {
  Panel panel;
  for (std::size_t k = 0; k < factors.size(); ++k)
    panel.labels.push_back(
        {fmt::format("{:>2}  {}", k + 1,
                     shortened(printable(study.factors[factors[k]].label), kMaxLabel)),
         kLabelRoom + 2.0, static_cast<double>(k + 1)});
  return panel;
}

/// Bars from above to below in per cent, with room for labels on their left.
Figure ranked_figure(const StudyResult& result, std::size_t response, std::string_view kind,
                     std::size_t bars) {
  const std::string& path = result.study.responses[response];
  Figure figure;
  figure.name = fmt::format("{}_{}", kind, study_figure_name(response, path));
  figure.title = capitalised(response_title(path).name);
  figure.x = {"", kLabelRoom, 104.0, {0, 20, 40, 60, 80, 100}};
  figure.y = {"", static_cast<double>(bars) + 0.5, 0.5, {0}};  // No tic, nor line, in sight.
  figure.panel_height = 50 + kBarHeight * static_cast<int>(bars);
  return figure;
}

Figure pareto_figure(const StudyResult& result, std::size_t response, const LinearFit& fit) {
  const std::size_t bars = std::min(fit.effects.size(), kMostBars);
  Figure figure = ranked_figure(result, response, "contributions", bars);
  figure.title +=
      fmt::format(": contributions to a linear response surface, R² = {:.4f}", fit.r_squared);
  figure.x.label = "|b| / sum of |b| (%)";
  const std::size_t grows = add_to_legend(figure, "grows with the factor", fill_of(kBlue));
  const std::size_t falls = add_to_legend(figure, "falls", fill_of(kRed));
  const std::size_t sum = add_to_legend(figure, "sum", {"#000000", 1, 7, 1.2});
  std::vector<std::size_t> factors;
  Line up{grows, {}}, down{falls, {}}, total{sum, {{}}};
  double so_far = 0.0;
  for (std::size_t k = 0; k < bars; ++k) {
    const FactorEffect& effect = fit.effects[k];
    const double at = static_cast<double>(k + 1);
    factors.push_back(effect.factor);
    (effect.coefficient < 0.0 ? down : up)
        .parts.push_back(rectangle(0.0, effect.contribution_percent, at - 0.35, at + 0.35));
    so_far += effect.contribution_percent;
    total.parts[0].push_back({so_far, at});
  }
  Panel panel = ranked_panel(result.study, factors);
  panel.lines = {std::move(up), std::move(down), std::move(total)};
  figure.panels.push_back(std::move(panel));
  return figure;
}

/// The estimate as a bar and its interval as a line with caps [%].
void add_estimate(const Estimate& estimate, double at, Line& bars, Line& intervals) {
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
  const std::size_t bars = std::min(indices.factors.size(), kMostBars);
  Figure figure = ranked_figure(result, response, "variance", bars);
  figure.title += fmt::format(": shares of the variance, {} samples", indices.samples);
  figure.x.label = "share of the variance (%)";
  figure.panel_height += kBarHeight * static_cast<int>(bars) / 2;
  const std::size_t alone = add_to_legend(figure, "alone (first)", fill_of(kBlue));
  const std::size_t with_others =
      add_to_legend(figure, "alone and with others (total)", fill_of("#ddaa33"));
  const std::size_t interval = add_to_legend(figure, "95 %", {"#000000", 1, 0, 1.4});
  std::vector<std::size_t> factors;
  Line first{alone, {}}, total{with_others, {}}, intervals{interval, {}};
  for (std::size_t k = 0; k < bars; ++k) {
    const FactorIndices& factor = indices.factors[k];
    factors.push_back(factor.factor);
    add_estimate(factor.first, static_cast<double>(k) + 0.8, first, intervals);
    add_estimate(factor.total, static_cast<double>(k) + 1.2, total, intervals);
  }
  Panel panel = ranked_panel(result.study, factors);
  panel.lines = {std::move(first), std::move(total), std::move(intervals)};
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

/// The designs over the factors that matter most.
Figure cloud_figure(const StudyResult& result, std::size_t response, const LinearFit& fit) {
  const std::string& path = result.study.responses[response];
  const std::vector<NormalisedFactor> normalised = normalised_factors(result.study);
  Figure figure;
  figure.name = fmt::format("designs_{}", study_figure_name(response, path));
  figure.title = capitalised(response_title(path).name);
  figure.y = response_axis(path);
  const std::size_t dots = add_to_legend(figure, "designs", points_of("#6699cc", 7, 0.4));
  const std::size_t line =
      add_to_legend(figure, "linear surface, others in the middle", {"#cc2211", 1, 0, 2.0});
  const std::size_t panels = std::min(fit.effects.size(), kMostClouds);
  figure.columns = columns_for(panels);
  for (std::size_t rank = 0; rank < panels; ++rank) {
    const std::size_t factor = fit.effects[rank].factor;
    Panel panel;
    Line cloud{dots, {{}}};
    std::vector<double> values;
    for (std::size_t k = 1; k < result.rows.size() && values.size() < kMostPoints; ++k) {
      const std::optional<double> x = value_of(result.rows[k], factor);
      const std::optional<double>& y = result.rows[k].responses[response];
      if (!x || !y) continue;
      values.push_back(*x);
      cloud.parts[0].push_back({*x, *y});
    }
    panel.x = factor_axis(result.study.factors[factor], values);
    panel.x->tics.clear();
    panel.lines.push_back(std::move(cloud));
    const NormalisedFactor& x = *std::ranges::find(normalised, factor, &NormalisedFactor::factor);
    panel.lines.push_back(
        {line, {line_of_fit(fit.effects[rank], fit.intercept, x, panel.x->from, panel.x->to)}});
    figure.panels.push_back(std::move(panel));
  }
  fit_y_range(figure);
  return figure;
}

Panel histogram_panel(const StudyResult& result, std::size_t response, std::size_t bar_style,
                      std::size_t quantile_style, std::size_t base_style) {
  const ResponseStatistics& s = result.summary.statistics[response];
  const Histogram& h = s.histogram;
  Panel panel;
  Line bars{bar_style, {}};
  const double width = (h.to - h.from) / static_cast<double>(h.counts.size());
  double highest = 0.0;
  for (std::size_t k = 0; k < h.counts.size(); ++k) {
    const double left = h.from + width * static_cast<double>(k);
    const double count = static_cast<double>(h.counts[k]);
    highest = std::max(highest, count);
    bars.parts.push_back(rectangle(left, left + width, 0.0, count));
  }
  panel.x = response_axis(result.study.responses[response]);
  const double margin = 0.03 * (h.to - h.from);
  panel.x->from = h.from - margin;
  panel.x->to = h.to + margin;
  panel.y = Axis{"designs", 0.0, 1.06 * highest};
  const auto upright = [&](double x) { return Polyline{{x, 0.0}, {x, 1.06 * highest}}; };
  panel.lines = {std::move(bars),
                 {quantile_style, {upright(s.quantiles[1]), upright(s.quantiles[3])}}};
  const std::optional<double>& base = result.base().responses[response];
  if (base && *base >= panel.x->from && *base <= panel.x->to)
    panel.lines.push_back({base_style, {upright(*base)}});
  return panel;
}

/// How the responses scatter, the first 12 of them.
std::optional<Figure> histogram_figure(const StudyResult& result) {
  std::vector<std::size_t> varying;
  for (std::size_t k = 0; k < result.summary.statistics.size(); ++k)
    if (!result.summary.statistics[k].histogram.counts.empty()) varying.push_back(k);
  if (varying.empty()) return std::nullopt;
  Figure figure;
  figure.name = "histograms";
  figure.title = "How the responses scatter";
  if (varying.size() > kMostStudyPanels) {
    figure.title += fmt::format(", first {} of {}", kMostStudyPanels, varying.size());
    varying.resize(kMostStudyPanels);
  }
  const std::size_t bars = add_to_legend(figure, "designs", fill_of("#6699cc"));
  const std::size_t quantiles = add_to_legend(figure, "5 %, 95 %", {"#555555", 2, 0, 1.6});
  const std::size_t base = add_to_legend(figure, "as in the file", {"#cc2211", 1, 0, 2.0});
  figure.columns = std::min<std::size_t>(varying.size(), 2);
  for (const std::size_t k : varying)
    figure.panels.push_back(histogram_panel(result, k, bars, quantiles, base));
  return figure;
}

}  // namespace

std::vector<Figure> sampled_figures(const StudyResult& result) {
  const StudySummary& summary = result.summary;
  std::vector<Figure> figures, clouds;
  for (std::size_t k = 0; k < std::min(result.study.responses.size(), kMostStudyFigures); ++k) {
    const LinearFit* fit =
        summary.surfaces && !summary.surfaces->fits.empty() && summary.surfaces->fits[k]
            ? &*summary.surfaces->fits[k]
            : nullptr;
    if (!summary.indices.empty() && !summary.indices[k].factors.empty())
      figures.push_back(variance_figure(result, k, summary.indices[k]));
    else if (fit)
      figures.push_back(pareto_figure(result, k, *fit));
    if (fit) clouds.push_back(cloud_figure(result, k, *fit));
  }
  std::ranges::move(clouds, std::back_inserter(figures));
  if (std::optional<Figure> histograms = histogram_figure(result))
    figures.push_back(std::move(*histograms));
  return figures;
}

}  // namespace prs
