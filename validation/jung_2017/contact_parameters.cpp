#include "validation/jung_2017/contact_parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/elliptic_integrals.h"
#include "contact/hertz.h"

namespace prs::jung_2017 {

ContactParameters contact_parameters(double f) {
  const double axis_ratio = contact::ellipticity((1.0 - f) / (1.0 + f));
  const contact::EllipticIntegrals i = contact::complete_elliptic_integrals(axis_ratio);
  ContactParameters p;
  p.semi_major = std::cbrt(2.0 * i.second / (std::numbers::pi * axis_ratio * axis_ratio));
  p.semi_minor = p.semi_major * axis_ratio;
  p.approach = 2.0 * i.first / (std::numbers::pi * p.semi_major);
  return p;
}

const std::array<PrintedParameters, 21>& table_a1() {
  const auto line = [](const char* f, const char* a, const char* b, const char* delta) {
    return PrintedParameters{{f, {}}, {a, {}}, {b, {}}, {delta, {}}};
  };
  static const std::array<PrintedParameters, 21> lines = {
      line("0.1075", "1.0760", "0.9318", "0.9974"),
      line("0.3204", "1.2623", "0.8114", "0.9761"),
      line("0.4795", "1.4556", "0.7278", "0.9429"),
      line("0.5916", "1.6440", "0.6687", "0.9077"),
      line("0.6716", "1.8258", "0.6245", "0.8733"),
      line("0.7332", "2.011", "0.5881", "0.8394"),
      line("0.7948", "2.265", "0.5480", "0.7961"),
      line("0.83495", "2.494", "0.5186", "0.7602"),
      line("0.87366", "2.800", "0.4863", "0.7169"),
      line("0.90999", "3.233", "0.4499", "0.6636"),
      line("0.93657", "3.738", "0.4166", "0.6112"),
      line("0.95738", "4.395", "0.3830", "0.5551"),
      line("0.97290", "5.267", "0.3490", "0.4960"),
      line("0.983797", "6.448", "0.3150", "0.4352"),
      line("0.990902", "8.062", "0.2814", "0.3745"),
      line("0.995112", "10.222", "0.2497", "0.3176"),
      line("0.997300", "12.789", "0.2232", "0.2705"),
      line("0.9981847", "14.839", "0.2072", "0.2427"),
      line("0.9989156", "17.974", "0.18822", "0.2106"),
      line("0.9994785", "23.55", "0.16442", "0.17167"),
      line("0.9998527", "37.38", "0.13050", "0.11995")};
  return lines;
}

double unexplained(const PrintedNumber& printed, const PrintedNumber& f,
                   double ContactParameters::*parameter) {
  const double one = contact_parameters(f.value() - f.half_unit()).*parameter;
  const double other = contact_parameters(f.value() + f.half_unit()).*parameter;
  const auto [least, greatest] = std::minmax(one, other);
  const double beyond = std::max(least - printed.value(), printed.value() - greatest);
  return std::max(beyond - printed.half_unit(), 0.0) / printed.value();
}

ValidationTable deviations_of_table_a1() {
  ValidationTable table{
      "Table A1: printed over exact, less 1, and what of it no rounding explains, in ppm",
      {"F(rho)", "a*", "b*", "delta*", "beyond, a*", "b*", "delta*"},
      {},
      0};
  for (const PrintedParameters& line : table_a1()) {
    const ContactParameters exact = contact_parameters(line.curvature_difference.value());
    ValidationTable::Row row{line.curvature_difference.text, {}};
    row.values = {
        line.semi_major.value() / exact.semi_major - 1.0,
        line.semi_minor.value() / exact.semi_minor - 1.0,
        line.approach.value() / exact.approach - 1.0,
        unexplained(line.semi_major, line.curvature_difference, &ContactParameters::semi_major),
        unexplained(line.semi_minor, line.curvature_difference, &ContactParameters::semi_minor),
        unexplained(line.approach, line.curvature_difference, &ContactParameters::approach)};
    for (double& value : row.values) value *= 1e6;
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace prs::jung_2017
