#pragma once

#include "prs/life/analyze_life.h"
#include "prs/record/record.h"

namespace prs {

/// A life in what people count, at the value of the capacity.
struct LifeInUse {
  double revolutions = 0.0;
  std::array<double, 2> revolutions_range{};  ///< By the range of the capacity.
  std::optional<double> hours;                ///< By the clock, where it is known; else in motion.
  std::optional<double> moving_hours;         ///< In motion.
  double travel = 0.0;                        ///< [m]
  std::optional<double> passes;               ///< Passes through the history or the spectrum.
  double rated = 1.0;                         ///< The rated life over this one.
};

LifeInUse in_use(const LifeResult& r, double revolutions);

Record<LifeInUse> record_of(Type<LifeInUse>);
Record<RollerLives> record_of(Type<RollerLives>);
Record<ThreadLives> record_of(Type<ThreadLives>);
Record<LifeResult> record_of(Type<LifeResult>);

}  // namespace prs
