#pragma once

#include <optional>
#include <vector>

namespace prs {

/// Samples of a load over time or travel, SI. Empty where the file has no such column.
struct LoadHistory {
  std::vector<double> force;       ///< > 0 in tension [N]
  std::vector<double> time;        ///< [s], not decreasing
  std::vector<double> position;    ///< [m]
  std::vector<double> speed;       ///< [rad/s], of either sign
  bool speed_along_axis = false;   ///< Speeds are those of the travel [m/s].
  std::optional<double> interval;  ///< Between two samples [s], where `time` is empty.
};

}  // namespace prs
