#pragma once

#include "prs/model/case.h"
#include "prs/model/problems.h"

namespace prs {

/// Least life, as time or as travel: one of the two is given.
struct LeastLife {
  std::optional<double> duration = {};  ///< [s]
  std::optional<double> travel = {};    ///< [m]
};

/// Limits that a case is held against, see prs/model/criterion.h. SI units; none has a default.
struct Limits {
  std::optional<LeastLife> life;
  std::optional<double> static_safety;
  std::optional<double> peak_pressure;  ///< Greatest [Pa].
  std::optional<double> buckling_safety;
  std::optional<double> critical_speed_share;  ///< Greatest speed over the critical one.
  std::optional<double> speed_times_diameter;  ///< Greatest n d [m/s], n in revolutions.
  std::optional<double> nut_diameter;          ///< Greatest, between flanges [m].
  std::optional<double> nut_length;            ///< Greatest [m].
  std::optional<double> weight;                ///< Greatest, nut, rollers and screw [kg].
  std::optional<double> stiffness;             ///< Least [N/m].
  std::optional<double> efficiency;            ///< Least.
  std::optional<double> temperature;           ///< Greatest [K].
};

/// What the limits of a case contradict.
std::vector<Problem> check_limits(const Limits& limits, const Conditions& c);

}  // namespace prs
