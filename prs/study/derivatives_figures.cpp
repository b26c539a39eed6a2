#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "prs/study/derivatives.h"
#include "prs/study/study_parts.h"

namespace prs {

/// What 1 % of each factor does to the responses, the factors that matter most.
Figures elasticities(const CaseDerivatives& result, const FigureOptions& options) {
  constexpr std::size_t kMostBars = 14;
  Figures figures;
  for (const std::size_t response : chosen_responses(result.study.responses, options)) {
    std::vector<std::pair<double, std::string>> bars;
    for (std::size_t f = 0; f < result.factors.size(); ++f)
      if (const auto& d = result.factors[f].responses[response]; d && d->elasticity)
        bars.emplace_back(*d->elasticity, factor_name(result.study.factors[f]));
    if (bars.empty()) continue;
    std::ranges::stable_sort(bars, std::greater{}, [](const auto& b) { return std::abs(b.first); });
    bars.resize(std::min(bars.size(), kMostBars));
    Figure figure = response_figure(result.study.responses, response);
    figure.name = "derivatives_" + figure.name;
    figure.title += ": change by 1 % of each factor";
    figure.x = {"Change of the response", "%"};
    std::vector<std::string> names;
    std::vector<double> values;
    for (const auto& [value, name] : bars) values.push_back(value), names.push_back(name);
    figures.push_back(ranked_bars(std::move(figure), names, values));
  }
  return figures;
}

}  // namespace prs
