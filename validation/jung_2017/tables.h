#pragma once

#include "prs/validation/validate.h"
#include "validation/jung_2017/measures.h"

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

/// A measure as a polynomial of the volume x, in the 1e-3 m^3 that the tables call m^3.
struct VolumeFit {
  const char* equation;
  const char* measure;  ///< With its unit.
  bool of_case_2 = false;
  double (*value)(const Measures&);    ///< Value of the measure, in that unit.
  std::array<double, 6> coefficients;  ///< Factors of x^5, x^4 .. 1, as printed.

  double at(double x) const;
};

/// (7.8) to (7.13). Below (7.11) to (7.13) y is said to be the load capacity; figures 7.4 to 7.6
/// and the numbers have stiffness, load capacity and weight.
const std::vector<VolumeFit>& volume_fits();

/// Least-squares polynomial through the ten rows of its case by the recipe `as_printed`, case 1
/// with unrounded values. Case 2 takes volumes, capacities and weights to three decimals as the
/// table prints them, since only these give the printed coefficients.
std::array<double, 6> refitted(const VolumeFit& fit);

/// The printed polynomials at the volumes of their rows, unrounded and to three decimals, less the
/// recipe's values; and the printed coefficients next to `refitted`.
std::vector<ValidationTable> fit_tables();

}  // namespace prs::jung_2017
