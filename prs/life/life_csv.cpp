#include "prs/life/life_csv.h"

#include <type_traits>

#include "prs/life/life_record.h"
#include "prs/record/quantity_csv.h"

namespace prs {
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
