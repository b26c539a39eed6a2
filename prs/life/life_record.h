#pragma once

#include "prs/life/analyze_life.h"
#include "prs/record/record.h"

namespace prs {

/// A life in practical units, at the value of the capacity.
struct LifeInUse {
  double revolutions = 0.0;
  std::array<double, 2> revolutions_range{};  ///< Lives for the range of the capacity.
  std::optional<double> hours;                ///< Hours by the clock, if known; else in motion.
  std::optional<double> moving_hours;         ///< Hours in motion.
  double travel = 0.0;                        ///< [m]
  std::optional<double> passes;               ///< Passes through the history or the spectrum.
  double rated = 1.0;                         ///< Ratio of the rated life to this one.
};

LifeInUse in_use(const LifeResult& r, double revolutions);

Record<LifeInUse> record_of(Type<LifeInUse>);
Record<RollerLives> record_of(Type<RollerLives>);
Record<ThreadLives> record_of(Type<ThreadLives>);
Record<LifeResult> record_of(Type<LifeResult>);

}  // namespace prs
