#include "prs/life/rainflow.h"

#include <algorithm>
#include <cmath>

namespace prs {
namespace {

int bin_of(double value, double from, double width, int bins) {
  return width > 0.0 ? std::clamp(static_cast<int>((value - from) / width), 0, bins - 1) : 0;
}

}  // namespace

std::vector<Cycle> rainflow(std::span<const double> history, double hysteresis) {
  std::vector<Cycle> cycles;
  RainflowCounter counter;
  TurningPoints turning_points(hysteresis);
  const auto keep = [&](const Cycle& c) { cycles.push_back(c); };
  const auto count_point = [&](const HistoryPoint& p) { counter.push(p, keep); };
  for (const double value : history) turning_points.push(value, count_point);
  turning_points.finish(count_point);
  counter.finish(keep);
  return cycles;
}

CycleMatrix cycle_matrix(std::span<const Cycle> cycles, int bins) {
  CycleMatrix m;
  m.bins = bins;
  m.count.assign(static_cast<std::size_t>(bins) * static_cast<std::size_t>(bins), 0.0);
  if (cycles.empty()) return m;
  m.mean_from = m.mean_to = cycles.front().mean();
  for (const Cycle& c : cycles) {
    m.range_to = std::max(m.range_to, c.range());
    m.mean_from = std::min(m.mean_from, c.mean());
    m.mean_to = std::max(m.mean_to, c.mean());
  }
  for (const Cycle& c : cycles) {
    const int range_bin = bin_of(c.range(), 0.0, m.range_width(), bins);
    const int mean_bin = bin_of(c.mean(), m.mean_from, m.mean_width(), bins);
    m.count[static_cast<std::size_t>(range_bin * bins + mean_bin)] += c.count;
  }
  return m;
}

double count(std::span<const Cycle> cycles) {
  double sum = 0.0;
  for (const Cycle& c : cycles) sum += c.count;
  return sum;
}

double equivalent_range(std::span<const Cycle> cycles, double slope) {
  double largest = 0.0;
  for (const Cycle& c : cycles) largest = std::max(largest, c.range());
  if (largest == 0.0) return 0.0;
  double damage = 0.0;
  for (const Cycle& c : cycles) damage += c.count * std::pow(c.range() / largest, slope);
  return largest * std::pow(damage / count(cycles), 1.0 / slope);
}

}  // namespace prs
