#include "modules/response/response_figures.h"

namespace prs {
namespace {

constexpr std::size_t kMostPoints = 8000;

/// A series over time; for more points than a picture shows, the smallest and the largest of each part.
Series over_time(std::size_t style, const DriveResult& run, const std::vector<double>& values, double factor) {
  Series line{style};
  const std::size_t step = 1 + 2 * run.time.size() / kMostPoints;
  for (std::size_t k = 0; k < run.time.size(); k += step) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(k);
    const auto [least, most] =
        std::minmax_element(first, first + static_cast<std::ptrdiff_t>(std::min(step, run.time.size() - k)));
    const auto add = [&](auto at) {
      line.add(1e3 * run.time[static_cast<std::size_t>(at - values.begin())], factor * *at);
    };
    add(std::min(least, most));
    if (least != most) add(std::max(least, most));
  }
  return line;
}

Panel panel_of(std::string title, Axis axis, std::vector<Series> lines) {
  Panel panel{std::move(title), std::move(lines)};
  panel.y = fitted(std::move(axis), range_of_y(panel.series));
  return panel;
}

Figure over(const char* name, const char* title, const ResponseResult& r) {
  Figure figure{name, title};
  figure.x = {"Time", "ms", 0.0, 1e3 * r.input.duration};
  figure.aspect = 0.4;
  return figure;
}

Figures motion(const ResponseResult& r) {
  Figure figure = over("response_motion", "Motion", r);
  const std::size_t load = figure.add("load", line_of(Colour::blue));
  const std::size_t screw = figure.add("screw", line_of(Colour::vermillion));
  const std::size_t motor = figure.add("motor", line_of(Colour::green, Dash::dashed));
  const DriveResult& d = r.run;
  figure.panels = {panel_of("Position", {"Position", "mm"}, {over_time(load, d, d.x, "mm"_per_si)}),
                   panel_of("Speed of the load", {"Speed", "mm/s"}, {over_time(load, d, d.v, "mm"_per_si)}),
                   panel_of("Speed of screw and motor", {"Speed", "rpm"},
                            {over_time(screw, d, d.omega, "rpm"_per_si), over_time(motor, d, d.omega_m, "rpm"_per_si)}),
                   panel_of("Deflection", {"Deflection", "µm"}, {over_time(screw, d, d.delta, "µm"_per_si)})};
  return {std::move(figure)};
}

Figures force(const ResponseResult& r) {
  Figure figure = over("response_force", "Force and torques", r);
  const std::size_t screw = figure.add("screw", line_of(Colour::blue));
  const std::size_t external = figure.add("external", line_of(Colour::grey, Dash::dashed));
  const std::size_t motor = figure.add("motor", line_of(Colour::vermillion));
  const std::size_t coupling = figure.add("coupling", line_of(Colour::green, Dash::dashed));
  const DriveResult& d = r.run;
  std::vector<Series> forces = {over_time(external, d, d.external, "kN"_per_si),
                                over_time(screw, d, d.force, "kN"_per_si)};
  if (!d.impacts.empty()) {
    Series marks{figure.add("impacts", points_of(Colour::ink, Mark::circle))};
    for (const DriveImpact& i : d.impacts) marks.add(1e3 * i.force.time, i.flank * i.force.value * "kN"_per_si);
    forces.push_back(std::move(marks));
  }
  figure.panels = {
      panel_of("Force", {"Force", "kN"}, std::move(forces)),
      panel_of("Torques", {"Torque", "N m"},
               {over_time(motor, d, d.motor_torque, 1.0), over_time(coupling, d, d.coupling_torque, 1.0)})};
  return {std::move(figure)};
}

Figures energy(const ResponseResult& r) {
  const DriveResult& d = r.run;
  Figure figure{"response_energy", "Energies of the run"};
  const std::size_t in = figure.add("put in", area_of(Colour::blue));
  const std::size_t lost = figure.add("stored or lost", area_of(Colour::vermillion));
  std::vector<std::pair<const char*, double>> bars = {
      {"motor", d.motor}, {"load", d.load}, {"stored", d.stored_end - d.stored_start}};
  for (const auto& [what, loss] : kEnergyLosses) bars.emplace_back(what, d.*loss);
  Panel panel;
  figure.x = {""};
  for (std::size_t k = 0; k < std::size(bars); ++k) {
    const double x = static_cast<double>(k);
    panel.series.push_back({k < 2 ? in : lost, {rectangle(x - 0.36, x + 0.36, 0.0, bars[k].second)}});
    figure.x.ticks.push_back({x, bars[k].first});
  }
  figure.x.from = -0.5;
  figure.x.to = static_cast<double>(std::size(bars)) - 0.5;
  panel.y = fitted({"Energy", "J"}, range_of_y(panel.series));
  figure.panels = {std::move(panel)};
  return {std::move(figure)};
}

Figures frequency(const ResponseResult& r) {
  if (!r.frequency_response) return {};
  const FrequencyResponse& f = *r.frequency_response;
  Figure figure{"response_frequency", "Frequency response"};
  figure.x = {"Frequency", "Hz", f.frequency.front(), f.frequency.back()};
  figure.x.logarithmic = true;
  figure.aspect = 0.4;
  const std::size_t first = figure.add(line_of(Colour::blue));
  std::vector<Resonance> shown = f.resonances;
  std::erase_if(shown, [&](const Resonance& one) {
    return one.frequency < f.frequency.front() || one.frequency > f.frequency.back();
  });
  std::vector<ReferenceLine> resonances;
  if (!shown.empty()) {
    const std::size_t style = figure.add("resonance", line_of(Colour::grey, Dash::dotted));
    for (const Resonance& resonance : shown) resonances.push_back({style, resonance.frequency, true});
  }
  const auto panel = [&](const char* title, Axis axis, const std::vector<double>& values, double factor, bool is_size) {
    Series line{first};
    for (std::size_t k = 0; k < values.size(); ++k) line.add(f.frequency[k], factor * values[k]);
    axis.logarithmic = is_size;
    Panel made{title, {std::move(line)}, resonances};
    if (!is_size) axis.from = -190.0, axis.to = 190.0;
    made.y = std::move(axis);
    figure.panels.push_back(std::move(made));
  };
  if (f.of_torque) {
    panel("Motor speed over motor torque", {"Speed over torque", "rad/s/(N m)"}, f.motor_speed, 1.0, true);
    panel("Phase of the motor speed", {"Phase", "°"}, f.motor_speed_phase, "deg"_per_si, false);
    panel("Position over motor torque", {"Position over torque", "µm/(N m)"}, f.position, "µm"_per_si, true);
  } else {
    panel("Compliance at the load", {"Compliance", "µm/N"}, f.compliance, "µm"_per_si, true);
    panel("Phase of the compliance", {"Phase", "°"}, f.phase, "deg"_per_si, false);
  }
  return {std::move(figure)};
}

}  // namespace

Pictures response_pictures(const ResponseResult& r) {
  return {{"response_motion", "a run", of_result(r, motion)},
          {"response_force", "a run", of_result(r, force)},
          {"response_energy", "a run", of_result(r, energy)},
          {"response_frequency", "a block `frequency_response`", of_result(r, frequency)}};
}

}  // namespace prs
