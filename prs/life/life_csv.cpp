#include "prs/life/life_csv.h"
#include "prs/life/life_record.h"
#include "prs/record/quantity_csv.h"

namespace prs {

std::string life_threads_csv(const LifeResult& r, const CsvStyle& style) {
  CsvWriter csv(style);
  for (const char* key : {"direction", "interface", "thread"}) csv.text(key);
  series_header<ThreadLives>(csv);
  csv.end_row();
  for (const Direction d : kDirections) {
    if (!r.flanks[d]) continue;
    for (const Interface i : kInterfaces) {
      const ThreadLives& t = r.flanks[d]->threads[i];
      for (std::size_t k = 0; k < t.life.size(); ++k) {
        csv.text(name(d));
        csv.text(name(i));
        csv.integer(k + 1);
        series_fields(csv, t, k);
        csv.end_row();
      }
    }
  }
  return csv.take();
}

std::string life_rollers_csv(const LifeResult& r, const CsvStyle& style) {
  CsvWriter csv(style);
  for (const char* key : {"direction", "interface", "roller", "thread"}) csv.text(key);
  series_header<RollerLives>(csv);
  csv.end_row();
  for (const Direction d : kDirections) {
    if (!r.flanks[d]) continue;
    for (const Interface i : kInterfaces) {
      const RollerLives& t = *r.flanks[d]->threads[i].rollers;
      const auto threads = static_cast<std::size_t>(t.threads_per_roller);
      for (std::size_t k = 0; k < t.life.size(); ++k) {
        csv.text(name(d));
        csv.text(name(i));
        csv.integer(k / threads + 1);
        csv.integer(k % threads + 1);
        series_fields(csv, t, k);
        csv.end_row();
      }
    }
  }
  return csv.take();
}

std::string cycles_csv(const LoadCycles& cycles, const CsvStyle& style) {
  CsvWriter csv(style);
  for (const char* key : {"range_N", "mean_N", "count", "start_sample", "end_sample"})
    csv.text(key);
  csv.end_row();
  for (const Cycle& c : cycles.cycles) {
    csv.number(c.range());
    csv.number(c.mean());
    csv.number(c.count);
    csv.integer(c.start.index + 1);
    csv.integer(c.end.index + 1);
    csv.end_row();
  }
  return csv.take();
}

std::string cycle_matrix_csv(const CycleMatrix& m, const CsvStyle& style) {
  CsvWriter csv(style);
  for (const char* key : {"range_from_N", "range_to_N", "mean_from_N", "mean_to_N", "count"})
    csv.text(key);
  csv.end_row();
  for (int i = 0; i < m.bins; ++i)
    for (int k = 0; k < m.bins; ++k) {
      if (m.at(i, k) == 0.0) continue;
      csv.number(i * m.range_width());
      csv.number((i + 1) * m.range_width());
      csv.number(m.mean_from + k * m.mean_width());
      csv.number(m.mean_from + (k + 1) * m.mean_width());
      csv.number(m.at(i, k));
      csv.end_row();
    }
  return csv.take();
}

}  // namespace prs
