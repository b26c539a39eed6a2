#include "prs/measures/static_capacity.h"

#include <cmath>

namespace prs {
namespace {

/// 1.3e-7 mm^4/N^2 in m^4/N^2.
constexpr double kPalmgren = 1.3e-19;

}  // namespace

double permanent_deformation(double load, double diameter, double kappa_1, double kappa_2) {
  return kPalmgren * load * load / diameter * kappa_1 * kappa_2;
}

double load_at_permanent_deformation(double diameter, double kappa_1, double kappa_2,
                                     double share) {
  return diameter * std::sqrt(share / (kPalmgren * kappa_1 * kappa_2));
}

std::optional<double> flank_element_diameter(const contact::Thread& roller) {
  if (!(roller.profile_curvature > 0.0)) return std::nullopt;
  return 2.0 / roller.profile_curvature;
}

}  // namespace prs
