#pragma once

#include <array>

namespace prs::jung_2017 {

/// A line of table 8.1: the four parameters that share one place on the y-axis of the envelopes.
struct ScaleLine {
  double scale = 0.0;  ///< D_n over the root mean square of its ten values.
  int rollers = 0;
  double roller = 0.0;     ///< d_r [m]
  double screw = 0.0;      ///< d_s [m]
  double nut_outer = 0.0;  ///< D_n [m]
};

/// Table 8.1: N_r = 6 .. 15, d_r from 7.8 mm by 1.3 mm, d_s from 18 mm by 3 mm, D_n from 40 mm by
/// 6.67 mm. The printed scale is that of D_n, whose step is rounded; the other three have 0.55118
/// to 1.37795 in place of 0.55105 to 1.37804.
std::array<ScaleLine, 10> scale_chart();

}  // namespace prs::jung_2017
