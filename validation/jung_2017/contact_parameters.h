#pragma once

#include <array>

#include "prs/validation/reference.h"
#include "prs/validation/table.h"

namespace prs::jung_2017 {

/// Dimensionless contact parameters of Hertz and Harris, table A1.
struct ContactParameters {
  double semi_major = 1.0;  ///< a* = (2 k^2 E/pi)^(1/3), k = a/b
  double semi_minor = 1.0;  ///< b* = a*/k
  double approach = 1.0;    ///< delta* = 2 K/(pi a*)
};

/// The parameters for F(rho) = (kappa_2 - kappa_1)/(kappa_1 + kappa_2), 0 <= F < 1, of the relative
/// principal curvatures, (3.39) and (3.40), by exact elliptic integrals. From (1 - F)/(1 + F),
/// which loses nothing near 1.
ContactParameters contact_parameters(double curvature_difference);

/// A line of table A1 but the first and the last, which are limits.
struct PrintedParameters {
  PrintedNumber curvature_difference, semi_major, semi_minor, approach;
};
const std::array<PrintedParameters, 21>& table_a1();

/// Printed numbers over exact ones, less 1, in ppm, and the part of it that the rounding of F(rho)
/// and of the number itself explains.
ValidationTable deviations_of_table_a1();

/// How far a printed number lies beyond what the rounding of F(rho) and its own allow, relative to
/// it; 0 for a number that may be right.
double unexplained(const PrintedNumber& printed, const PrintedNumber& curvature_difference,
                   double ContactParameters::*parameter);

}  // namespace prs::jung_2017
