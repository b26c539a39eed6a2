#pragma once

#include <array>
#include <vector>

#include "prs/validation/table.h"
#include "validation/jung_2017/measures.h"

namespace prs::jung_2017 {

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
