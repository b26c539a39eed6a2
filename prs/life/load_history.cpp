#include "prs/life/load_history.h"

#include <algorithm>

namespace prs {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

double time_before(const LoadHistory& h, std::size_t k) {
  return h.time.empty() ? h.interval.value_or(0.0) : h.time[k] - h.time[k - 1];
}

/// Revolutions from sample k - 1 to k.
double turned(const LoadHistory& h, double lead, std::optional<double> operation_speed, std::size_t k) {
  const auto speed = [&](std::size_t at) {
    if (h.speed.empty()) return std::abs(operation_speed.value_or(0.0));
    return std::abs(h.speed[at]) * (h.speed_along_axis ? kTurn / std::abs(lead) : 1.0);
  };
  if (!h.position.empty()) return std::abs(h.position[k] - h.position[k - 1]) / std::abs(lead);
  return 0.5 * (speed(k - 1) + speed(k)) * time_before(h, k) / kTurn;
}

int bin_of(double value, double from, double width, int bins) {
  return width > 0.0 ? std::clamp(static_cast<int>((value - from) / width), 0, bins - 1) : 0;
}

}  // namespace

std::optional<double> duration(const LoadHistory& h) {
  if (!h.time.empty()) return h.time.back() - h.time.front();
  if (!h.interval || h.force.empty()) return std::nullopt;
  return *h.interval * static_cast<double>(h.force.size() - 1);
}

std::optional<double> largest_speed(const LoadHistory& h, double lead) {
  const double per_metre = kTurn / std::abs(lead);
  double largest = 0.0;
  for (const double speed : h.speed)
    largest = std::max(largest, std::abs(speed) * (h.speed_along_axis ? per_metre : 1.0));
  if (!h.speed.empty()) return largest;
  if (h.position.empty() || !duration(h)) return std::nullopt;
  for (std::size_t k = 1; k < h.position.size(); ++k)
    if (const double time = time_before(h, k); time > 0.0)
      largest = std::max(largest, std::abs(h.position[k] - h.position[k - 1]) / time * per_metre);
  return largest;
}

std::optional<double> loaded_stroke(const LoadHistory& h, double least) {
  std::optional<std::pair<double, double>> ends;
  for (std::size_t k = 0; k < h.position.size(); ++k) {
    if (!(std::abs(h.force[k]) > least)) continue;
    if (!ends) ends.emplace(h.position[k], h.position[k]);
    ends = {std::min(ends->first, h.position[k]), std::max(ends->second, h.position[k])};
  }
  return ends ? std::optional(ends->second - ends->first) : std::nullopt;
}

std::vector<LoadStep> load_steps(const LoadHistory& h, double lead, std::optional<double> operation_speed,
                                 HistorySource::DrivenBy driven_by) {
  // > 0 if tension drives.
  const auto way = [&](std::size_t k) {
    if (!h.position.empty()) return h.position[k] - h.position[k - 1];
    return h.speed.empty() ? 0.0 : -(h.speed[k - 1] + h.speed[k]) * lead;
  };
  const auto load_drives = [&](std::size_t k, double force) {
    if (driven_by == HistorySource::DrivenBy::travel) return force * way(k) > 0.0;
    return driven_by == HistorySource::DrivenBy::load;
  };
  std::vector<LoadStep> steps(h.force.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    steps[k].axial_force = h.force[k];
    if (k == 0) continue;
    const double half = 0.5 * turned(h, lead, operation_speed, k);
    for (LoadStep* step : {&steps[k - 1], &steps[k]}) {
      step->revolutions += half;
      if (load_drives(k, step->axial_force)) step->driven_by_load += half;
    }
  }
  return steps;
}

std::vector<double> moving_times(const LoadHistory& h, double lead, std::optional<double> operation_speed) {
  std::vector<double> times(h.force.size(), 0.0);
  for (std::size_t k = 1; k < times.size(); ++k) {
    if (!(turned(h, lead, operation_speed, k) > 0.0)) continue;
    times[k - 1] += 0.5 * time_before(h, k);
    times[k] += 0.5 * time_before(h, k);
  }
  return times;
}

std::vector<LoadStep> load_steps(const Life& life, const std::optional<LoadHistory>& history, double lead,
                                 std::optional<double> operation_speed) {
  if (!history) return load_steps(life.spectrum, lead, operation_speed);
  using enum HistorySource::DrivenBy;
  const HistorySource& source = *life.history;
  return load_steps(*history, lead, operation_speed,
                    source.driven_by.value_or(source.position || source.speed ? travel : screw));
}

std::vector<LoadStep> load_steps(std::span<const SpectrumLoad> spectrum, double lead,
                                 std::optional<double> operation_speed) {
  double shares = 0.0;
  for (const SpectrumLoad& l : spectrum) shares += l.share.value_or(0.0);
  std::vector<LoadStep> steps;
  for (const SpectrumLoad& l : spectrum) {
    LoadStep step;
    step.axial_force = l.direction == Direction::tension ? l.force : -l.force;
    if (l.revolutions) step.revolutions = *l.revolutions;
    if (l.distance) step.revolutions = *l.distance / std::abs(lead);
    if (l.duration) step.revolutions = *l.duration * std::abs(operation_speed.value_or(0.0)) / kTurn;
    if (l.share) step.revolutions = *l.share / shares;
    if (l.driven_by == DrivenBy::load) step.driven_by_load = step.revolutions;
    steps.push_back(step);
  }
  return steps;
}

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
