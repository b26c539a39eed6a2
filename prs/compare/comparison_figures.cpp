#include <fmt/format.h>

#include <string>

#include "prs/compare/compare_models.h"
#include "prs/model/units.h"
#include "prs/record/figure_parts.h"

namespace prs {

namespace {

/// Shares of the roller with the largest load; of a sector those of its roller.
std::vector<double> of_most_loaded_roller(const InterfaceLoads& loads) {
  if (!loads.rollers) return loads.load_rate;
  const auto from =
      loads.load_rate.begin() + (loads.rollers->largest_roller - 1) * loads.threads_per_roller;
  return {from, from + loads.threads_per_roller};
}

}  // namespace

/// One line per model, that of the most loaded roller of a full mechanism, and one panel per
/// interface; of the load case that the options choose, else of the first that every model has an
/// answer to.
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
    figure.add(std::string(name_of_model(c.models[m].model)), case_line(m));
  const auto threads = static_cast<std::size_t>(c.best().contacts.mechanism.contacts_per_roller);
  for (const Interface i : kInterfaces) {
    Panel& panel = figure.panels.emplace_back();
    panel.title = interface_title(i);
    for (std::size_t m = 0; m < c.models.size(); ++m) {
      const InterfaceLoads& loads = (*c.models[m].load_cases[k].threads)[i];
      panel.series.push_back({m, {over_threads(of_most_loaded_roller(loads), per_si::percent)}});
    }
  }
  figure.x = thread_axis(threads);
  add_mean(figure, per_si::percent / static_cast<double>(threads));
  fit_y_range(figure, true);
  return {std::move(figure)};
}

}  // namespace prs
