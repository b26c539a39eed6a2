#include "prs/losses/life_analysis.h"

#include "prs/heat/analyze_heat.h"
#include "prs/indices.h"
#include "prs/input/force_history.h"
#include "prs/life/life_criteria.h"
#include "prs/life/life_record.h"
#include "prs/loads/case_table.h"
#include "prs/loads/load_analysis.h"
#include "prs/loads/load_record.h"
#include "prs/record/csv_rows.h"
#include "prs/record/table_layout.h"
#include "prs/text.h"

namespace prs {
namespace {

std::string life_line(const std::string& what, const std::string& value) { return hanging("  " + what, 41, value); }

std::string kilonewtons(std::optional<double> force) { return significant_with_unit(force, "kN"); }

std::string cell(std::optional<double> value, double factor = 1.0) { return significant(scaled(value, factor)); }

constexpr TableRows kLifeRows{40, 15};

std::string life_row(const LifeResult& r, const std::string& what, double revolutions) {
  const LifeInUse life = in_use(r, revolutions);
  std::vector<std::string> cells{cell(life.revolutions, 1e-6), cell(life.hours),
                                 cell(life.travel, table_unit("km").factor)};
  if (r.revolutions_known) cells.push_back(cell(life.passes));
  return kLifeRows("  " + what, cells);
}

/// Whether the rated life is another than L10.
bool is_rated(const LifeResult& r) { return r.rated_over_l10() != 1.0; }

std::string reliability(const LifeResult& r) { return fmt::format("{:.4g} %", 100.0 * r.life.reliability); }

/// `thread 3.1 at the screw, tension` where it is one of roller 3.
std::string weakest_thread(const WeakestThread& w) {
  const std::string number =
      w.roller ? fmt::format("{}.{}", *w.roller + 1, w.thread + 1) : fmt::to_string(w.thread + 1);
  return fmt::format("thread {} {} the {}, {}", number, w.part && !w.roller ? "of" : "at", name(w.interface),
                     name(w.direction));
}

/// The headline is the life with the real thread loads or, with a maker's capacity, that of the
/// catalogue's formula: such a capacity comes from real screws, and uneven sharing is in it.
std::string lives(const LifeResult& r, bool all) {
  const bool solved = r.life.share == LoadCase::Share::solved;
  const bool given = !r.lemor;
  const bool by_the_clock = r.duration.has_value();
  std::vector<std::string> heads{"million rev.", by_the_clock ? "hours" : "h of motion", with_table_unit("km")};
  if (r.revolutions_known) heads.emplace_back(r.history ? "histories" : "spectra run");
  std::string text = kLifeRows("  Life L10, thread loads " + words_of_text(name(r.loads)), heads);
  const std::string_view system = solved ? "mechanism, real thread loads" : "mechanism, equal thread loads";
  text += life_row(r, given ? "stated C_a, (C_a/F_m)^3" : std::string(system), r.screw_life());
  if (is_rated(r))
    text += life_row(r, fmt::format("  rated, {} reach it", reliability(r)), r.rated_over_l10() * r.screw_life());
  if (given) text += life_row(r, fmt::format("  {}", system), r.system_life);
  for (const Direction d : kDirections)
    if (r.flanks[d]) text += life_row(r, fmt::format("  {} flanks alone", name(d)), r.flanks[d]->life);
  if (all && solved) text += life_row(r, "estimate: equal thread loads", r.equal_shares_life);
  if (all && !given) text += life_row(r, "estimate: (C_a/F_m)^3", r.catalogue_life);
  if (given && solved) text += wrapped(kStatedCapacityNote, "  ", kTableWidth);
  if (r.weakest) text += life_row(r, weakest_thread(*r.weakest), r.weakest->life);
  if (const auto bearing = r.bearing_life()) {
    text += life_row(r, "bearing of the shaft", *bearing);
    text += life_row(r, "screw and bearing together", *r.life_with_bearings());
  }
  return text;
}

std::string by_direction(const LifeResult& r, std::optional<double> FlankLife::*force) {
  std::string text;
  for (const Direction d : kDirections)
    if (r.flanks[d])
      text += fmt::format("{}{} in {}", text.empty() ? "" : ", ", kilonewtons((*r.flanks[d]).*force), name(d));
  return text;
}

std::string capacities(const LifeResult& r, bool all) {
  std::string text;
  const Interval& range = r.dynamic_capacity_range;
  text += life_line("dynamic capacity C_a",
                    r.lemor ? fmt::format("{} ({} to {} by which diameters f_c takes)", kilonewtons(r.dynamic_capacity),
                                          significant(shown(range.least, "kN")), kilonewtons(range.greatest))
                            : fmt::format("{} (given)", kilonewtons(r.dynamic_capacity)));
  if (r.lemor && std::isfinite(r.system_life)) {
    const auto [least, greatest] = in_use(r, r.system_life).revolutions_range;
    text += life_line("  life of the mechanism in that range",
                      fmt::format("{} to {} million revolutions", cell(least, 1e-6), cell(greatest, 1e-6)));
  }
  const Mechanism& m = r.contacts.mechanism;
  if (r.lemor && m.type == Mechanism::Type::standard && *m.pitch_diameter.screw >= kLeastComparedDiameter)
    text += life_line("  by a maker's 23 standard screws",
                      fmt::format("{} to {} (C_a is {:g} to {:g} times theirs)",
                                  significant(shown(r.dynamic_capacity / kCapacityOverMakers.greatest, "kN")),
                                  kilonewtons(r.dynamic_capacity / kCapacityOverMakers.least),
                                  kCapacityOverMakers.least, kCapacityOverMakers.greatest));
  if (is_rated(r))
    text += life_line("rated life over L10",
                      fmt::format("{:.4g} (a1 {:.4g} at {}, modification factor {:.4g})", r.rated_over_l10(),
                                  r.reliability_factor, reliability(r), r.life.modification_factor));
  if (r.modified)
    text += life_line("a_ISO of ISO 281",
                      fmt::format("{:.3g} (film ratio {:.3g}, kappa {:.3g}, contamination {:.3g}); with "
                                  "it {} million revolutions",
                                  r.modified->factor, r.modified->film_ratio, r.modified->viscosity_ratio,
                                  *r.life.contamination, cell(r.modified->factor * r.system_life, 1e-6)));
  text += life_line("mean load F_m",
                    kilonewtons(r.mean_load) + (r.life.travel ? "; travel without load does not count" : ""));
  text += life_line("largest force", kilonewtons(r.largest_force));
  if (r.life.static_capacity)
    text += life_line("static capacity C_0", kilonewtons(r.life.static_capacity) + " (given)");
  if (r.equal_shares_static_capacity) {
    text += life_line("force at the pressure limit", by_direction(r, &FlankLife::static_capacity));
    if (all) text += life_line("  with equal thread loads", kilonewtons(r.equal_shares_static_capacity));
    text += life_line("force at which edge loading begins", by_direction(r, &FlankLife::flank_edge_load));
    if (all) text += life_line("  with equal thread loads", kilonewtons(r.equal_shares_flank_edge_load));
  }
  if (r.bearing) {
    text += life_line("equivalent load of the bearing", kilonewtons(r.bearing->equivalent_load));
    if (r.bearing->static_safety)
      text += life_line("  its static safety", fmt::format("{:.2f}", *r.bearing->static_safety));
  }
  text += life_line("static safety of these loads",
                    r.static_safety()
                        ? fmt::format("{:.2f} (limited by: {})", *r.static_safety(), describe(*r.static_safety_limit()))
                        : std::string(kAbsent));
  return text;
}

std::string loads(const LifeResult& r) {
  std::string text;
  if (r.revolutions_known)
    text += life_line("revolutions, travel",
                      fmt::format("{}, {}", cell(r.revolutions),
                                  significant_with_unit(r.revolutions * std::abs(r.contacts.mechanism.lead), "m")));
  if (r.duration) text += life_line("duration", fmt::format("{} h", cell(*r.duration, 1.0 / 3600.0)));
  for (const Direction d : kDirections)
    if (const auto& f = r.flanks[d])
      text +=
          life_line(fmt::format("{}", name(d)),
                    fmt::format("{:.1f} % of the revolutions, up to {} and {}", 100.0 * f->revolutions / r.revolutions,
                                kilonewtons(f->largest_force),
                                significant_with_unit(std::max(f->peak_pressure.screw, f->peak_pressure.nut), "GPa")));
  if (r.cycles)
    text += life_line("load cycles (rainflow)",
                      fmt::format("{:.1f}, equivalent range {} at slope {:g}, up to {}", count(r.cycles->cycles),
                                  kilonewtons(r.cycles->equivalent_range), r.life.fatigue_slope,
                                  kilonewtons(r.cycles->matrix.range_to)));
  return text;
}

std::string table_with(const LifeResult& r, bool all) {
  std::string text;
  if (r.converged())
    text += lives(r, all) + '\n' + capacities(r, all) + '\n' +
            (r.history ? fmt::format("History of {} samples\n", r.steps.size())
                       : fmt::format("Spectrum of {} load{}\n", r.steps.size(), r.steps.size() == 1 ? "" : "s")) +
            loads(r);
  else
    text += fmt::format("NOT CONVERGED: {}\n", *r.failure);
  return text + warning_section(r.warnings);
}

/// Rows, one per thread of one roller or, if `Lives` has them, of all rollers.
template <class Lives>
std::string lives_csv(const LifeResult& r, const CsvStyle& style, const Lives& (*lives_of)(const ThreadLives&)) {
  constexpr bool all_rollers = std::is_same_v<Lives, RollerLives>;
  CsvRows csv(style);
  const auto add_row = [&](Direction d, Interface i, const Lives& lives, std::size_t k) {
    std::size_t threads = lives.life.size();
    if constexpr (all_rollers) threads = static_cast<std::size_t>(lives.threads_per_roller);
    threads = std::max<std::size_t>(threads, 1);
    csv("direction", name(d));
    csv("interface", name(i));
    if (all_rollers) csv("roller", k / threads + 1);
    csv("thread", k % threads + 1);
    csv.series("", lives, k);
    csv.end_row();
  };
  add_row({}, {}, {}, 0);
  csv.drop_rows();
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces)
      if (r.flanks[d]) {
        const Lives& lives = lives_of(r.flanks[d]->threads[i]);
        for (const auto k : indices(lives.life)) add_row(d, i, lives, k);
      }
  return csv.take();
}

/// The table with the estimates by equal thread loads.
std::string full_life_table(const LifeResult& r) { return table_with(r, true); }

}  // namespace

