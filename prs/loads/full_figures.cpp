#include "contact/thread_surface.h"
#include "prs/loads/full_result.h"
#include "prs/loads/load_pictures.h"
#include "prs/model/units.h"

namespace prs {
namespace {

bool has_turn(const LoadCaseResult& result) { return has_rollers(result) && result.full->orbit; }

Axis roller_axis(int rollers) { return {"Roller", {}, 0.5, rollers + 0.5, false, true}; }

/// Rollers over threads, unrolled, of values in shown units.
GridData unrolled(const std::vector<double>& of_threads, int threads_per_roller) {
  GridData grid;
  const auto threads = static_cast<std::size_t>(threads_per_roller);
  const std::size_t rollers = of_threads.size() / threads;
  for (std::size_t k = 0; k < threads; ++k) grid.x.push_back(static_cast<double>(k + 1));
  for (std::size_t j = 0; j < rollers; ++j) grid.y.push_back(static_cast<double>(j + 1));
  for (std::size_t k = 0; k < threads; ++k)
    for (std::size_t j = 0; j < rollers; ++j) grid.values.push_back(of_threads[j * threads + k]);
  return grid;
}

/// Rollers that are not there have no colour, not that of zero.
void without_missing(Panel& panel, const FullLoads& full) {
  GridData& grid = panel.map.grid;
  for (const int roller : full.missing_rollers) {
    for (std::size_t k = 0; k < grid.x.size(); ++k)
      grid.values[k * grid.y.size() + static_cast<std::size_t>(roller - 1)] = kFree;
    panel.labels.push_back({"missing", 0.5 * (grid.x.front() + grid.x.back()),
                            static_cast<double>(roller), false, Label::Anchor::centre});
  }
}

/// From the least to the largest value of all load cases, so that their pictures compare.
Range range_of(const Result& result, const OfThreads& of) {
  Range range;
  for (const LoadCaseResult& load_case : result.load_cases)
    for (const Interface i : kInterfaces)
      if (of.has(load_case))
        for (const double value : of.values(load_case, i)) range.include(value);
  return range;
}

std::array<double, 2> towards(double radius, double azimuth) {
  return {radius * std::cos(azimuth), radius * std::sin(azimuth)};
}

}  // namespace

bool has_rollers(const LoadCaseResult& result) { return result.full && result.threads; }

Figure map_of_rollers(Figure figure, const Result& result, const LoadCaseResult& shown,
                      ColourScale colours, const OfThreads& of) {
  const int threads = shown.threads->screw.threads_per_roller;
  const Range range = range_of(result, of);
  for (const Interface i : kInterfaces) {
    Panel& panel = figure.panels.emplace_back();
    panel.title = interface_title(i);
    panel.map = {unrolled(of.values(shown, i), threads), true};
    without_missing(panel, *shown.full);
  }
  figure.x = thread_axis(static_cast<std::size_t>(threads));
  figure.y = roller_axis(shown.full->rollers);
  figure.columns = 2;
  colours.from = std::min(range.from, 0.0);
  colours.to = range.to;
  figure.colours = std::move(colours);
  return figure;
}

namespace {

/// Normal load of every thread of every roller, at both interfaces.
Figures roller_loads(const Result& result, const FigureOptions& options) {
  const LoadCaseResult* shown = chosen_case(result, options, has_rollers);
  if (!shown) return {};
  constexpr OfThreads kNormalLoads{
      has_rollers, [](const LoadCaseResult& r, Interface i) -> const std::vector<double>& {
        return (*r.threads)[i].normal_load;
      }};
  return {map_of_rollers(
      {"roller_loads", fmt::format("Loads of all rollers, {}", shown_name(shown->load_case.name))},
      result, *shown, {"Normal load", "N"}, kNormalLoads)};
}

/// Share of each roller in % of equal shares, at its place around the axis, between screw and nut.
Figures roller_shares(const Result& result, const FigureOptions& options) {
  const LoadCaseResult* shown = chosen_case(result, options, has_rollers);
  if (!shown) return {};
  Figure figure{"roller_shares",
                fmt::format("Shares of the rollers, {}", shown_name(shown->load_case.name))};
  const contact::MechanismGeometry& threads = result.contacts.threads;
  const auto circle = [](double y, double z, double radius) {
    return ellipse(y, z, radius, radius, 0.0);
  };
  const double nut = contact::ThreadSurface(threads.nut).pitch_radius;
  const double screw = contact::ThreadSurface(threads.screw).pitch_radius;
  Panel& panel = figure.panels.emplace_back();
  panel.series.push_back(
      {figure.add("screw, pitch circle", line_of(colour_of(Part::screw))), {circle(0, 0, screw)}});
  panel.series.push_back(
      {figure.add("nut, pitch circle", line_of(colour_of(Part::nut))), {circle(0, 0, nut)}});
  Series rollers{figure.add(area_of(colour_of(Part::roller)))};
  const std::vector<double>& share = shown->threads->screw.rollers->share;
  const int count = shown->full->rollers;
  Range range;  // The same in all load cases.
  for (const LoadCaseResult& load_case : result.load_cases)
    if (has_rollers(load_case))
      for (const double part : load_case.threads->screw.rollers->share)
        range.include(part * load_case.full->rollers * per_si::percent);
  for (int j = 0; j < count; ++j) {
    const double azimuth = shown->full->carrier_angle + 2.0 * std::numbers::pi * j / count;
    const auto [y, z] = towards(threads.centre_distance, azimuth);
    const auto [at_y, at_z] = towards(1.13 * nut, azimuth);
    const bool missing = std::ranges::count(shown->full->missing_rollers, j + 1) > 0;
    const double percent = share[static_cast<std::size_t>(j)] * count * per_si::percent;
    panel.labels.push_back({missing ? "missing" : number(percent, 0) + " %", at_y, at_z, false,
                            Label::Anchor::centre});
    if (missing) continue;
    panel.labels.push_back({fmt::to_string(j + 1), y, z, false, Label::Anchor::centre});
    rollers.parts.push_back(circle(y, z, contact::ThreadSurface(threads.roller).pitch_radius));
    rollers.values.push_back(percent);
  }
  panel.series.push_back(std::move(rollers));
  constexpr double kUsual = 150.0;  // So that equal shares do not look like a peak.
  figure.colours = ColourScale{"Share of the roller", "% of equal shares",
                               std::min(0.0, range.from), std::max(kUsual, range.to)};
  const double reach = 1.25 * nut;
  figure.x = {"y", {}, -reach, reach};
  figure.y = {"z", {}, -reach, reach};
  figure.x.hidden = figure.y.hidden = true;
  figure.to_scale = true;
  figure.aspect = 0.7;
  return {std::move(figure)};
}

/// Largest thread load of the first roller that is there over a turn of the carrier.
Figures carrier_turn(const Result& result, const FigureOptions& options) {
  const LoadCaseResult* shown = chosen_case(result, options, has_turn);
  if (!shown) return {};
  const Orbit& orbit = *shown->full->orbit;
  if (orbit.carrier_angle.empty()) return {};
  constexpr double kTurn = 360.0;
  Figure figure{"carrier_turn", fmt::format("One roller over a turn of the carrier, {}",
                                            shown_name(shown->load_case.name))};
  Panel& panel = figure.panels.emplace_back();
  for (const Interface i : kInterfaces) {
    Polyline line;
    for (std::size_t m = 0; m < orbit.carrier_angle.size(); ++m)
      line.push_back({orbit.carrier_angle[m] * per_si::degree, orbit.loads[i].first_roller[m]});
    line.push_back({line.front()[0] + kTurn, line.front()[1]});  // Where it began.
    panel.series.push_back(
        {figure.add(interface_title(i), line_of(colour_of(body_of(i)),
                                                i == Interface::nut ? Dash::dashed : Dash::solid)),
         {std::move(line)}});
  }
  const double start = panel.series.front().parts.front().front()[0];
  figure.x = {"Angle of the carrier", "°", start, start + kTurn};
  for (double turned = 0.0; turned <= kTurn; turned += 60.0)
    figure.x.ticks.push_back({start + turned});
  // The first that is there.
  const std::vector<int>& missing = shown->full->missing_rollers;
  int roller = 1;
  while (std::ranges::count(missing, roller) > 0) ++roller;
  figure.y = {fmt::format("Largest normal load of roller {}", roller), "N"};
  fit_y_range(figure);
  figure.y.from = 0.0;
  figure.y.to *= 1.1;
  return {std::move(figure)};
}

}  // namespace

Pictures roller_pictures(const Result& r) {
  constexpr const char* kNeeds = "a load case of `model: {mechanism: full}` that converged";
  return {
      {"roller_loads", kNeeds, of_result(r, roller_loads)},
      {"roller_shares", kNeeds, of_result(r, roller_shares)},
      {"carrier_turn", "`orbit` in a load case of the full mechanism", of_result(r, carrier_turn)}};
}

}  // namespace prs
