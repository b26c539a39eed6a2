#include "validation/jung_2017/volume_fits.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "prs/model/units.h"

namespace prs::jung_2017 {
namespace {

constexpr double kLitre = 1e3;  // Per m^3.

double to_three_decimals(double x) { return std::round(1e3 * x) / 1e3; }

std::array<Diameters, 10> rows_of(const VolumeFit& fit) {
  return fit.of_case_2 ? case_2() : case_1();
}

/// Largest differences between a printed polynomial and what it was fitted to.
ValidationTable::Row deviation(const VolumeFit& fit) {
  double largest = 0.0, largest_rounded = 0.0;
  for (const Diameters& d : rows_of(fit)) {
    const Measures m = as_printed(d);
    const double x = kLitre * m.volume, y = fit.value(m);
    largest = std::max(largest, std::abs(fit.at(x) - y));
    largest_rounded = std::max(largest_rounded, std::abs(fit.at(to_three_decimals(x)) - y));
  }
  return {fmt::format("{} {}", fit.equation, fit.measure), {largest, largest_rounded}};
}

}  // namespace

double VolumeFit::at(double x) const {
  double y = 0.0;
  for (const double c : coefficients) y = y * x + c;
  return y;
}

const std::vector<VolumeFit>& volume_fits() {
  constexpr const char *kStiffness = "stiffness, N/mm", *kCapacity = "load capacity, kN",
                       *kWeight = "weight, kg";
  const auto stiffness = [](const Measures& m) { return m.stiffness / per_si::millimetre; };
  const auto capacity = [](const Measures& m) { return m.load_capacity * per_si::kilonewton; };
  const auto weight = [](const Measures& m) { return m.weight; };
  static const std::vector<VolumeFit> fits = {
      {"(7.8)",
       kStiffness,
       false,
       stiffness,
       {-1669.084733, 13080.12347, -42831.63605, 75804.59582, -77647.75201, 40816.78204}},
      {"(7.9)",
       kCapacity,
       false,
       capacity,
       {8.803919974, -67.96418356, 220.2269572, -397.9952443, 530.2832892, -84.9710269}},
      {"(7.10)",
       kWeight,
       false,
       weight,
       {2.901147059e-2, -2.262064181e-1, 7.453980657e-1, -1.394046858, 2.747646594,
        -4.936226644e-2}},
      {"(7.11)",
       kStiffness,
       true,
       stiffness,
       {-37.50696641, 748.1918886, -4059.119313, 10326.7345, -14885.44204, 17577.19917}},
      {"(7.12)",
       kCapacity,
       true,
       capacity,
       {-5.762218356, 34.06775475, -71.12572861, 43.03709984, 103.9963808, 82.20940208}},
      {"(7.13)",
       kWeight,
       true,
       weight,
       {-2.310565803e-1, 1.470807143, -3.669795483, 4.476872057, -7.035043836e-1, 6.196821555e-1}}};
  return fits;
}

std::array<double, 6> refitted(const VolumeFit& fit) {
  Eigen::Matrix<double, 10, 6> powers;
  Eigen::Vector<double, 10> values;
  Eigen::Index row = 0;
  for (const Diameters& d : rows_of(fit)) {
    const Measures m = as_printed(d);
    double x = kLitre * m.volume, y = fit.value(m);
    if (fit.of_case_2) {
      x = to_three_decimals(x);
      if (y < 1e3) y = to_three_decimals(y);  // Stiffnesses have fewer decimals.
    }
    for (Eigen::Index power = 0; power < 6; ++power)
      powers(row, power) = std::pow(x, static_cast<double>(5 - power));
    values(row++) = y;
  }
  const Eigen::Vector<double, 6> solution = powers.colPivHouseholderQr().solve(values);
  std::array<double, 6> coefficients;
  std::ranges::copy(solution, coefficients.begin());
  return coefficients;
}

std::vector<ValidationTable> fit_tables() {
  ValidationTable deviations{
      "(7.8) to (7.13): largest difference between the printed polynomial and the recipe's values, "
      "with volumes unrounded and as printed",
      {"fit", "unrounded", "as printed"},
      {}};
  ValidationTable coefficients{
      "(7.8) to (7.13): printed coefficients of x^5 to 1 over those of a new fit to the recipe's "
      "values, less 1, in ppm",
      {"fit", "x^5", "x^4", "x^3", "x^2", "x", "1"},
      {}};
  for (const VolumeFit& fit : volume_fits()) {
    deviations.rows.push_back(deviation(fit));
    const std::array<double, 6> again = refitted(fit);
    ValidationTable::Row row{fit.equation, {}};
    for (std::size_t k = 0; k < again.size(); ++k)
      row.values.push_back(1e6 * (fit.coefficients[k] / again[k] - 1.0));
    coefficients.rows.push_back(std::move(row));
  }
  return {deviations, coefficients};
}

}  // namespace prs::jung_2017