std::string life_table(const LifeResult& r) { return table_with(r, false); }
std::string life_threads_csv(const LifeResult& r, const CsvStyle& style) {
  return lives_csv<ThreadLives>(r, style, [](const ThreadLives& t) -> const ThreadLives& { return t; });
}

std::string life_rollers_csv(const LifeResult& r, const CsvStyle& style) {
  return lives_csv<RollerLives>(r, style, [](const ThreadLives& t) -> const RollerLives& { return *t.rollers; });
}

std::string cycles_csv(const LoadCycles& cycles, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.row("range_N", "mean_N", "count", "start_sample", "end_sample");
  for (const Cycle& c : cycles.cycles) csv.row(c.range(), c.mean(), c.count, c.start.index + 1, c.end.index + 1);
  return csv.take();
}

std::string cycle_matrix_csv(const CycleMatrix& m, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.row("range_from_N", "range_to_N", "mean_from_N", "mean_to_N", "count");
  for (int i = 0; i < m.bins; ++i)
    for (int k = 0; k < m.bins; ++k)
      if (m.at(i, k) != 0.0)
        csv.row(i * m.range_width(), (i + 1) * m.range_width(), m.mean_from + k * m.mean_width(),
                m.mean_from + (k + 1) * m.mean_width(), m.at(i, k));
  return csv.take();
}

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
  Range forces{0.0, 0.0};
  for (const auto c : up_to(columns)) {
    const std::size_t first = c * count / columns;
    const std::size_t last = std::min((c + 1) * count / columns, count - 1);
    const auto [low, high] = std::minmax_element(h.force.begin() + static_cast<std::ptrdiff_t>(first),
                                                 h.force.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const double from = time(first), to = time(last);
    envelope.parts.push_back(bar(0.5 * (from + to), *low * "kN"_per_si, *high * "kN"_per_si, 0.5 * (to - from)));
    forces.include(*low * "kN"_per_si);
    forces.include(*high * "kN"_per_si);
  }
  panel.x = Axis{clock ? "Time" : "Sample", clock ? "h" : "", time(0), time(count - 1)};
  forces.widen(0.05);
  panel.y = Axis{std::string(kSignedForce), "kN", forces.from, forces.to};
  panel.series.push_back(std::move(envelope));
  return panel;
}

