#include "prs/figures/measures_figures.h"

#include <algorithm>

#include "prs/figures/figure_style.h"
#include "prs/model/units.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kMostYangPanels = 6;

Polyline over_threads(const std::vector<double>& rates) {
  Polyline points;
  for (const double rate : rates)
    points.push_back({static_cast<double>(points.size() + 1), rate * per_si::percent});
  return points;
}

}  // namespace

std::vector<Figure> measures_figures(const MeasuresResult& result) {
  Figure figure;
  figure.name = "yang";
  figure.title = "Load distribution: Yang's formula beside the model";
  figure.y.label = "Load rate (%)";
  std::size_t threads = 0;
  for (std::size_t k = 0; k < result.load_measures.size(); ++k) {
    const LoadCaseResult& load_case = result.analysis.load_cases[k];
    if (!load_case.threads || !result.load_measures[k]) continue;
    const std::vector<double>& yang = result.load_measures[k]->yang_load_rate;
    if (yang.empty() || figure.panels.size() == kMostYangPanels) continue;
    threads = std::max(threads, yang.size());
    figure.panels.push_back({printable(load_case.load_case.name),
                             {{0, {over_threads(load_case.threads->screw.load_rate)}},
                              {1, {over_threads(load_case.threads->nut.load_rate)}},
                              {2, {over_threads(yang)}}}});
  }
  if (figure.panels.empty()) return {};
  add_to_legend(figure, "model, roller-screw", kConfigurationStyles[0]);
  add_to_legend(figure, "model, roller-nut", kConfigurationStyles[1]);
  add_to_legend(figure, "Yang", kConfigurationStyles[2]);
  figure.x = {"Thread, from the loaded end of the screw", 0.4, static_cast<double>(threads) + 0.6};
  figure.columns = figure.panels.size() == 1 ? 1 : 2;
  add_mean(figure, threads);
  fit_y_range(figure);
  return {figure};
}

}  // namespace prs
