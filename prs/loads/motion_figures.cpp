#include "prs/loads/motion_figures.h"

#include "prs/indices.h"
#include "prs/loads/full_result.h"
#include "prs/loads/load_analysis.h"
#include "prs/loads/load_record.h"

namespace prs {
namespace {

constexpr Colour kColours[] = {Colour::blue,   Colour::vermillion, Colour::green,
                               Colour::purple, Colour::orange,     Colour::sky};
Style line_number(std::size_t k) { return line_of(kColours[k % std::size(kColours)]); }

/// Whether deviations are above rounding: a travel without turning errors shows nothing.
bool has_travel(const LoadCaseResult& r) {
  if (!r.full || !r.full->travel || !r.full->travel->converged()) return false;
  const auto [least, most] = std::ranges::minmax(r.full->travel->displacement);
  return most - least > 1e-12;
}
bool has_modes(const LoadCaseResult& r) { return r.full && r.full->modes && !r.full->modes->modes.empty(); }
bool has_modes_along_travel(const LoadCaseResult& r) { return has_modes(r) && r.full->modes->along_travel; }

Figure figure_of(std::string name, std::string_view what, const LoadCaseResult& shown) {
  return {std::move(name), fmt::format("{}, {}", what, shown_name(shown.load_case.name))};
}

double turns_at(const TravelResult& t, std::size_t k) { return t.angle[k] / (2.0 * std::numbers::pi); }

Figure travel_deviation(const Result&, const LoadCaseResult& shown) {
  const TravelResult& t = *shown.full->travel;
  Figure figure = figure_of("travel_deviation", "Travel deviation", shown);
  Series deviation{figure.add("deviation", line_of(Colour::blue))};
  Series line{figure.add("mean travel", line_of(Colour::ink, Dash::dashed))};
  Series band{figure.add("band v_ua", line_of(Colour::grey, Dash::dotted))};
  double low = 0.0, high = 0.0;
  for (const auto k : indices(t.angle)) {
    low = std::min(low, t.displacement[k] - t.bands.line[k]);
    high = std::max(high, t.displacement[k] - t.bands.line[k]);
  }
  Polyline all, mean, below, above;
  for (const auto k : indices(t.angle)) {
    const double x = turns_at(t, k), on_line = t.bands.line[k] - t.mean_displacement;
    const auto point = [&](double si) { return std::array{x, si * "µm"_per_si}; };
    all.push_back(point(t.displacement[k] - t.mean_displacement));
    mean.push_back(point(on_line));
    below.push_back(point(on_line + low));
    above.push_back(point(on_line + high));
  }
  deviation.parts = {std::move(all)};
  line.parts = {std::move(mean)};
  band.parts = {std::move(below), std::move(above)};
  figure.x = {"Turns of the screw against the nut"};
  figure.y = {"Deviation", "µm"};
  figure.panels.push_back({.series = {std::move(band), std::move(line), std::move(deviation)}});
  return figure;
}

/// The simplest sum of multiples of turn, carrier and spin within half a line.
std::string combination(double order, double resolution, const std::vector<MotionOrder>& base) {
  const double carrier = base[1].order, spin = base[3].order;
  int least = 10;
  std::string best;
  for (int c = -4; c <= 4; ++c)
    for (int a = -3; a <= 3; ++a)
      for (int b = 0; b <= 3; ++b) {
        const int size = std::abs(a) + b + std::abs(c);
        if (size == 0 || size >= least || std::abs(c + a * carrier + b * spin - order) > 0.5 * resolution) continue;
        least = size;
        best.clear();
        for (const auto& [times, name] : {std::pair{b, "spin"}, {a, "carrier"}, {c, "turn"}})
          if (times != 0)
            best += fmt::format("{}{}{}",
                                times < 0      ? "-"
                                : best.empty() ? ""
                                               : "+",
                                std::abs(times) == 1 ? "" : std::to_string(std::abs(times)) + " ", name);
      }
  const double past_screw = base[5].order, past_nut = base[4].order;
  for (const auto& [at, name] : {std::pair{past_screw, "past screw"}, {past_nut, "past nut"}})
    if (std::abs(at - order) <= 0.5 * resolution && least > 1) best = name;
  return best;
}

Figure travel_orders(const Result& result, const LoadCaseResult& shown) {
  constexpr std::size_t kNamed = 6;
  const TravelResult& t = *shown.full->travel;
  Figure figure = figure_of("travel_orders", "Travel deviation by orders", shown);
  Series lines{
      figure.add(fmt::format("spectrum, {:.3g} apart", 1.0 / std::abs(t.travel.turns)), line_of(Colour::blue))};
  std::vector<const OrderAmplitude*> largest;
  for (const OrderAmplitude& o : t.spectrum) {
    lines.parts.push_back({{o.order, 0.0}, {o.order, o.amplitude * "µm"_per_si}});
    largest.push_back(&o);
  }
  std::ranges::sort(largest, std::greater<>(), &OrderAmplitude::amplitude);
  largest.resize(std::min(largest.size(), kNamed));
  Series fitted{figure.add("orders of the parts, fitted", points_of(Colour::vermillion, Mark::circle))};
  Polyline points;
  for (const OrderAmplitude& o : t.orders) points.push_back({o.order, o.amplitude * "µm"_per_si});
  fitted.parts = {std::move(points)};
  Panel panel{.series = {std::move(lines), std::move(fitted)}};
  const auto base = motion_orders(result.contacts.mechanism, t.slip_ratio);
  for (const OrderAmplitude* o : largest)
    if (o->amplitude > 0.02 * largest.front()->amplitude)
      panel.labels.push_back(
          {combination(o->order, 1.0 / std::abs(t.travel.turns), base), o->order, o->amplitude * "µm"_per_si});
  figure.x = {"Periods in a turn"};
  figure.y = {"Amplitude", "µm", 0.0};
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure travel_thread_loads(const Result&, const LoadCaseResult& shown) {
  const TravelResult& t = *shown.full->travel;
  if (t.loads.screw.of_roller.empty()) return {};
  Figure figure = figure_of("travel_loads", "The most loaded roller over the travel", shown);
  figure.columns = 2;
  for (const Interface i : kInterfaces) {
    const TravelLoads& loads = t.loads[i];
    Panel panel{.title = fmt::format("{}, roller {}", interface_title(i), loads.roller)};
    const std::size_t threads = loads.of_roller.front().size();
    for (const std::size_t k : {std::size_t{0}, threads / 2, threads - 1}) {
      Polyline line;
      for (const auto p : indices(t.angle)) line.push_back({turns_at(t, p), loads.of_roller[p][k]});
      const std::size_t style = i == Interface::screw
                                    ? figure.add(fmt::format("thread {}", k + 1), line_number(panel.series.size()))
                                    : panel.series.size();
      panel.series.push_back({style, {std::move(line)}});
    }
    figure.panels.push_back(std::move(panel));
  }
  figure.x = {"Turns of the screw against the nut"};
  figure.y = {"Normal load", "N"};
  return figure;
}

Figure travel_path(const Result&, const LoadCaseResult& shown) {
  Figure figure = figure_of("travel_path", "Path of the screw's end", shown);
  Polyline path;
  for (const Lateral& l : shown.full->travel->end_displacement) path.push_back({l.y * "µm"_per_si, l.z * "µm"_per_si});
  figure.panels.push_back({.series = {{figure.add(line_of(Colour::blue)), {std::move(path)}}}});
  figure.x = {"y", "µm"};
  figure.y = {"z", "µm"};
  figure.to_scale = true;
  return figure;
}

Figure mode_shapes(const Result&, const LoadCaseResult& shown) {
  constexpr std::size_t kMost = 6;
  constexpr const char* kNames[] = {"x", "y", "z"};
  const ModesResult& m = *shown.full->modes;
  Figure figure = figure_of("mode_shapes", "Modes, screw and nut", shown);
  figure.columns = 2;
  for (const Dash dash : {Dash::solid, Dash::dashed})
    for (const auto axis : up_to(3))
      figure.add(fmt::format("{} {}", dash == Dash::solid ? "screw" : "nut", kNames[axis]),
                 line_of(kColours[axis], dash));
  for (std::size_t k = 0; k < std::min(m.modes.size(), kMost); ++k) {
    Panel panel{.title = fmt::format("{:.5g} Hz", m.modes[k].frequency)};
    for (const Interface i : kInterfaces)
      for (const auto axis : up_to(3)) {
        Polyline line;
        for (const auto n : indices(m.x[i])) line.push_back({m.x[i][n] * "mm"_per_si, m.modes[k].shape[i][n][axis]});
        panel.series.push_back({axis + (i == Interface::screw ? 0 : 3), {std::move(line)}});
      }
    figure.panels.push_back(std::move(panel));
  }
  figure.x = {"x", "mm"};
  figure.y = {"Displacement"};
  return figure;
}

/// Adds frequencies, each a line over x of the columns.
Figure frequency_lines(Figure figure, const std::vector<std::pair<double, std::vector<double>>>& at) {
  constexpr std::size_t kMost = 12;
  Panel panel;
  for (std::size_t k = 0; k < std::min(at.front().second.size(), kMost); ++k) {
    Series series{figure.add(line_number(k))};
    for (const auto& [x, frequency] : at)
      series.add(x, k < frequency.size() ? std::optional(frequency[k]) : std::nullopt);
    panel.series.push_back(std::move(series));
  }
  figure.y = {"Natural frequency", "Hz", 0.0};
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figures mode_frequencies(const Result& result, const FigureOptions& options) {
  Figures figures;
  if (const LoadCaseResult* shown = chosen_case(result, options, has_modes_along_travel)) {
    const ModesResult::AlongTravel& along = *shown->full->modes->along_travel;
    std::vector<std::pair<double, std::vector<double>>> at;
    for (const auto k : indices(along.angle))
      at.emplace_back(along.angle[k] / (2.0 * std::numbers::pi), along.frequency[k]);
    Figure figure = figure_of("modes_over_travel", "Natural frequencies over the travel", *shown);
    figure.x = {"Turns of the screw against the nut"};
    figures.push_back(frequency_lines(std::move(figure), at));
  }
  std::vector<std::pair<double, std::vector<double>>> at;
  for (const LoadCaseResult& r : result.load_cases) {
    if (!has_modes(r) || (!at.empty() && std::abs(signed_kN(r)) == at.back().first)) continue;
    std::vector<double> frequencies;
    for (const Mode& mode : r.full->modes->modes) frequencies.push_back(mode.frequency);
    at.emplace_back(std::abs(signed_kN(r)), std::move(frequencies));
  }
  std::ranges::sort(at, {}, [](const auto& column) { return column.first; });
  if (at.size() > 2) {
    Figure figure{"modes_over_load", "Natural frequencies over the load"};
    figure.x = {"Axial force", "kN"};
    figures.push_back(frequency_lines(std::move(figure), at));
  }
  return figures;
}

Figure campbell(const Result&, const LoadCaseResult& shown) {
  constexpr std::size_t kMost = 6;
  if (shown.full->modes->orders.empty()) return {};
  const ModesResult& m = *shown.full->modes;
  Figure figure = figure_of("campbell", "Speeds at which orders meet natural frequencies", shown);
  const std::size_t modes = std::min(m.modes.size(), kMost);
  const auto [slowest, fastest] = std::ranges::minmax(m.orders, {}, &MotionOrder::order);
  const double speed = 1.2 * 60.0 * m.modes[0].frequency / slowest.order;  // Every order crosses the lowest frequency.
  const double highest = std::min(1.1 * m.modes[modes - 1].frequency, speed / 60.0 * fastest.order);
  Panel panel;
  for (const auto k : indices(m.orders)) {
    const double end = std::min(speed, 60.0 * highest / m.orders[k].order);
    std::string name(m.orders[k].name);
    std::ranges::replace(name, '_', ' ');
    panel.series.push_back(
        {figure.add(std::move(name), line_number(k)), {{{0.0, 0.0}, {end, m.orders[k].order * end / 60.0}}}});
  }
  const std::size_t style = figure.add("natural frequency", line_of(Colour::ink, Dash::dashed, Weight::thin));
  for (const Mode& mode : m.modes)
    if (mode.frequency < highest) panel.references.push_back({style, mode.frequency});
  figure.x = {"Speed of screw against nut", "rpm", 0.0, speed};
  figure.y = {"Frequency", "Hz", 0.0, highest};
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace

std::vector<Headline> frequencies(const Result& result) {
  std::vector<Headline> headlines;
  const LoadCaseResult* lowest = nullptr;
  for (const LoadCaseResult& r : result.load_cases)
    if (has_modes(r) && (!lowest || r.full->modes->modes[0].frequency < lowest->full->modes->modes[0].frequency))
      lowest = &r;
  if (!lowest) return headlines;
  const double frequency = lowest->full->modes->modes[0].frequency;
  headlines.push_back({"Lowest natural frequency", "frequency_Hz", frequency, lowest->load_case.name});
  double most = 0.0;
  for (const MotionOrder& o : lowest->full->modes->orders) most = std::max(most, o.order);
  headlines.push_back({"Lowest speed at which an order meets it", "critical_speed_rpm",
                       2.0 * std::numbers::pi * frequency / most, lowest->load_case.name});
  return headlines;
}

Pictures motion_pictures(const Result& r) {
  constexpr const char* kTravel = "`travel` in a load case of the full mechanism, and errors that turn";
  constexpr const char* kModes = "`modes` in a load case of the full mechanism";
  return {{"travel_deviation", kTravel, of_case(r, has_travel, travel_deviation)},
          {"travel_orders", kTravel, of_case(r, has_travel, travel_orders)},
          {"travel_loads", kTravel, of_case(r, has_travel, travel_thread_loads)},
          {"travel_path", kTravel, of_case(r, has_travel, travel_path)},
          {"mode_shapes", kModes, of_case(r, has_modes, mode_shapes)},
          {"mode_frequencies", "`modes` with `positions`, or of three loads", of_result(r, mode_frequencies)},
          {"campbell", kModes, of_case(r, has_modes, campbell)}};
}

}  // namespace prs