/// Share of the revolutions over the force.
Panel travel_panel(const LifeResult& r) {
  constexpr std::size_t kBins = 31;
  Panel panel{"Revolutions under load"};
  Range forces{0.0, 0.0};
  for (const LoadStep& s : r.steps) forces.include(s.axial_force);
  forces.widen(0.5 / (kBins - 1));  // Bars with their middle at the smallest and the largest load.
  const double width = (forces.to - forces.from) / kBins;
  std::vector<double> share(kBins), damage(kBins);
  double all_damage = 0.0;
  for (const LoadStep& s : r.steps) {
    const auto bin = std::min(static_cast<std::size_t>((s.axial_force - forces.from) / width), kBins - 1);
    const double done = std::pow(std::abs(s.axial_force), kLifeExponent) * s.revolutions;
    share[bin] += s.revolutions / r.revolutions;
    damage[bin] += done;
    all_damage += done;
  }
  Series shares{0, {}}, damages{1, {{}}};
  double top = 0.0;
  for (const auto k : indices(share)) {
    const double x = (forces.from + width * (static_cast<double>(k) + 0.5)) * "kN"_per_si;
    const double part = all_damage > 0.0 ? damage[k] / all_damage : 0.0;
    shares.parts.push_back(bar(x, 0.0, "%"_per_si * share[k], 0.46 * width * "kN"_per_si));
    if (r.history || part > 0.0) damages.parts[0].push_back({x, "%"_per_si * part});
    top = std::max({top, share[k], part});
  }
  panel.series = {std::move(shares), std::move(damages)};
  panel.x = Axis{std::string(kSignedForce), "kN", forces.from * "kN"_per_si, forces.to * "kN"_per_si};
  panel.y = Axis{"Share", "%", 0.0, 1.08 * top * "%"_per_si};
  return panel;
}

