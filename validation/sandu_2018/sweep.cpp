#include "validation/sandu_2018/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "prs/slip/slip.h"

namespace prs::sandu_2018 {

SlipResult slip_of(const Case& c) { return *analyze_slip(c).load_cases.front().slip; }

Line line_through(const std::vector<double>& x, const std::vector<double>& y) {
  const auto mean = [](const std::vector<double>& v) {
    double sum = 0.0;
    for (const double value : v) sum += value;
    return sum / static_cast<double>(v.size());
  };
  const double x_mean = mean(x), y_mean = mean(y);
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - x_mean) * (x[i] - x_mean);
    xy += (x[i] - x_mean) * (y[i] - y_mean);
  }
  Line line{y_mean - xy / xx * x_mean, xy / xx, 0.0};
  for (std::size_t i = 0; i < x.size(); ++i)
    line.worst = std::max(line.worst, std::abs(y[i] - line.intercept - line.slope * x[i]));
  return line;
}

ValidationTable efficiency_fits(const Case& reference) {
  ValidationTable table{
      "(3.55): the constants of H = B_1 - B_2 tau_0 ln(eta_0), tau_0 in MPa and eta_0 in mPa s, "
      "fitted to computed efficiencies",
      {"tau_0, eta_0", "B_1 in %", "B_2 in %", "worst in points"},
      {}};
  const auto add = [&](const char* range, const std::vector<double>& stresses,
                       const std::vector<double>& viscosities) {
    std::vector<double> product, efficiency;
    for (const double stress : stresses)
      for (const double viscosity : viscosities) {
        Case varied = reference;
        varied.lubricant->eyring_stress = stress * 1e6;
        varied.lubricant->viscosity = viscosity * 1e-3;
        product.push_back(stress * std::log(viscosity));
        efficiency.push_back(slip_of(varied).efficiency.value_or(0.0));
      }
    const Line line = line_through(product, efficiency);
    table.rows.push_back({range, {100 * line.intercept, 100 * -line.slope, 100 * line.worst}});
  };
  table.rows.push_back({"printed", {98.1, 0.32}});
  add("11 to 13, 150 to 180", {11, 12, 13}, {150, 165, 180});
  add("12, 28.4 to 266", {12}, {28.4, 50, 100, 166.5, 266});
  add("8 to 16, 100 to 266", {8, 10, 12, 14, 16}, {100, 133, 166.5, 200, 266});
  add("4 to 12, 28.4 to 266", {4, 6, 8, 10, 12}, {28.4, 50, 100, 166.5, 266});
  add("2 to 16, 10 to 300", {2, 4, 6, 8, 10, 12, 14, 16}, {10, 30, 100, 166.5, 300});
  return table;
}

ValidationTable patch_convergence(const Case& reference) {
  ValidationTable table{
      "Section 3.2.8, fig. 3.8: power at one contact for n x n points, slip ratio from equilibrium",
      {"n", "W_I in W", "W_J in W", "W_t in W", "efficiency in %", "slip ratio"},
      {}};
  for (const int points : {1, 11, 21, 41, 101, 301}) {
    Case c = reference;
    c.model.patch_points = points;
    const SlipResult s = slip_of(c);
    table.rows.push_back({fmt::format("{}", points),
                          {s.threads.screw.power.front(), s.threads.nut.power.front(),
                           s.power.total(), 100 * s.efficiency.value_or(0.0), s.slip_ratio}});
  }
  return table;
}

}  // namespace prs::sandu_2018
