#include <fmt/format.h>

#include <string>

#include "prs/compare/compare_models.h"
#include "prs/figures/figure_parts.h"
#include "prs/model/units.h"

namespace prs {

/// One line per model, one panel per interface; of the load case that the options choose, else of
/// the first that every model has an answer to.
Figures loads_by_model(const ModelComparison& c, const FigureOptions& options) {
  const auto answered = [&](std::size_t k) {
    return std::ranges::all_of(
        c.models, [&](const Result& model) { return model.load_cases[k].threads.has_value(); });
  };
  std::size_t k = options.load_case.value_or(0);
  while (!options.load_case && k < c.load_cases() && !answered(k)) ++k;
  if (k >= c.load_cases() || !answered(k)) return {};
  const LoadCase& load = c.best().load_cases[k].load_case;
  Figure figure{"loads_by_model",
                fmt::format("Load distribution by model, {}, {:.4g} kN", shown_name(load.name),
                            load.axial_force * per_si::kilonewton)};
  figure.y = {"Share of the load", "%"};
  figure.columns = std::size(kInterfaces);
  for (std::size_t m = 0; m < c.models.size(); ++m)
    figure.add(std::string(name(c.models[m].model.bodies)), marked_line(m));
  const std::size_t threads = c.best().load_cases[k].threads->screw.load_rate.size();
  for (const Interface i : kInterfaces) {
    Panel& panel = figure.panels.emplace_back();
    panel.title = interface_title(i);
    for (std::size_t m = 0; m < c.models.size(); ++m) {
      const InterfaceLoads& loads = (*c.models[m].load_cases[k].threads)[i];
      panel.series.push_back({m, {over_threads(loads.load_rate, per_si::percent)}});
    }
  }
  figure.x = thread_axis(threads);
  add_mean(figure, per_si::percent / static_cast<double>(threads));
  fit_y_range(figure);
  return {std::move(figure)};
}

}  // namespace prs
