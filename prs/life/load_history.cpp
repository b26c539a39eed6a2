#include "prs/life/load_history.h"

namespace prs {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

double time_before(const LoadHistory& h, std::size_t k) {
  return h.time.empty() ? h.interval.value_or(0.0) : h.time[k] - h.time[k - 1];
}

/// Revolutions from sample k - 1 to k.
double turned(const LoadHistory& h, double lead, std::optional<double> operation_speed,
              std::size_t k) {
  const auto speed = [&](std::size_t at) {
    if (h.speed.empty()) return std::abs(operation_speed.value_or(0.0));
    return std::abs(h.speed[at]) * (h.speed_along_axis ? kTurn / std::abs(lead) : 1.0);
  };
  if (!h.position.empty()) return std::abs(h.position[k] - h.position[k - 1]) / std::abs(lead);
  return 0.5 * (speed(k - 1) + speed(k)) * time_before(h, k) / kTurn;
}

}  // namespace

std::optional<double> duration(const LoadHistory& h) {
  if (!h.time.empty()) return h.time.back() - h.time.front();
  if (!h.interval || h.force.empty()) return std::nullopt;
  return *h.interval * static_cast<double>(h.force.size() - 1);
}

std::vector<LoadStep> load_steps(const LoadHistory& h, double lead,
                                 std::optional<double> operation_speed,
                                 HistorySource::DrivenBy driven_by) {
  // > 0 where tension drives.
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

std::vector<double> moving_times(const LoadHistory& h, double lead,
                                 std::optional<double> operation_speed) {
  std::vector<double> times(h.force.size(), 0.0);
  for (std::size_t k = 1; k < times.size(); ++k) {
    if (!(turned(h, lead, operation_speed, k) > 0.0)) continue;
    times[k - 1] += 0.5 * time_before(h, k);
    times[k] += 0.5 * time_before(h, k);
  }
  return times;
}

std::vector<LoadStep> load_steps(const Life& life, const std::optional<LoadHistory>& history,
                                 double lead, std::optional<double> operation_speed) {
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
    if (l.duration)
      step.revolutions = *l.duration * std::abs(operation_speed.value_or(0.0)) / kTurn;
    if (l.share) step.revolutions = *l.share / shares;
    if (l.driven_by == DrivenBy::load) step.driven_by_load = step.revolutions;
    steps.push_back(step);
  }
  return steps;
}

}  // namespace prs
