#include <array>

#include "prs/losses/heat_record.h"
#include "prs/record/figure_parts.h"

namespace prs {

/// Temperatures of the parts over the cycle of the duty, their means dashed.
Figures heat_cycle(const Result& result) {
  if (!result.heat_cycle || !result.heat_cycle->converged()) return {};
  const HeatCycle& cycle = *result.heat_cycle;
  const PartSeries temperature = celsius_of(cycle.temperature);
  const PartNumbers mean = celsius_of(cycle.mean);
  constexpr double kLong = 2.0 * 3600.0;
  const bool hours = cycle.period > kLong;
  const double per_second = hours ? 1.0 / 3600.0 : 1.0;

  Figure figure{"heat_cycle", "Temperatures over the duty cycle"};
  figure.x = Axis{"Time", hours ? "h" : "s", 0.0, cycle.period * per_second};
  figure.y = Axis{"Temperature", "°C"};
  Panel panel;
  const auto add = [&](Part part, std::string name, const std::vector<double>& values,
                       double average) {
    Series line{figure.add(std::move(name), line_of(colour_of(part)))};
    for (std::size_t k = 0; k < values.size(); ++k) line.add(cycle.time[k] * per_second, values[k]);
    panel.series.push_back(std::move(line));
    panel.references.push_back(
        {figure.add(line_of(colour_of(part), Dash::dashed, Weight::thin)), average});
  };
  add(Part::screw, "screw", temperature.screw, mean.screw);
  add(Part::roller, "rollers", temperature.rollers, mean.rollers);
  add(Part::nut, "nut", temperature.nut, mean.nut);
  figure.panels.push_back(std::move(panel));
  return {figure};
}

}  // namespace prs