/// Equivalent axial load of each thread.
Figure thread_loads(const LifeResult& r) {
  if (!has_lives(r)) return {};
  Figure figure{"thread_loads", "Equivalent axial load of a thread, " + words_of_text(name(r.loads))};
  figure.y = {"Axial load", "N"};
  figure.add("equivalent load, cubic mean", area_of(Colour::sky));
  if (r.cycles)
    figure.add(fmt::format("equivalent range, slope {:g}", r.life.fatigue_slope),
               points_of(Colour::vermillion, Mark::circle));
  thread_panels(r, figure, [&](Panel& panel, const auto& flank, Interface i) {
    const ThreadLives& t = flank.threads[i];
    Series bars{0};
    for (const auto k : indices(t.equivalent_load))
      bars.parts.push_back(bar(static_cast<double>(k + 1), 0.0, t.equivalent_load[k], 0.38));
    panel.series.push_back(std::move(bars));
    if (r.cycles) panel.series.push_back({1, {over_threads(t.equivalent_range, 1.0)}});
  });
  fit_y_range(figure);
  return figure;
}

/// Basic rating life of each thread on all rollers.
Figure thread_lives(const LifeResult& r) {
  if (!has_lives(r)) return {};
  Figure figure{"thread_lives", "Life of a thread on all rollers, " + words_of_text(name(r.loads))};
  figure.y = {"L10", "10⁹ revolutions"};
  figure.y.logarithmic = true;
  figure.add("thread", points_of(Colour::blue, Mark::circle));
  figure.add("all threads of this sense", line_of(Colour::vermillion, Dash::dashed));
  Range lives;
  thread_panels(r, figure, [&](Panel& panel, const auto& flank, Interface i) {
    Series points{0, {{}}};
    const std::vector<double>& life = flank.threads[i].life;
    for (const auto k : indices(life))
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
  return figure;
}

/// Course of the load, and revolutions and damage over it.
Figure load_history(const LifeResult& r) {
  Figure figure{"loads", r.history ? "Load history" : "Load spectrum"};
  figure.columns = r.history ? 2 : 1;
  figure.add(r.history ? "load, revolutions" : "revolutions", area_of(Colour::sky));
  figure.add("damage, |F|³ times revolutions",
             {Colour::vermillion, r.history ? Dash::solid : Dash::none, Mark::circle, Weight::thin});
  if (r.history) figure.panels.push_back(course_panel(*r.history));
  figure.panels.push_back(travel_panel(r));
  return figure;
}

/// Rainflow matrix: how many load cycles have which mean and range.
Figure rainflow(const LifeResult& r) {
  if (!r.cycles) return {};
  const CycleMatrix& m = r.cycles->matrix;
  if (!(m.range_to > 0.0 && m.mean_to > m.mean_from)) return {};
  Figure figure{"rainflow", fmt::format("Load cycles, rainflow: {:.0f}", count(r.cycles->cycles))};
  figure.x = {"Mean, tension >\u00a00", "kN", m.mean_from * "kN"_per_si, m.mean_to * "kN"_per_si};
  figure.y = {"Range", "kN", 0.0, m.range_to * "kN"_per_si};
  Panel panel;
  panel.map.cells = true;
  GridData& grid = panel.map.grid;
  const auto bins = static_cast<std::size_t>(m.bins);
  grid.values.assign(bins * bins, kFree);
  Range cycles;
  for (const auto k : up_to(bins)) {
    const double middle = static_cast<double>(k) + 0.5;
    grid.x.push_back((m.mean_from + middle * m.mean_width()) * "kN"_per_si);
    grid.y.push_back(middle * m.range_width() * "kN"_per_si);
    for (const auto i : up_to(bins))
      if (const double n = m.at(static_cast<int>(i), static_cast<int>(k)); n > 0.0) {
        grid.values[k * bins + i] = n;
        cycles.include(n);
      }
  }
  if (cycles.empty()) return {};
  figure.colours = ColourScale{"Cycles", "", cycles.from, std::max(cycles.to, 10.0 * cycles.from)};
  figure.colours->logarithmic = true;
  figure.panels.push_back(std::move(panel));
  return figure;
}

std::vector<OutputFile> life_files(const LifeResult& result, const CsvStyle& style) {
  std::vector<OutputFile> files = {{"life_threads.csv", life_threads_csv(result, style)}};
  const bool of_rollers = std::ranges::any_of(
      kDirections, [&](Direction d) { return result.flanks[d] && result.flanks[d]->threads.screw.rollers; });
  if (of_rollers) files.push_back({"life_rollers.csv", life_rollers_csv(result, style)});
  if (result.cycles) {
    files.push_back({"cycles.csv", cycles_csv(*result.cycles, style)});
    files.push_back({"cycle_matrix.csv", cycle_matrix_csv(result.cycles->matrix, style)});
  }
  return files;
}

constexpr const char* kLives = "a load history or spectrum under which loads converge";

/// Page section of the life. If a capacity is stated, which is that of real screws, the catalogue's life is the
/// headline.
PageSection life_section(const LifeResult& r) {
  const bool solved = r.life.share == LoadCase::Share::solved, stated = !r.lemor;
  const std::vector<std::string> lives =
      r.rated_over_l10() == 1.0
          ? std::vector<std::string>{"l10_revolutions", "l10_hours", "l10_travel_km", "l10_passes"}
          : std::vector<std::string>{"rated_revolutions", "rated_hours", "rated_travel_km", "rated_passes"};
  PageSection page{.in_document = {{"life",
                                    {"status", "share", "thread_loads", "reliability_factor", "modification_factor",
                                     "static_safety", "static_safety_limit"}}},
                   .folded = {"thread_lives"}};
  if (stated) page.in_document.push_back({"life.catalogue", lives});
  page.in_document.push_back({"life.system", lives});
  if (r.bearing) {
    page.in_document.push_back(
        {"life.bearings.fixed", {"equivalent_load_N", "l10_revolutions", "l10_hours", "static_safety"}});
    page.in_document.push_back({"life.system_with_bearings", {"l10_revolutions", "l10_hours", "l10_travel_km"}});
  }
  page.in_document.push_back(
      {"life.weakest_thread", {"direction", "interface", "part", "roller", "thread", "equivalent_load_N"}});
  if (solved) page.estimates = {"equal_shares"};
  if (solved && !stated) page.estimates.emplace_back("catalogue");
  if (solved && stated) page.note = kStatedCapacityNote;
  return page;
}

constexpr std::string_view kLifeResponses[] = {"life.system.l10_revolutions", "life.catalogue.l10_revolutions",
                                               "life.weakest_thread.equivalent_load_N",
                                               "life.capacity.dynamic_capacity_N", "life.static_safety"};

}  // namespace

namespace {

/// The mean load of a life as the one load of the case, its parts as warm as under the life.
Case under_mean_load(const Case& c, const LifeResult& r) {
  const auto largest = std::ranges::max_element(r.steps, {}, [](const LoadStep& s) { return std::abs(s.axial_force); });
  Case mean = c;
  mean.heat.reset();
  mean.load_cases = {{.name = "life.spectrum",
                      .axial_force = r.mean_load,
                      .direction = largest->axial_force > 0.0 ? Direction::tension : Direction::compression,
                      .position = c.life->position,
                      .share = c.life->share}};
  if (r.temperature) {
    const PerPart<double>& t = *r.temperature;
    mean.lubricant->temperature = std::max({t.screw, t.roller, t.nut});
  }
  return mean;
}

/// Life modification factor of the mean load at the operation's speed. Throws CaseError if no film follows.
ModifiedLife modified_life(const Case& c, const LifeResult& r) {
  constexpr double kFatigueLimit = 1.5e9;  // Peak pressure [Pa] that ISO 281 gives for steel of high quality.
  if (!c.friction || !c.operation || !c.lubricant || !c.roughness)
    throw CaseError(
        "life.contamination",
        "expected `friction`, `operation`, `lubricant` and `roughness` beside it, from which the film follows; "
        "add them, or delete it");
  const Result slip = analyze_slip(under_mean_load(c, r), kManyDesigns);
  const LoadCaseResult& load = slip.load_cases.front();
  ModifiedLife life{.film_ratio = std::numeric_limits<double>::infinity()};
  if (!load.slip || !load.slip->converged() || !load.threads)
    throw CaseError("life.contamination", "no slip under the mean load: `prs slip` says why; delete it");
  double pressure = 0.0;
  for (const Interface i : kInterfaces) {
    for (const double ratio : load.slip->of_nut_that_carries(load.load_case).threads[i].film_ratio)
      if (ratio > 0.0) life.film_ratio = std::min(life.film_ratio, ratio);  // 0 of threads that are open.
    for (const double p : (*load.threads)[i].peak_pressure) pressure = std::max(pressure, p);
  }
  if (!std::isfinite(life.film_ratio))
    throw CaseError(
        "life.contamination",
        "the film is not known: expected `lubricant.pressure_viscosity`, or a lubricant by its name; add it, or "
        "delete `contamination`");
  life.viscosity_ratio = std::pow(life.film_ratio, 1.3);
  life.load_ratio = std::pow(kFatigueLimit / pressure, 3.0);
  life.factor = modification_factor(life.viscosity_ratio, *c.life->contamination, life.load_ratio);
  return life;
}

}  // namespace

LifeResult life_of(const input::Source& source, const input::CaseInput& in) {
  std::optional<LoadHistory> history;
  if (in.values.life->history) history = input::read_force_history(*in.values.life->history, source);
  LifeResult life = analyze_warm_life(in.values, std::move(history));
  if (in.values.life->contamination && life.converged()) life.modified = modified_life(in.values, life);
  return life;
}

const Analysis<LifeResult>& life_analysis() {
  static const std::vector<Place> places = with_contacts({{"life", describe<LifeResult>}});
  static const Analysis<LifeResult> analysis{
      .command = Command::life,
      .help = "Life under a load history or spectrum, static safety",
      .file = "life.json",
      .run = [](const input::Source& source, const input::CaseInput& in) { return life_of(source, in); },
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
      .criteria = life_criteria,
      .place = {"Life", 1},
      .section = life_section,
      .responses = kLifeResponses};
  return analysis;
}

}  // namespace prs
