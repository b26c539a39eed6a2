#pragma once

#include "prs/life/rating_life.h"
#include "prs/model/load_case.h"

namespace prs {

/// Time from the first to the last sample [s]; absent without clock.
std::optional<double> duration(const LoadHistory& history);

/// Largest magnitude of the speed [rad/s]: of the samples, or between positions. Absent if the history has neither
/// speeds, nor positions with a clock.
std::optional<double> largest_speed(const LoadHistory& history, double lead);

/// Distance between the extreme positions under forces above `least` [N] of either sense [m]; absent without positions.
std::optional<double> loaded_stroke(const LoadHistory& history, double least);

/// Load of each sample and its revolutions, half of those of the steps to its neighbours (trapezoidal rule). A step
/// turns the screw by |dx|/lead if the history has positions, else by the mean magnitude of the speed at its ends over
/// its time: the history's or `operation_speed` [rad/s]. Both senses of rotation count. By travel a load drives if F dx
/// > 0, or if F omega l < 0 with the mean speed omega of the step.
std::vector<LoadStep> load_steps(const LoadHistory& history, double lead, std::optional<double> operation_speed,
                                 HistorySource::DrivenBy driven_by);

/// Time for which the screw turns with the load of each sample, half of the neighbouring intervals with motion [s]; the
/// history must have a clock.
std::vector<double> moving_times(const LoadHistory& history, double lead, std::optional<double> operation_speed);

/// Loads of a spectrum and their revolutions, in the order of the spectrum; shares stay shares, summing to 1.
/// `operation_speed` [rad/s] converts durations to revolutions.
std::vector<LoadStep> load_steps(std::span<const SpectrumLoad> spectrum, double lead,
                                 std::optional<double> operation_speed);

/// Steps of the history, if there is one, else of the spectrum.
std::vector<LoadStep> load_steps(const Life& life, const std::optional<LoadHistory>& history, double lead,
                                 std::optional<double> operation_speed);

/// A value of a history and its index.
struct HistoryPoint {
  double value = 0.0;
  std::size_t index = 0;
};

/// Turning points of a history, sample by sample: its first value, every peak and valley that exceeds the hysteresis,
/// its last extreme. Of a plateau the first sample counts. Without hysteresis these are the peaks and valleys of ASTM
/// E1049-85, 3.1; with it, swings within it are ignored and larger ones keep their full range.
class TurningPoints {
 public:
  /// `hysteresis` >= 0, in the unit of the history.
  explicit TurningPoints(double hysteresis = 0.0) : hysteresis_(hysteresis) {}

  /// Takes the next sample, which must be finite. Calls `sink(HistoryPoint)` for each turning point that is then
  /// certain.
  template <class Sink>
  void push(double value, Sink&& sink) {
    const HistoryPoint p{value, count_++};
    if (p.index == 0) {
      lowest_ = highest_ = p;
    } else if (sense_ == 0) {
      find_sense(p, sink);
    } else {
      HistoryPoint& extreme = sense_ > 0 ? highest_ : lowest_;
      if (sense_ * (value - extreme.value) > 0.0) {
        extreme = p;
      } else if (sense_ * (extreme.value - value) > hysteresis_) {
        sink(extreme);
        sense_ = -sense_;
        (sense_ > 0 ? highest_ : lowest_) = p;
      }
    }
  }

  /// Delivers the last extreme. A history within the hysteresis has no turning point.
  template <class Sink>
  void finish(Sink&& sink) {
    if (sense_ != 0) sink(sense_ > 0 ? highest_ : lowest_);
    sense_ = 0;
    count_ = 0;
  }

 private:
  /// The first range beyond the hysteresis decides where the history starts.
  template <class Sink>
  void find_sense(const HistoryPoint& p, Sink& sink) {
    if (p.value < lowest_.value) lowest_ = p;
    if (p.value > highest_.value) highest_ = p;
    if (!(highest_.value - lowest_.value > hysteresis_)) return;
    sense_ = highest_.index > lowest_.index ? 1 : -1;
    sink(sense_ > 0 ? lowest_ : highest_);
  }

  double hysteresis_;
  std::size_t count_ = 0;
  int sense_ = 0;  ///< +1 upwards, -1 downwards, 0 as long as nothing exceeded the hysteresis.
  HistoryPoint lowest_, highest_;
};

/// One cycle or half cycle of a history.
struct Cycle {
  HistoryPoint start, end;  ///< Turning points of its range, in the order of the history.
  double count = 1.0;       ///< 1 or 0.5

  double range() const { return end.value > start.value ? end.value - start.value : start.value - end.value; }
  double mean() const { return 0.5 * (start.value + end.value); }
};

/// Rainflow counting, ASTM E1049-85 (2017), 5.4.4, turning point by turning point. With X the last range and Y the one
/// before: if X >= Y, Y is a cycle and its two points are removed, or, if Y holds the starting point of the remaining
/// history, half a cycle, and only that point is removed. The ranges that remain at the end are half cycles. Memory
/// grows with the remaining points, not with the history.
class RainflowCounter {
 public:
  /// Takes the next turning point; peaks and valleys must alternate. Calls `sink(Cycle)` for completed cycles.
  template <class Sink>
  void push(const HistoryPoint& p, Sink&& sink) {
    open_.push_back(p);
    while (open_.size() >= 3) {
      const std::size_t n = open_.size();
      const Cycle x{open_[n - 2], open_[n - 1]}, y{open_[n - 3], open_[n - 2]};
      if (x.range() < y.range()) return;
      if (n == 3) {
        sink(Cycle{y.start, y.end, 0.5});
        open_.erase(open_.begin());
      } else {
        sink(y);
        open_[n - 3] = open_[n - 1];
        open_.resize(n - 2);
      }
    }
  }

  /// Delivers the remaining ranges as half cycles.
  template <class Sink>
  void finish(Sink&& sink) {
    for (std::size_t k = 1; k < open_.size(); ++k) sink(Cycle{open_[k - 1], open_[k], 0.5});
    open_.clear();
  }

 private:
  std::vector<HistoryPoint> open_;
};

/// All cycles of a history in the order in which they close. `hysteresis` as in TurningPoints.
std::vector<Cycle> rainflow(std::span<const double> history, double hysteresis = 0.0);

/// Cycles sorted into bins of range and mean.
struct CycleMatrix {
  int bins = 0;           ///< Bins along each axis.
  double range_to = 0.0;  ///< Upper end of the ranges, which start at 0.
  double mean_from = 0.0, mean_to = 0.0;
  std::vector<double> count;  ///< Range by range: count[range_bin * bins + mean_bin]

  double range_width() const { return range_to / bins; }
  double mean_width() const { return (mean_to - mean_from) / bins; }
  double at(int range_bin, int mean_bin) const { return count[static_cast<std::size_t>(range_bin * bins + mean_bin)]; }
};

/// Smallest matrix that holds all cycles, for people to look at: nothing is computed from it.
CycleMatrix cycle_matrix(std::span<const Cycle> cycles, int bins);

/// Number of cycles, where half cycles count as 0.5.
double count(std::span<const Cycle> cycles);

/// Range of constant amplitude with the damage of all cycles in the same number of cycles [unit of the history], for an
/// S-N curve of slope k without endurance limit (Miner elementary):
///
///     (sum n_i range_i^k / sum n_i)^(1/k),   0 without cycles.
double equivalent_range(std::span<const Cycle> cycles, double slope);

}  // namespace prs
