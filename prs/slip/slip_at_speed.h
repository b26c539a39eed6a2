#pragma once

#include "prs/slip/slip_model.h"

namespace prs {

/// Efficiency of the same load at the same speed where the load drives; absent where the screw
/// locks itself, or the case lacks what `slip` needs or a temperature of its oil.
std::optional<double> back_driving_efficiency(const Conditions& c, const Contacts& contacts,
                                              const LoadCaseResult& loaded);

/// Speed, power and efficiency of a load case from a thousandth to ten times its speed. Loads at rest and the
/// oil stay as they are, loads of a running screw are found anew at each speed. Speeds without an
/// equilibrium are left out.
struct StribeckCurve {
  std::vector<double> speed;                      ///< Magnitude [rad/s], ascending.
  std::vector<double> power;                      ///< Lost in the whole mechanism [W]
  std::vector<std::optional<double>> efficiency;  ///< Absent where self-locking.
  // At the thread of the largest load:
  PerInterface<std::vector<double>> friction;    ///< mu_a, mean over the points.
  PerInterface<std::vector<double>> film_ratio;  ///< Lambda; empty where it is not known.
};
StribeckCurve stribeck_curve(const Conditions& c, const Result& result, std::size_t load_case);

}  // namespace prs
