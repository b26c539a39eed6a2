#pragma once

#include "prs/model/case.h"
#include "prs/model/problems.h"

namespace prs {

/// Temperature Ac1 at which bearing steel turns into austenite [K]: beyond it no part has its stated properties.
inline constexpr double kHottest = 1000.0;

/// Required life, as time or as travel: one of the two is given.
struct LeastLife {
  std::optional<double> duration = {};  ///< [s]
  std::optional<double> travel = {};    ///< [m]
};

/// Limits that a case is held against, see prs/model/criterion.h. SI units; none has a default.
struct Limits {
  std::optional<LeastLife> life;
  std::optional<double> static_safety;
  std::optional<double> peak_pressure;  ///< Upper limit [Pa].
  std::optional<double> buckling_safety;
  std::optional<double> critical_speed_share;  ///< Upper limit of speed over critical speed.
  std::optional<double> speed_times_diameter;  ///< Upper limit of n d [m/s], n in revolutions.
  std::optional<double> nut_diameter;          ///< Upper limit, flanges not counted [m].
  std::optional<double> nut_length;            ///< Upper limit [m].
  std::optional<double> weight;                ///< Upper limit for nut, rollers and screw [kg].
  std::optional<double> stiffness;             ///< Lower limit [N/m].
  std::optional<double> efficiency;            ///< Lower limit.
  std::optional<double> temperature;           ///< Upper limit [K].
};

/// Problem of a mission of many steps, whose time grows with their number; empty if there is none.
std::string wrong_length(const std::optional<int>& cycles, std::size_t steps);

/// Problem of the start of a mission that has a limit of temperature; empty if there is none.
std::string wrong_start(const std::optional<PerPart<double>>& start, const Limits& limits);

/// Contradictions between the limits and the rest of a case.
std::vector<Problem> check_limits(const Limits& limits, const Conditions& c);

}  // namespace prs
