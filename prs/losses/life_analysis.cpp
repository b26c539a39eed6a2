#include "prs/losses/life_analysis.h"

#include "prs/heat/warm_parts.h"
#include "prs/input/force_history.h"
#include "prs/life/life_record.h"
#include "prs/loads/load_json.h"
#include "prs/record/figure_parts.h"

namespace prs {
namespace {

/// Columns of an overview of a history.
constexpr std::size_t kOverviewColumns = 600;
constexpr double kBillionth = 1e-9;

Polyline bar(double middle, double from, double to, double half_width) {
  return rectangle(middle - half_width, middle + half_width, from, to);
}

bool has_lives(const LifeResult& r) { return r.converged() && r.weakest; }

/// Flanks that are loaded, with both interfaces side by side.
template <class Draw>
void thread_panels(const LifeResult& r, Figure& figure, Draw draw) {
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces)
      if (r.flanks[d]) {
        figure.panels.push_back({fmt::format("{}, {}", interface_title(i), name(d))});
        draw(figure.panels.back(), *r.flanks[d], i);
      }
  figure.x = thread_axis(static_cast<std::size_t>(r.contacts.mechanism.contacts_per_roller));
  figure.columns = 2;
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
  Series envelope{0, {}};
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
  panel.x = Axis{clock ? "Time" : "Sample", clock ? "h" : "", time(0), time(count - 1)};
  const double margin = 0.05 * (greatest - least);
  panel.y = Axis{std::string(kSignedForce), "kN", least - margin, greatest + margin};
  panel.series.push_back(std::move(envelope));
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
  Series shares{0, {}}, damages{1, {{}}};
  double top = 0.0;
  for (std::size_t k = 0; k < share.size(); ++k) {
    const double x = (least + width * (static_cast<double>(k) + 0.5)) * per_si::kilonewton;
    const double part = all_damage > 0.0 ? damage[k] / all_damage : 0.0;
    shares.parts.push_back(
        bar(x, 0.0, per_si::percent * share[k], 0.46 * width * per_si::kilonewton));
    damages.parts[0].push_back({x, per_si::percent * part});
    top = std::max({top, share[k], part});
  }
  panel.series = {std::move(shares), std::move(damages)};
  panel.x = Axis{std::string(kSignedForce), "kN", least * per_si::kilonewton,
                 greatest * per_si::kilonewton};
  panel.y = Axis{"Share", "%", 0.0, 1.08 * top * per_si::percent};
  return panel;
}

/// Equivalent axial load of each thread.
Figures thread_loads(const LifeResult& r) {
  if (!has_lives(r)) return {};
  Figure figure{"thread_loads", "Equivalent axial load of a thread"};
  figure.y = {"Axial load", "N"};
  figure.add("equivalent load, cubic mean", area_of(Colour::sky));
  if (r.cycles)
    figure.add(fmt::format("equivalent range, slope {:g}", r.life.fatigue_slope),
               points_of(Colour::vermillion, Mark::circle));
  thread_panels(r, figure, [&](Panel& panel, const auto& flank, Interface i) {
    const ThreadLives& t = flank.threads[i];
    Series bars{0};
    for (std::size_t k = 0; k < t.equivalent_load.size(); ++k)
      bars.parts.push_back(bar(static_cast<double>(k + 1), 0.0, t.equivalent_load[k], 0.38));
    panel.series.push_back(std::move(bars));
    if (r.cycles) panel.series.push_back({1, {over_threads(t.equivalent_range, 1.0)}});
  });
  fit_y_range(figure);
  return {std::move(figure)};
}

/// Basic rating life of each thread on all rollers.
Figures thread_lives(const LifeResult& r) {
  if (!has_lives(r)) return {};
  Figure figure{"thread_lives", "Life of a thread on all rollers"};
  figure.y = {"L10", "10⁹ revolutions"};
  figure.y.logarithmic = true;
  figure.add("thread", points_of(Colour::blue, Mark::circle));
  figure.add("all threads of this sense", line_of(Colour::vermillion, Dash::dashed));
  Range lives;
  thread_panels(r, figure, [&](Panel& panel, const auto& flank, Interface i) {
    Series points{0, {{}}};
    const std::vector<double>& life = flank.threads[i].life;
    for (std::size_t k = 0; k < life.size(); ++k)
      if (std::isfinite(life[k])) {
        points.parts[0].push_back({static_cast<double>(k + 1), life[k] * kBillionth});
        lives.include(life[k] * kBillionth);
      }
    if (!points.parts[0].empty()) panel.series.push_back(std::move(points));
    if (std::isfinite(flank.life)) panel.references.push_back({1, flank.life * kBillionth});
    lives.include(flank.life * kBillionth);
  });
  // Threads that hardly ever carry would press the others together.
  constexpr double kLargestRatio = 1e5;
  figure.y.from = 0.7 * lives.from;
  figure.y.to = std::min(1.4 * lives.to, kLargestRatio * lives.from);
  return {std::move(figure)};
}

/// Course of the load, and revolutions and damage over it.
Figures load_history(const LifeResult& r) {
  Figure figure{"loads", r.history ? "Load history" : "Load spectrum"};
  figure.columns = r.history ? 2 : 1;
  figure.add(r.history ? "load, revolutions" : "revolutions", area_of(Colour::sky));
  figure.add("damage, |F|³ times revolutions",
             {Colour::vermillion, Dash::solid, Mark::circle, Weight::thin});
  if (r.history) figure.panels.push_back(course_panel(*r.history));
  figure.panels.push_back(travel_panel(r));
  return {std::move(figure)};
}

/// Rainflow matrix: how many load cycles have which mean and range.
Figures rainflow(const LifeResult& r) {
  if (!r.cycles) return {};
  const CycleMatrix& m = r.cycles->matrix;
  if (!(m.range_to > 0.0 && m.mean_to > m.mean_from)) return {};
  Figure figure{"rainflow", fmt::format("Load cycles, rainflow: {:.0f}", count(r.cycles->cycles))};
  figure.x = {"Mean, tension >\u00a00", "kN", m.mean_from * per_si::kilonewton,
              m.mean_to * per_si::kilonewton};
  figure.y = {"Range", "kN", 0.0, m.range_to * per_si::kilonewton};
  Panel panel;
  panel.map.cells = true;
  GridData& grid = panel.map.grid;
  const auto bins = static_cast<std::size_t>(m.bins);
  grid.values.assign(bins * bins, kFree);
  Range cycles;
  for (std::size_t k = 0; k < bins; ++k) {
    const double middle = static_cast<double>(k) + 0.5;
    grid.x.push_back((m.mean_from + middle * m.mean_width()) * per_si::kilonewton);
    grid.y.push_back(middle * m.range_width() * per_si::kilonewton);
    for (std::size_t i = 0; i < bins; ++i)
      if (const double n = m.at(static_cast<int>(i), static_cast<int>(k)); n > 0.0) {
        grid.values[k * bins + i] = n;
        cycles.include(n);
      }
  }
  if (cycles.empty()) return {};
  figure.colours = ColourScale{"Cycles", "", cycles.from, std::max(cycles.to, 10.0 * cycles.from)};
  figure.colours->logarithmic = true;
  figure.panels.push_back(std::move(panel));
  return {std::move(figure)};
}

std::vector<OutputFile> life_files(const LifeResult& result, const CsvStyle& style) {
  std::vector<OutputFile> files = {{"life_threads.csv", life_threads_csv(result, style)}};
  const bool of_rollers = std::ranges::any_of(kDirections, [&](Direction d) {
    return result.flanks[d] && result.flanks[d]->threads.screw.rollers;
  });
  if (of_rollers) files.push_back({"life_rollers.csv", life_rollers_csv(result, style)});
  if (result.cycles) {
    files.push_back({"cycles.csv", cycles_csv(*result.cycles, style)});
    files.push_back({"cycle_matrix.csv", cycle_matrix_csv(result.cycles->matrix, style)});
  }
  return files;
}

constexpr const char* kLives = "a load history or spectrum under which loads converge";

/// Of a stated capacity, which is of real screws, the catalogue's life is the headline.
PageSection life_section(const LifeResult& r) {
  const bool solved = r.life.share == LoadCase::Share::solved, stated = !r.lemor;
  const std::vector<std::string> lives =
      r.rated_over_l10() == 1.0
          ? std::vector<std::string>{"l10_revolutions", "l10_hours", "l10_travel_km", "l10_passes"}
          : std::vector<std::string>{"rated_revolutions", "rated_hours", "rated_travel_km",
                                     "rated_passes"};
  PageSection page{.in_document = {{"life",
                                    {"status", "share", "reliability_factor", "modification_factor",
                                     "static_safety", "static_safety_limit"}}},
                   .folded = {"thread_lives"}};
  if (stated) page.in_document.push_back({"life.catalogue", lives});
  page.in_document.push_back({"life.system", lives});
  page.in_document.push_back(
      {"life.weakest_thread",
       {"direction", "interface", "part", "roller", "thread", "equivalent_load_N"}});
  if (solved) page.estimates = {"equal_shares"};
  if (solved && !stated) page.estimates.emplace_back("catalogue");
  if (solved && stated) page.note = kStatedCapacityNote;
  return page;
}

constexpr std::string_view kLifeResponses[] = {
    "life.system.l10_revolutions", "life.catalogue.l10_revolutions",
    "life.weakest_thread.equivalent_load_N", "life.capacity.dynamic_capacity_N",
    "life.static_safety"};

}  // namespace

