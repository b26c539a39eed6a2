#include "validation/jung_2017/tables.h"

#include <Eigen/Dense>

#include "contact/hertz_formulas.h"
#include "validation/extensions.h"
#include "validation/jung_2017/recipe.h"

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

std::array<ScaleLine, 10> scale_chart() {
  std::array<ScaleLine, 10> lines;
  double sum_of_squares = 0.0;
  for (int k = 0; k < 10; ++k) {
    ScaleLine& line = lines[static_cast<std::size_t>(k)];
    line.rollers = 6 + k;
    line.roller = (7.8 + 1.3 * k) / per_si::millimetre;
    line.screw = (18.0 + 3.0 * k) / per_si::millimetre;
    line.nut_outer = (40.0 + 6.67 * k) / per_si::millimetre;
    sum_of_squares += line.nut_outer * line.nut_outer;
  }
  const double root_mean_square = std::sqrt(sum_of_squares / 10.0);
  for (ScaleLine& line : lines) line.scale = line.nut_outer / root_mean_square;
  return lines;
}

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

namespace {

using Json = nlohmann::ordered_json;

/// The sets of tables 8.2 to 8.5 and 8.8 are lines of table 8.1, named by their number of rollers.
Json lines_by_rollers() {
  Json lines = Json::object();
  for (const ScaleLine& line : scale_chart())
    lines[fmt::format("rollers_{}", line.rollers)] = {
        {"scale", line.scale},
        {"roller_mm", line.roller * per_si::millimetre},
        {"screw_mm", line.screw * per_si::millimetre},
        {"nut_outer_mm", line.nut_outer * per_si::millimetre}};
  return lines;
}

Json formulas() {
  Json json{{"table_7_1", Json::array()}, {"table_a1", Json::array()}};
  for (const Diameters& d : case_1())
    json["table_7_1"].push_back(row_json(*find_recipe("jung-as-printed"), d));
  for (const PrintedParameters& line : table_a1()) {
    const ContactParameters p = contact_parameters(line.curvature_difference.value());
    json["table_a1"].push_back(
        {{"semi_major", p.semi_major}, {"semi_minor", p.semi_minor}, {"approach", p.approach}});
  }
  json["table_8_1"] = lines_by_rollers();
  return json;
}

ValidationTable measures_table(std::string title, const std::array<Diameters, 10>& rows,
                               Measures (*measures)(const Diameters&)) {
  ValidationTable table{
      std::move(title),
      {"D_n, mm", "d_r, mm", "T, mm", "V, l", "k, N/mm", "C_a, kN", "W, kg", "C_a/W, kN/kg"},
      {}};
  for (const Diameters& d : rows) {
    const Measures m = measures(d);
    table.rows.push_back(
        {fmt::format("{:g}", d.nut_outer * per_si::millimetre),
         {d.roller * per_si::millimetre, m.nut_thickness * per_si::millimetre, 1e3 * m.volume,
          m.stiffness / per_si::millimetre, m.load_capacity * per_si::kilonewton, m.weight,
          m.force_density() * per_si::kilonewton}});
  }
  return table;
}

/// What the first row of both tables consists of.
ValidationTable compliance_table() {
  ValidationTable table{"Compliance of one thread for D_n = 54 mm, in nm/N",
                        {"formulas", "teeth", "screw, radial", "nut, radial", "Hertz", "all"},
                        {}};
  const auto row = [&](const char* label, const ThreadCompliance& c) {
    table.rows.push_back({label, {c.teeth, c.screw_radial, c.nut_radial, c.hertz, c.total()}});
    for (double& value : table.rows.back().values) value *= per_si::nanometre;
  };
  row("as printed", compliance_as_printed(case_1().front()));
  row("right", right_compliance(case_1().front()));
  return table;
}

std::vector<ValidationTable> tables() {
  std::vector<ValidationTable> all{
      measures_table("Table 7.1, case 1, by the right formulas", case_1(), corrected),
      measures_table("Table 7.2, case 2, by the recipe of table 7.1", case_2(), as_printed),
      measures_table("Table 7.2, case 2, by the right formulas", case_2(), corrected),
      compliance_table()};
  for (ValidationTable& table : fit_tables()) all.push_back(std::move(table));
  all.push_back(deviations_of_table_a1());
  return all;
}

}  // namespace

SourceExtension extension() {
  return {.folder = "jung_2017", .formulas = formulas, .tables = tables};
}

}  // namespace prs::jung_2017
