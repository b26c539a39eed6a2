#include "validation/jung_2017/tables.h"

#include <fmt/ranges.h>

#include <Eigen/Dense>

#include "contact/hertz_formulas.h"
#include "prs/indices.h"
#include "prs/life/rating_life.h"
#include "validation/extensions.h"
#include "validation/jung_2017/statements.h"

namespace prs::jung_2017 {
namespace {

using std::numbers::pi;

constexpr double kContactAngle = pi / 4.0;
constexpr Material kSteel = {.youngs_modulus = 2.1e11, .poisson_ratio = 0.3, .density = {}};
constexpr double kDensity = 7850.0;

/// Table 3.1 prints 6.056 deg; with it four of the ten capacities of table 7.1 end in another
/// digit, with 6.054 deg none does.
constexpr double kPrintedHelixAngle = 6.054 * pi / 180.0;

double square(double x) { return x * x; }

std::array<Diameters, 10> table(double (*roller)(int row, double screw)) {
  std::array<Diameters, 10> rows;
  for (int row = 0; row < 10; ++row) {
    Diameters& d = item_at(rows, row);
    d.nut_outer = (54.0 + 3.0 * row) / "mm"_per_si;
    d.screw = 0.5 * d.nut_outer;
    d.roller = roller(row, d.screw);
  }
  return rows;
}

/// Lemor's factor at the ratio of the diameters; NaN outside its range.
double factor_of(const Diameters& d) {
  return geometry_factor(d.roller * std::cos(kContactAngle) / d.nut_inner()).value_or(std::nan(""));
}

double capacity(const Diameters& d, const Threads& t, double helix_angle) {
  return lemor_capacity(factor_of(d), kContactAngle, static_cast<int>(std::lround(t.contacts())),
                        rolling_element_diameter(t.pitch, d.roller), helix_angle);
}

/// Relative curvatures (3.27)-(3.38) of one contact [1/m], the equal ones of the ball first.
struct Curvatures {
  double along, across;
  double sum() const { return along + across; }
};
struct BothCurvatures {
  Curvatures nut, screw;
};
BothCurvatures curvatures(const Diameters& d) {
  const double ball = 2.0 * std::sin(kContactAngle) / d.roller;
  const double radial = 2.0 * std::cos(kContactAngle);
  return {{ball, ball - radial / d.nut_inner()}, {ball, ball + radial / d.screw}};
}

ThreadCompliance yamamoto(const Diameters& d, const ToothSection& tooth, double screw_width, double nut_width) {
  const ToothDeflection screw = yamamoto_deflection(tooth, kSteel, d.screw);
  const ToothDeflection nut = yamamoto_deflection(tooth, kSteel, d.nut_inner(), d.nut_outer);
  ThreadCompliance c;
  c.teeth = (screw.total() - screw.radial) / screw_width + (nut.total() - nut.radial) / nut_width;
  c.screw_radial = screw.radial / screw_width;
  c.nut_radial = nut.radial / nut_width;
  return c;
}

/// Printed numbers over exact ones, minus 1, in ppm, and the part explained by the rounding of F(rho) and of the number
/// itself.
ValidationTable deviations_of_table_a1(const Reference& thesis) {
  ValidationTable table{"Table A1: printed over exact, less 1, and what of it no rounding explains, in ppm",
                        {"F(rho)", "a*", "b*", "delta*", "beyond, a*", "b*", "delta*"},
                        {},
                        0};
  for (const PrintedParameters& line : table_a1(thesis)) {
    const ContactParameters exact = contact_parameters(line.curvature_difference.value());
    ValidationTable::Row row{line.curvature_difference.text, {}};
    row.values = {line.semi_major.value() / exact.semi_major - 1.0,
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

}  // namespace

std::array<Diameters, 10> case_1() {
  return table([](int row, double) { return (9.0 + row) / "mm"_per_si; });
}

std::array<Diameters, 10> case_2() {
  return table([](int, double screw) { return screw / 3.0; });
}

ThreadCompliance compliance_as_printed(const Diameters& d, const Threads& t) {
  constexpr double kWidth = 1e-3;
  const ToothSection tooth{.root_width = 7.0 / 8.0 * t.pitch,
                           .pitch_width = t.pitch / 2.0,
                           .height = t.pitch / 8.0,
                           .flank_angle = kContactAngle,
                           .pitch = t.lead()};
  ThreadCompliance c = yamamoto(d, tooth, kWidth, kWidth);
  constexpr double kModulus = 4.333e-12, kApproach = 0.98;
  const auto approach = [](double sum) {  // (3.43), (3.44) [mm/N^(2/3)]
    sum /= "mm"_per_si;
    return kApproach * std::pow(1.5 * kModulus / sum, 2.0 / 3.0) * sum / 2.0;
  };
  const BothCurvatures rho = curvatures(d);
  const double axial = std::sin(kContactAngle) * std::cos(t.helix_angle.value_or(kPrintedHelixAngle));
  c.hertz = (approach(rho.nut.sum()) + approach(rho.screw.sum())) * std::cbrt(1.0 / t.load) *
            std::pow(axial, -5.0 / 3.0) / "mm"_per_si;
  return c;
}

Measures as_printed(const Diameters& d, const Threads& t) {
  Measures m;
  const double outer = d.nut_outer, inner = d.nut_inner();
  m.nut_thickness = outer - inner;
  m.volume = pi * t.length * (square(outer) + square(d.screw) - square(inner) + t.rollers * square(d.roller));
  m.stiffness = 1.0 / compliance_as_printed(d, t).total();
  m.load_capacity = capacity(d, t, t.helix_angle.value_or(kPrintedHelixAngle));
  // Evaluated in mm and in this order: a weight of table 7.2 ends in a rounded 5.
  const double d_r = "mm"_per_si * d.roller, d_n = "mm"_per_si * outer;
  const double wall = d_n - "mm"_per_si * d.screw - 2.0 * d_r;
  m.weight = 0.006165 * square(d_r) * t.rollers * t.length + 0.02466 * (d_n - wall) * wall * t.length;
  return m;
}

ThreadCompliance right_compliance(const Diameters& d, const Threads& t) {
  const ToothSection tooth{.root_width = 7.0 / 8.0 * t.pitch,
                           .pitch_width = t.pitch / 2.0,
                           .height = 3.0 / 16.0 * t.pitch,
                           .flank_angle = kContactAngle,
                           .pitch = t.pitch};
  ThreadCompliance c = yamamoto(d, tooth, pi * d.screw / t.rollers, pi * d.nut_inner() / t.rollers);
  const double modulus = contact::contact_modulus(kSteel, kSteel);
  const auto approach = [&](const Curvatures& rho, double diameter) {
    const double axial = std::sin(kContactAngle) * std::cos(t.helix_angle_at(diameter));
    const contact::HertzContact contact =
        contact::at_load(contact::hertz_constants(rho.along, rho.across, modulus), t.load / axial);
    return contact.approach / axial;
  };
  const BothCurvatures rho = curvatures(d);
  c.hertz = (approach(rho.nut, d.nut_inner()) + approach(rho.screw, d.screw)) / t.load;
  return c;
}

Measures corrected(const Diameters& d, const Threads& t) {
  Measures m;
  m.nut_thickness = 0.5 * (d.nut_outer - d.nut_inner());
  m.volume = 0.25 * pi * t.length * (square(d.nut_outer) - square(d.nut_inner()) + t.rollers * square(d.roller));
  m.stiffness = 1.0 / right_compliance(d, t).total();
  m.load_capacity = capacity(d, t, t.helix_angle_at(d.screw));
  m.weight = kDensity * m.volume;
  return m;
}

ContactParameters contact_parameters(double f) {
  const double axis_ratio = contact::ellipticity((1.0 - f) / (1.0 + f));
  const contact::EllipticIntegrals i = contact::complete_elliptic_integrals(axis_ratio);
  ContactParameters p;
  p.semi_major = std::cbrt(2.0 * i.second / (std::numbers::pi * axis_ratio * axis_ratio));
  p.semi_minor = p.semi_major * axis_ratio;
  p.approach = 2.0 * i.first / (std::numbers::pi * p.semi_major);
  return p;
}

std::vector<PrintedParameters> table_a1(const Reference& thesis) {
  std::vector<PrintedParameters> lines;
  for (const ReferenceCase& c : thesis.cases)
    for (const PrintedValue& v : c.values) {
      if (!v.where.starts_with("table A1")) continue;
      const std::string f = v.where.substr(v.where.rfind(' ') + 1);  // Text such as `F = 0.1075`.
      if (lines.empty() || lines.back().curvature_difference.text != f) lines.push_back({{f, {}}, {}, {}, {}});
      PrintedParameters& line = lines.back();
      (v.quantity.ends_with("semi_major")   ? line.semi_major
       : v.quantity.ends_with("semi_minor") ? line.semi_minor
                                            : line.approach) = v.printed;
    }
  return lines;
}

double unexplained(const PrintedNumber& printed, const PrintedNumber& f, double ContactParameters::*parameter) {
  const double one = contact_parameters(f.value() - f.half_unit()).*parameter;
  const double other = contact_parameters(f.value() + f.half_unit()).*parameter;
  const auto [least, greatest] = std::minmax(one, other);
  const double beyond = std::max(least - printed.value(), printed.value() - greatest);
  return std::max(beyond - printed.half_unit(), 0.0) / printed.value();
}

std::array<ScaleLine, 10> scale_chart() {
  std::array<ScaleLine, 10> lines;
  double sum_of_squares = 0.0;
  for (int k = 0; k < 10; ++k) {
    ScaleLine& line = item_at(lines, k);
    line.rollers = 6 + k;
    line.roller = (7.8 + 1.3 * k) / "mm"_per_si;
    line.screw = (18.0 + 3.0 * k) / "mm"_per_si;
    line.nut_outer = (40.0 + 6.67 * k) / "mm"_per_si;
    sum_of_squares += line.nut_outer * line.nut_outer;
  }
  const double root_mean_square = std::sqrt(sum_of_squares / 10.0);
  for (ScaleLine& line : lines) line.scale = line.nut_outer / root_mean_square;
  return lines;
}

namespace {

constexpr double kLitre = 1e3;  // Litres per m^3.

double to_three_decimals(double x) { return std::round(1e3 * x) / 1e3; }

std::array<Diameters, 10> rows_of(const VolumeFit& fit) { return fit.of_case_2 ? case_2() : case_1(); }

/// Largest differences between a printed polynomial and the fitted values.
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

std::vector<VolumeFit> volume_fits(const Reference& thesis) {
  const std::map<std::string, double (*)(const Measures&), std::less<>> values{
      {"stiffness, N/mm", [](const Measures& m) { return m.stiffness / "mm"_per_si; }},
      {"load capacity, kN", [](const Measures& m) { return m.load_capacity * "kN"_per_si; }},
      {"weight, kg", [](const Measures& m) { return m.weight; }}};
  const CsvTable table(thesis.folder / "fits.csv");
  std::vector<VolumeFit> fits;
  for (const auto row : up_to(table.rows())) {
    VolumeFit& fit = fits.emplace_back();
    fit.equation = table.text(row, 0);
    fit.measure = table.text(row, 1);
    fit.of_case_2 = table.number(row, 2) == 2.0;
    fit.value = values.at(fit.measure);
    for (const auto k : indices(fit.coefficients)) fit.coefficients[k] = table.number(row, 3 + k);
  }
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
      if (y < 1e3) y = to_three_decimals(y);  // Stiffnesses follow to 0.004 N/mm only.
    }
    for (Eigen::Index power = 0; power < 6; ++power) powers(row, power) = std::pow(x, static_cast<double>(5 - power));
    values(row++) = y;
  }
  const Eigen::Vector<double, 6> solution = powers.colPivHouseholderQr().solve(values);
  std::array<double, 6> coefficients;
  std::ranges::copy(solution, coefficients.begin());
  return coefficients;
}

std::vector<ValidationTable> fit_tables(const Reference& thesis) {
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
  for (const VolumeFit& fit : volume_fits(thesis)) {
    deviations.rows.push_back(deviation(fit));
    const std::array<double, 6> again = refitted(fit);
    ValidationTable::Row row{fit.equation, {}};
    for (const auto k : indices(again)) row.values.push_back(1e6 * (fit.coefficients[k] / again[k] - 1.0));
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
    lines[fmt::format("rollers_{}", line.rollers)] = {{"scale", line.scale},
                                                      {"roller_mm", line.roller * "mm"_per_si},
                                                      {"screw_mm", line.screw * "mm"_per_si},
                                                      {"nut_outer_mm", line.nut_outer * "mm"_per_si}};
  return lines;
}

/// A row of tables 7.1 and 7.2 as printed.
Json row_json(const Diameters& d) {
  const Measures m = as_printed(d);
  return {{"nut_thickness_mm", m.nut_thickness * "mm"_per_si},
          {"volume_l", 1e3 * m.volume},
          {"stiffness_N_per_mm", 1e-3 * m.stiffness},
          {"load_capacity_kN", m.load_capacity * "kN"_per_si},
          {"weight_kg", m.weight},
          {"force_density_kN_per_kg", m.force_density() * "kN"_per_si}};
}

Json formulas(const Reference& thesis) {
  Json json{{"table_7_1", Json::array()}, {"table_7_2", Json::array()}, {"table_a1", Json::array()}};
  for (const Diameters& d : case_1()) json["table_7_1"].push_back(row_json(d));
  for (const Diameters& d : case_2()) json["table_7_2"].push_back(row_json(d));
  for (const PrintedParameters& line : table_a1(thesis)) {
    const ContactParameters p = contact_parameters(line.curvature_difference.value());
    json["table_a1"].push_back({{"semi_major", p.semi_major}, {"semi_minor", p.semi_minor}, {"approach", p.approach}});
  }
  json["table_8_1"] = lines_by_rollers();
  return json;
}

ValidationTable measures_table(std::string title, const std::array<Diameters, 10>& rows,
                               Measures (*measures)(const Diameters&, const Threads&)) {
  ValidationTable table{
      std::move(title), {"D_n, mm", "d_r, mm", "T, mm", "V, l", "k, N/mm", "C_a, kN", "W, kg", "C_a/W, kN/kg"}, {}};
  for (const Diameters& d : rows) {
    const Measures m = measures(d, {});
    table.rows.push_back(
        {fmt::format("{:g}", d.nut_outer * "mm"_per_si),
         {d.roller * "mm"_per_si, m.nut_thickness * "mm"_per_si, 1e3 * m.volume, m.stiffness / "mm"_per_si,
          m.load_capacity * "kN"_per_si, m.weight, m.force_density() * "kN"_per_si}});
  }
  return table;
}

/// Parts of the compliance of the first row of both tables.
ValidationTable compliance_table() {
  ValidationTable table{"Compliance of one thread for D_n = 54 mm, in nm/N",
                        {"formulas", "teeth", "screw, radial", "nut, radial", "Hertz", "all"},
                        {}};
  const auto row = [&](const char* label, const ThreadCompliance& c) {
    table.rows.push_back({label, {c.teeth, c.screw_radial, c.nut_radial, c.hertz, c.total()}});
    for (double& value : table.rows.back().values) value *= "nm"_per_si;
  };
  row("as printed", compliance_as_printed(case_1().front()));
  row("right", right_compliance(case_1().front()));
  return table;
}

std::vector<ValidationTable> tables(const Reference& thesis) {
  std::vector<ValidationTable> all{measures_table("Table 7.1, case 1, by the right formulas", case_1(), corrected),
                                   measures_table("Table 7.2, case 2, by the right formulas", case_2(), corrected),
                                   compliance_table()};
  for (ValidationTable& table : fit_tables(thesis)) all.push_back(std::move(table));
  all.push_back(deviations_of_table_a1(thesis));
  return all;
}

}  // namespace

SourceExtension extension() {
  return {
      .folder = "jung_2017", .formulas = formulas, .tables = tables, .supplement = [](const Case& c, const auto& r) {
        return Supplement{.statements = compare_statements(c, r)};
      }};
}

}  // namespace prs::jung_2017
