#pragma once

#include "prs/life/rating_life.h"
#include "prs/model/life.h"
#include "prs/model/load_history.h"

namespace prs {

/// From the first to the last sample [s]; absent without clock.
std::optional<double> duration(const LoadHistory& history);

/// The load of each sample and its revolutions, half of those of the steps to its neighbours
/// (trapezoidal rule). A step turns the screw by |dx|/lead where the history has positions, else by
/// the mean magnitude of the speed at its ends over its time: the history's or `operation_speed`
/// [rad/s]. Both senses of rotation count. By travel a load drives where F dx > 0, or where
/// F omega l < 0 with the mean speed omega of the step.
std::vector<LoadStep> load_steps(const LoadHistory& history, double lead,
                                 std::optional<double> operation_speed,
                                 HistorySource::DrivenBy driven_by);

/// Time for which the screw turns with the load of each sample, half of the intervals to its
/// neighbours in which it does [s]; the history must have a clock.
std::vector<double> moving_times(const LoadHistory& history, double lead,
                                 std::optional<double> operation_speed);

/// The loads of a spectrum and their revolutions, in the order of the spectrum; shares stay shares,
/// summing to 1. `operation_speed` [rad/s] turns durations into revolutions.
std::vector<LoadStep> load_steps(std::span<const SpectrumLoad> spectrum, double lead,
                                 std::optional<double> operation_speed);

/// Those of the history, where there is one, else of the spectrum.
std::vector<LoadStep> load_steps(const Life& life, const std::optional<LoadHistory>& history,
                                 double lead, std::optional<double> operation_speed);

}  // namespace prs
