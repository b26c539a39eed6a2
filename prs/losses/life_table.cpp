#include "prs/losses/life_analysis.h"

#include "prs/life/life_record.h"
#include "prs/loads/analyze.h"
#include "prs/loads/case_table.h"
#include "prs/loads/model_summary_record.h"
#include "prs/loads/warnings.h"
#include "prs/record/quantity_csv.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {
namespace {

std::string life_line(const std::string& what, const std::string& value) {
  return hanging("  " + what, 41, value);
}

/// Four digits with the unit of tables.
std::string in_unit(std::optional<double> si, std::string_view unit) {
  if (!si) return std::string(kAbsent);
  return fmt::format("{} {}", significant(shown(*si, unit)), table_unit(unit).text);
}

std::string kilonewtons(std::optional<double> force) { return in_unit(force, "kN"); }

std::string cell(std::optional<double> value, double factor = 1.0) {
  return significant(value ? std::optional(*value * factor) : std::nullopt);
}

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

std::string reliability(const LifeResult& r) {
  return fmt::format("{:.4g} %", 100.0 * r.life.reliability);
}

/// `thread 3.1 at the screw, tension` where it is one of roller 3.
std::string weakest_thread(const WeakestThread& w) {
  const std::string number =
      w.roller ? fmt::format("{}.{}", *w.roller + 1, w.thread + 1) : fmt::to_string(w.thread + 1);
  return fmt::format("thread {} {} the {}, {}", number, w.part && !w.roller ? "of" : "at",
                     name(w.interface), name(w.direction));
}

/// The headline is the life with the real thread loads or, with a maker's capacity, that of the
/// catalogue's formula: such a capacity comes from real screws, and uneven sharing is in it.
std::string lives(const LifeResult& r, bool all) {
  const bool solved = r.life.share == LoadCase::Share::solved;
  const bool given = !r.lemor;
  const double headline = given ? r.catalogue_life : r.system_life;
  std::vector<std::string> heads{"million rev.", "hours", with_table_unit("km")};
  if (r.revolutions_known) heads.emplace_back(r.history ? "histories" : "spectra run");
  std::string text = kLifeRows("  Life L10", heads);
  const std::string_view system =
      solved ? "mechanism, real thread loads" : "mechanism, equal thread loads";
  text += life_row(r, given ? "stated C_a, (C_a/F_m)^3" : std::string(system), headline);
  if (is_rated(r))
    text += life_row(r, fmt::format("  rated, {} reach it", reliability(r)),
                     r.rated_over_l10() * headline);
  if (given) text += life_row(r, fmt::format("  {}", system), r.system_life);
  for (const Direction d : kDirections)
    if (r.flanks[d])
      text += life_row(r, fmt::format("  {} flanks alone", name(d)), r.flanks[d]->life);
  if (all && solved) text += life_row(r, "estimate: equal thread loads", r.equal_shares_life);
  if (all && !given) text += life_row(r, "estimate: (C_a/F_m)^3", r.catalogue_life);
  if (given && solved) text += wrapped(kStatedCapacityNote, "  ", kTableWidth);
  if (r.weakest) text += life_row(r, weakest_thread(*r.weakest), r.weakest->life);
  return text;
}

std::string by_direction(const LifeResult& r, std::optional<double> FlankLife::*force) {
  std::string text;
  for (const Direction d : kDirections)
    if (r.flanks[d])
      text += fmt::format("{}{} in {}", text.empty() ? "" : ", ",
                          kilonewtons((*r.flanks[d]).*force), name(d));
  return text;
}

std::string capacities(const LifeResult& r, bool all) {
  std::string text;
  const Interval& range = r.dynamic_capacity_range;
  text += life_line(
      "dynamic capacity C_a",
      r.lemor ? fmt::format("{} ({} to {} by which diameters f_c takes)",
                            kilonewtons(r.dynamic_capacity), significant(shown(range.least, "kN")),
                            kilonewtons(range.greatest))
              : fmt::format("{} (given)", kilonewtons(r.dynamic_capacity)));
  if (r.lemor && r.contacts.mechanism.type == Mechanism::Type::standard)
    text += life_line(
        "  by a maker's 23 standard screws",
        fmt::format("{} to {} (C_a is {:g} to {:g} times theirs)",
                    significant(shown(r.dynamic_capacity / kCapacityOverMakers.greatest, "kN")),
                    kilonewtons(r.dynamic_capacity / kCapacityOverMakers.least),
                    kCapacityOverMakers.least, kCapacityOverMakers.greatest));
  if (r.lemor && std::isfinite(r.system_life)) {
    const auto [least, greatest] = in_use(r, r.system_life).revolutions_range;
    text += life_line(
        "life of the mechanism in that range",
        fmt::format("{} to {} million revolutions", cell(least, 1e-6), cell(greatest, 1e-6)));
  }
  if (is_rated(r))
    text += life_line(
        "rated life over L10",
        fmt::format("{:.4g} (a1 {:.4g} at {}, modification factor {:.4g})", r.rated_over_l10(),
                    r.reliability_factor, reliability(r), r.life.modification_factor));
  text += life_line("mean load F_m", kilonewtons(r.mean_load));
  text += life_line("largest force", kilonewtons(r.largest_force));
  if (r.life.static_capacity)
    text += life_line("static capacity C_0", kilonewtons(r.life.static_capacity) + " (given)");
  if (r.equal_shares_static_capacity) {
    text += life_line("force that gives " + in_unit(kStaticPressureLimit, "GPa"),
                      by_direction(r, &FlankLife::static_capacity));
    if (all)
      text += life_line("  with equal thread loads", kilonewtons(r.equal_shares_static_capacity));
    text += life_line("force with ellipses at a flank's edge",
                      by_direction(r, &FlankLife::flank_edge_load));
    if (all)
      text += life_line("  with equal thread loads", kilonewtons(r.equal_shares_flank_edge_load));
  }
  text +=
      life_line("static safety",
                r.static_safety() ? fmt::format("{:.2f} (limited by: {})", *r.static_safety(),
                                                in_table_units(describe(*r.static_safety_limit())))
                                  : std::string(kAbsent));
  return text;
}

std::string loads(const LifeResult& r) {
  std::string text;
  if (r.revolutions_known)
    text +=
        life_line("revolutions, travel",
                  fmt::format("{}, {}", cell(r.revolutions),
                              in_unit(r.revolutions * std::abs(r.contacts.mechanism.lead), "m")));
  if (r.duration)
    text += life_line("duration", fmt::format("{} h", cell(*r.duration, 1.0 / 3600.0)));
  for (const Direction d : kDirections)
    if (const auto& f = r.flanks[d])
      text += life_line(
          fmt::format("{}", name(d)),
          fmt::format("{:.1f} % of the revolutions, up to {} and {}",
                      100.0 * f->revolutions / r.revolutions, kilonewtons(f->largest_force),
                      in_unit(std::max(f->peak_pressure.screw, f->peak_pressure.nut), "GPa")));
  if (r.cycles)
    text += life_line("load cycles (rainflow)",
                      fmt::format("{:.1f}, equivalent range {} at slope {:g}, up to {}",
                                  count(r.cycles->cycles), kilonewtons(r.cycles->equivalent_range),
                                  r.life.fatigue_slope, kilonewtons(r.cycles->matrix.range_to)));
  return text;
}

std::string table_with(const LifeResult& r, bool all) {
  std::string text;
  if (r.converged())
    text += lives(r, all) + '\n' + capacities(r, all) + '\n' +
            (r.history ? fmt::format("History of {} samples\n", r.steps.size())
                       : fmt::format("Spectrum of {} load{}\n", r.steps.size(),
                                     r.steps.size() == 1 ? "" : "s")) +
            loads(r);
  else
    text += fmt::format("NOT CONVERGED: {}\n", *r.failure);
  return text + warning_section(r.warnings);
}

}  // namespace

