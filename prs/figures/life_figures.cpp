#include "prs/figures/life_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "prs/model/units.h"
#include "prs/figures/figure_style.h"

namespace prs {
namespace {

/// Columns of an overview of a history.
constexpr std::size_t kOverviewColumns = 600;
constexpr double kBillionth = 1e-9;

Polyline bar(double middle, double from, double to, double half_width) {
  return {{middle - half_width, from},
          {middle + half_width, from},
          {middle + half_width, to},
          {middle - half_width, to}};
}

/// Flanks that are loaded, with both interfaces beside each other.
template <class Draw>
void thread_panels(const LifeResult& r, Figure& figure, Draw draw) {
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces)
      if (r.flanks[d]) {
        figure.panels.push_back({fmt::format("{}, {}", interface_title(i), name(d))});
        draw(figure.panels.back(), r.flanks[d]->threads[i]);
      }
  const auto threads = r.contacts.mechanism.contacts_per_roller;
  figure.x = {"Thread, from the loaded end of the screw", 0.4, threads + 0.6, {1}};
  const int step = threads <= 10 ? 1 : threads <= 30 ? 5 : 10 * ((threads + 99) / 100);
  for (int tic = step; tic <= threads; tic += step)
    if (tic > 1) figure.x.tics.push_back(tic);
  figure.columns = 2;
}

Figure load_figure(const LifeResult& r) {
  Figure figure;
  figure.name = "thread_loads";
  figure.title = "Equivalent axial load of a thread";
  figure.y.label = "Axial load (N)";
  add_to_legend(figure, "equivalent load, cubic mean", fill_of("#88aadd"));
  const std::size_t range =
      r.cycles
          ? add_to_legend(figure, fmt::format("equivalent range, slope {:g}", r.life.fatigue_slope),
                          points_of("#bb5566", 7, 1.6))
          : 0;
  double greatest = 0.0;
  thread_panels(r, figure, [&](Panel& panel, const ThreadLives& t) {
    Line bars{0, {}}, ranges{range, {{}}};
    for (std::size_t k = 0; k < t.equivalent_load.size(); ++k) {
      const double x = static_cast<double>(k + 1);
      bars.parts.push_back(bar(x, 0.0, t.equivalent_load[k], 0.38));
      greatest = std::max(greatest, t.equivalent_load[k]);
      if (t.equivalent_range.empty()) continue;
      ranges.parts[0].push_back({x, t.equivalent_range[k]});
      greatest = std::max(greatest, t.equivalent_range[k]);
    }
    panel.lines.push_back(std::move(bars));
    if (r.cycles) panel.lines.push_back(std::move(ranges));
  });
  figure.y.from = 0.0;
  figure.y.to = 1.08 * greatest;
  return figure;
}

Figure life_figure(const LifeResult& r) {
  Figure figure;
  figure.name = "thread_lives";
  figure.title = "Life of a thread on all rollers";
  figure.y.label = "L10 (10⁹ revolutions)";
  figure.y.logarithmic = true;
  add_to_legend(figure, "thread", points_of("#004488", 7, 2.0));
  add_to_legend(figure, "all threads of this sense", {"#bb5566", 2, 0, 1.8});
  double least = HUGE_VAL, greatest = 0.0;
  for (const Direction d : kDirections)
    if (r.flanks[d]) least = std::min(least, r.flanks[d]->life * kBillionth);
  thread_panels(r, figure, [&](Panel& panel, const ThreadLives& t) {
    Line points{0, {{}}};
    for (std::size_t k = 0; k < t.life.size(); ++k) {
      if (!std::isfinite(t.life[k])) continue;
      points.parts[0].push_back({static_cast<double>(k + 1), t.life[k] * kBillionth});
      greatest = std::max(greatest, t.life[k] * kBillionth);
    }
    if (!points.parts[0].empty()) panel.lines.push_back(std::move(points));
  });
  std::size_t panel = 0;
  for (const Direction d : kDirections)
    if (r.flanks[d])
      for (std::size_t k = 0; k < std::size(kInterfaces); ++k, ++panel)
        if (std::isfinite(r.flanks[d]->life))
          figure.panels[panel].lines.push_back({1,
                                                {{{figure.x.from, r.flanks[d]->life * kBillionth},
                                                  {figure.x.to, r.flanks[d]->life * kBillionth}}}});
  figure.y.from = 0.7 * least;
  // Threads that hardly ever carry would press the others together.
  figure.y.to = std::min(1.4 * greatest, 1e5 * least);
  return figure;
}

/// Smallest and largest force of each column, as bars.
Panel course_panel(const LoadHistory& h) {
  Panel panel{"Course"};
  const std::size_t count = h.force.size();
  const bool clock = !h.time.empty() || h.interval;
  const auto time = [&](std::size_t k) {
    if (!h.time.empty()) return (h.time[k] - h.time.front()) / 3600.0;
    if (h.interval) return *h.interval * static_cast<double>(k) / 3600.0;
    return static_cast<double>(k + 1);
  };
  const std::size_t columns = std::min(kOverviewColumns, count);
  Line envelope{0, {}};
  double least = 0.0, greatest = 0.0;
  for (std::size_t c = 0; c < columns; ++c) {
    const std::size_t first = c * count / columns;
    const std::size_t last = std::min((c + 1) * count / columns, count - 1);
    const auto [low, high] =
        std::minmax_element(h.force.begin() + static_cast<std::ptrdiff_t>(first),
                            h.force.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const double from = time(first), to = time(last);
    envelope.parts.push_back(bar(0.5 * (from + to), *low * per_si::kilonewton,
                                 *high * per_si::kilonewton, 0.5 * (to - from)));
    least = std::min(least, *low * per_si::kilonewton);
    greatest = std::max(greatest, *high * per_si::kilonewton);
  }
  panel.x = Axis{clock ? "Time (h)" : "Sample", time(0), time(count - 1)};
  const double margin = 0.05 * (greatest - least);
  panel.y = Axis{"Axial force (kN), tension > 0", least - margin, greatest + margin};
  panel.lines.push_back(std::move(envelope));
  return panel;
}

/// Share of the revolutions over the force.
Panel travel_panel(const LifeResult& r) {
  constexpr int kBins = 40;
  Panel panel{"Revolutions under load"};
  double least = 0.0, greatest = 0.0;
  for (const LoadStep& s : r.steps) {
    least = std::min(least, s.axial_force);
    greatest = std::max(greatest, s.axial_force);
  }
  const double width = (greatest - least) / kBins;
  std::vector<double> share(kBins, 0.0), damage(kBins, 0.0);
  double all_damage = 0.0;
  for (const LoadStep& s : r.steps) {
    const auto bin = static_cast<std::size_t>(
        std::clamp(static_cast<int>((s.axial_force - least) / width), 0, kBins - 1));
    const double done = std::pow(std::abs(s.axial_force), kLifeExponent) * s.revolutions;
    share[bin] += s.revolutions / r.revolutions;
    damage[bin] += done;
    all_damage += done;
  }
  Line shares{0, {}}, damages{1, {{}}};
  double top = 0.0;
  for (std::size_t k = 0; k < share.size(); ++k) {
    const double x = (least + width * (static_cast<double>(k) + 0.5)) * per_si::kilonewton;
    const double part = all_damage > 0.0 ? damage[k] / all_damage : 0.0;
    shares.parts.push_back(
        bar(x, 0.0, per_si::percent * share[k], 0.46 * width * per_si::kilonewton));
    damages.parts[0].push_back({x, per_si::percent * part});
    top = std::max({top, share[k], part});
  }
  panel.lines = {std::move(shares), std::move(damages)};
  panel.x = Axis{"Axial force (kN), tension > 0", least * per_si::kilonewton,
                 greatest * per_si::kilonewton};
  panel.y = Axis{"Share (%)", 0.0, 1.08 * top * per_si::percent};
  return panel;
}

Figure history_figure(const LifeResult& r) {
  Figure figure;
  figure.name = "loads";
  figure.title = r.history ? "Load history" : "Load spectrum";
  figure.columns = r.history ? 2 : 1;
  figure.panel_height = 330;
  add_to_legend(figure, r.history ? "load, revolutions" : "revolutions", fill_of("#88aadd"));
  add_to_legend(figure, "damage, |F|³ times revolutions", {"#bb5566", 1, 7, 1.4});
  if (r.history) figure.panels.push_back(course_panel(*r.history));
  figure.panels.push_back(travel_panel(r));
  return figure;
}

Figure rainflow_figure(const LoadCycles& cycles) {
  const CycleMatrix& m = cycles.matrix;
  Figure figure;
  figure.name = "rainflow";
  figure.title = fmt::format("Load cycles, rainflow: {:.0f}", count(cycles.cycles));
  figure.panel_height = 470;
  figure.x = {"Mean (kN), tension > 0", m.mean_from * per_si::kilonewton,
              m.mean_to * per_si::kilonewton};
  figure.y = {"Range (kN)", 0.0, m.range_to * per_si::kilonewton};
  Panel panel{""};
  panel.map.width = m.mean_width() * per_si::kilonewton;
  panel.map.height = m.range_width() * per_si::kilonewton;
  ColourScale colours{"log10 of the cycles", HUGE_VAL, -HUGE_VAL};
  for (int i = 0; i < m.bins; ++i)
    for (int k = 0; k < m.bins; ++k) {
      if (m.at(i, k) == 0.0) continue;
      const double value = std::log10(m.at(i, k));
      panel.map.cells.push_back({(m.mean_from + (k + 0.5) * m.mean_width()) * per_si::kilonewton,
                                 (i + 0.5) * m.range_width() * per_si::kilonewton, value});
      colours.from = std::min(colours.from, value);
      colours.to = std::max(colours.to, value);
    }
  if (!(colours.from < colours.to)) colours.from = colours.to - 1.0;
  figure.colours = colours;
  figure.panels = {std::move(panel)};
  return figure;
}

bool spreads(const CycleMatrix& m) { return m.range_to > 0.0 && m.mean_to > m.mean_from; }

}  // namespace

std::vector<Figure> life_figures(const LifeResult& r) {
  std::vector<Figure> figures;
  figures.push_back(history_figure(r));
  if (r.cycles && spreads(r.cycles->matrix)) figures.push_back(rainflow_figure(*r.cycles));
  if (!r.converged() || !r.weakest) return figures;
  figures.push_back(load_figure(r));
  figures.push_back(life_figure(r));
  return figures;
}

}  // namespace prs
