#pragma once

#include <optional>
#include <span>
#include <vector>

#include "prs/model/life.h"
#include "prs/life/rating_life.h"

namespace prs {

/// Samples of a load over time or travel, SI. Empty where the file has no such column.
struct LoadHistory {
  std::vector<double> force;       ///< > 0 in tension [N]
  std::vector<double> time;        ///< [s], not decreasing
  std::vector<double> position;    ///< [m]
  std::vector<double> speed;       ///< [rad/s], of either sign
  std::optional<double> interval;  ///< Between two samples [s], where `time` is empty.
};

/// From the first to the last sample [s]; absent without clock.
std::optional<double> duration(const LoadHistory& history);

/// The load of each sample and its revolutions, half of those of the steps to its neighbours
/// (trapezoidal rule). A step turns the screw by |dx|/lead where the history has positions, else by
/// the mean magnitude of the speed at its ends over its time: the history's or `operation_speed`
/// [rad/s]. Both senses of rotation count: they stress the contacts alike.
std::vector<LoadStep> load_steps(const LoadHistory& history, double lead,
                                 std::optional<double> operation_speed);

/// The loads of a spectrum and their revolutions, in the order of the spectrum; shares stay shares,
/// summing to 1. `operation_speed` [rad/s] turns durations into revolutions.
std::vector<LoadStep> load_steps(std::span<const SpectrumLoad> spectrum, double lead,
                                 std::optional<double> operation_speed);

}  // namespace prs