std::string life_table(const LifeResult& r) { return table_with(r, false); }
std::string full_life_table(const LifeResult& r) { return table_with(r, true); }

namespace {

/// One row per thread of one roller or, where `Lives` has them, of all rollers.
template <class Lives>
std::string lives_csv(const LifeResult& r, const CsvStyle& style,
                      const Lives& (*lives_of)(const ThreadLives&)) {
  constexpr bool all_rollers = std::is_same_v<Lives, RollerLives>;
  CsvWriter csv(style);
  csv.fields("direction", "interface");
  if (all_rollers) csv.text("roller");
  csv.text("thread");
  series_header<Lives>(csv);
  csv.end_row();
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces) {
      if (!r.flanks[d]) continue;
      const Lives& lives = lives_of(r.flanks[d]->threads[i]);
      std::size_t threads = lives.life.size();
      if constexpr (all_rollers) threads = static_cast<std::size_t>(lives.threads_per_roller);
      for (std::size_t k = 0; k < lives.life.size(); ++k) {
        csv.fields(name(d), name(i));
        if (all_rollers) csv.integer(k / threads + 1);
        csv.integer(k % threads + 1);
        series_fields(csv, lives, k);
        csv.end_row();
      }
    }
  return csv.take();
}

}  // namespace

std::string life_threads_csv(const LifeResult& r, const CsvStyle& style) {
  return lives_csv<ThreadLives>(r, style,
                                [](const ThreadLives& t) -> const ThreadLives& { return t; });
}

std::string life_rollers_csv(const LifeResult& r, const CsvStyle& style) {
  return lives_csv<RollerLives>(
      r, style, [](const ThreadLives& t) -> const RollerLives& { return *t.rollers; });
}

std::string cycles_csv(const LoadCycles& cycles, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.row("range_N", "mean_N", "count", "start_sample", "end_sample");
  for (const Cycle& c : cycles.cycles)
    csv.row(c.range(), c.mean(), c.count, c.start.index + 1, c.end.index + 1);
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

}  // namespace prs