LifeResult life_of(const input::Source& source, const input::CaseInput& in) {
  std::optional<LoadHistory> history;
  if (in.values.life->history)
    history = input::read_force_history(*in.values.life->history, source);
  return analyze_warm_life(in.values, std::move(history));
}

const Analysis<LifeResult>& life_analysis() {
  static const std::vector<Place> places = with_contacts({{"life", describe<LifeResult>}});
  static const Analysis<LifeResult> analysis{
      .command = Command::life,
      .help = "Life under a load history or spectrum, static safety",
      .file = "life.json",
      .run = [](const input::Source& source,
                const input::CaseInput& in) { return life_of(source, in); },
      .places = places,
      .put =
          [](Json& document, const LifeResult& r) {
            put_contacts(document, r.contacts);
            document["life"] = object_of(r);
          },
      .table = life_table,
      .full_table = full_life_table,
      .files = life_files,
      .pictures = [](const LifeResult& r, const Case&) -> Pictures {
        return {{"loads", "a load history or spectrum", of_result(r, load_history)},
                {"rainflow", "a load history, not a spectrum, with cycles", of_result(r, rainflow)},
                {"thread_loads", kLives, of_result(r, thread_loads)},
                {"thread_lives", kLives, of_result(r, thread_lives)}};
      },
      .converged = [](const LifeResult& r) { return r.converged(); },
      .place = {"Life", 1},
      .section = life_section,
      .responses = kLifeResponses};
  return analysis;
}

}  // namespace prs
