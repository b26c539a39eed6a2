#include "validation/sandu_2018/reference_example.h"

#include "contact/hertz_formulas.h"
#include "prs/indices.h"
#include "prs/slip/slip.h"
#include "validation/extensions.h"
#include "validation/sandu_2018/profile_curvatures.h"
#include "validation/sandu_2018/statements.h"

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
  for (const auto i : indices(x)) {
    xx += (x[i] - x_mean) * (x[i] - x_mean);
    xy += (x[i] - x_mean) * (y[i] - y_mean);
  }
  Line line{y_mean - xy / xx * x_mean, xy / xx, 0.0};
  for (const auto i : indices(x))
    line.worst = std::max(line.worst, std::abs(y[i] - line.intercept - line.slope * x[i]));
  return line;
}

ValidationTable efficiency_fits(const Case& reference) {
  ValidationTable table{
      "(3.55): the constants of H = B_1 - B_2 tau_0 ln(eta_0), tau_0 in MPa and eta_0 in mPa s, "
      "fitted to computed efficiencies",
      {"tau_0, eta_0", "B_1 in %", "B_2 in %", "worst in points"},
      {}};
  const auto add = [&](const char* range, const std::vector<double>& stresses, const std::vector<double>& viscosities) {
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
  ValidationTable table{"Section 3.2.8, fig. 3.8: power at one contact for n x n points, slip ratio from equilibrium",
                        {"n", "W_I in W", "W_J in W", "W_t in W", "efficiency in %", "slip ratio"},
                        {}};
  for (const int points : {1, 11, 21, 41, 101, 301}) {
    Case c = reference;
    c.model.patch_points = points;
    const SlipResult s = slip_of(c);
    table.rows.push_back({fmt::format("{}", points),
                          {s.threads.screw.power.front(), s.threads.nut.power.front(), s.power.total(),
                           100 * s.efficiency.value_or(0.0), s.slip_ratio}});
  }
  return table;
}

namespace {

constexpr int kPointsOfFigure28 = 11;

/// Relative curvatures along the axes that the thesis gives the ellipse: table 1.4 with absolute
/// values of the curvatures, then (1.71), (1.72).
contact::PrincipalValues curvatures_by_absolute_values(const contact::InterfaceGeometry& g) {
  const double phi = g.first_directions_angle();
  const double body = std::abs(g.body.second) - std::abs(g.body.first);
  const double roller = g.roller.second - g.roller.first;
  const double phi_1 =
      0.5 * std::asin(roller * std::sin(2 * phi) /
                      std::sqrt(body * body + roller * roller + 2 * body * roller * std::cos(2 * phi)));
  const auto along = [](const contact::PrincipalValues& k, double angle) {
    return k.first * std::cos(angle) * std::cos(angle) + k.second * std::sin(angle) * std::sin(angle);
  };
  contact::PrincipalValues relative;
  relative.first = along(g.body, phi_1) + along(g.roller, phi - phi_1);
  relative.second = g.curvature_sum() - relative.first;
  if (std::abs(relative.first) > std::abs(relative.second)) std::swap(relative.first, relative.second);
  return relative;
}

/// (1.80) with k = q^(2/pi).
contact::HertzContact printed_ellipse(const contact::PrincipalValues& relative, double load, double contact_modulus) {
  const double k = contact::hamrock_brewe_ellipticity(relative.second / relative.first);
  const double second = contact::complete_elliptic_integrals(1.0 / k).second;
  const double major = std::cbrt(6 * k * k * second * load /
                                 (std::numbers::pi * (relative.first + relative.second) * 2 * contact_modulus));
  return {load, 0.0, major, major / k, 1.5 * load * k / (std::numbers::pi * major * major)};
}

/// (2.36) as printed, |u| - (u.n)^2/|u|, in place of the length of the tangential part.
double printed_rolling_speed(const contact::Vector3<double>& u, const contact::Vector3<double>& normal) {
  const double u_n = u.dot(normal);
  return u.norm() - u_n * u_n / u.norm();
}

/// Film thicknesses and largest sliding speed of figs. 2.8 and 2.9: as printed, by the thesis' own formulas, and with
/// the signs of the curvatures kept. `reference` is the case of table 3.2.
ValidationTable printed_ellipses(const Case& reference) {
  const Result result = analyze_contacts(reference);
  const LoadCaseResult& loaded = result.load_cases.front();
  const SlipModels models(reference, result.contacts);
  const SlipModel model = models.of(loaded);
  const contact::PatchGrid grid(kPointsOfFigure28);
  SlipBalance balance;
  balance_at(model, kMeasuredSlipRatio, balance);

  std::vector<double> thesis, here;
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = result.contacts.interfaces[i];
    const double load = (*loaded.threads)[i].normal_load.front();
    const contact::PrincipalValues relative = curvatures_by_absolute_values(contact.geometry);
    const double rolling =
        printed_rolling_speed(contact_motion(model.geometry, balance.motion, i).rolling, contact.geometry.point.normal);
    const contact::PatchMotion& motion = balance.sliding[i];
    const auto add = [&](std::vector<double>& row, const contact::HertzContact& ellipse, double larger_curvature,
                         double rolling_speed) {
      const contact::Film film =
          contact::sandu_film(*model.oils.threads[i], {load, larger_curvature, contact.contact_modulus}, rolling_speed);
      row.push_back(film.thickness * "nm"_per_si);
      row.push_back(contact::Patch(grid, ellipse, contact::friction_law(contact::Coulomb{0.0}))
                        .friction(motion)
                        .max_sliding_speed *
                    "mm"_per_si);
    };
    add(thesis, printed_ellipse(relative, load, contact.contact_modulus), relative.second, rolling);
    add(here, contact::at_load(contact.hertz, load), contact.geometry.relative.second, motion.rolling_speed);
  }
  return {
      "Figs. 2.8 and 2.9: film thickness and largest sliding speed; `thesis` takes absolute values "
      "of the curvatures in table 1.4, k = q^(2/pi) and (2.36) as printed",
      {"", "h_cI in nm", "v_I in mm/s", "h_cJ in nm", "v_J in mm/s"},
      {{"printed", {438, 107, 495, 9.3}}, {"thesis", thesis}, {"here", here}}};
}

}  // namespace

namespace {

using Json = nlohmann::ordered_json;

/// z of the roller's surface at I on its top face, gamma = -1 (1.22), z_m of table B.1 [m].
double height_on_roller(const Contacts& contacts) {
  const contact::ThreadSurface roller(contacts.threads.roller);
  const contact::ContactPoint& i = contacts.interfaces.screw.geometry.point;
  return -roller.profile(i.radius_on_roller).height + i.angle_on_roller * roller.reduced_lead;
}

/// High-frequency reciprocating rig of fig. 2.11: a ball that slides on a disc.
Json reciprocating_rig(double contact_modulus) {
  constexpr double kBallRadius = 3e-3, kMass = 0.5, kGravity = 9.81, kStroke = 1e-3;
  constexpr double kFrequency = 20.0, kPressureInScrew = 2.5e9;
  const contact::HertzConstants ball = contact::hertz_constants(1.0 / kBallRadius, 1.0 / kBallRadius, contact_modulus);
  const double pressure = contact::at_load(ball, kMass * kGravity).peak_pressure;
  return {{"peak_pressure_GPa", pressure * "GPa"_per_si},                                 // (2.41)
          {"max_speed_mm_per_s", std::numbers::pi * kStroke * kFrequency * "mm"_per_si},  // (2.42)
          {"mass_for_2_5_GPa_kg", kMass * std::pow(kPressureInScrew / pressure, 3.0)}};
}

Json derived(const Result& result) {
  const contact::MechanismGeometry& threads = result.contacts.threads;
  const contact::ContactPoint& j = result.contacts.interfaces.nut.geometry.point;
  const auto mm = [](double metres) { return metres * "mm"_per_si; };
  Json json{{"pitch_radius_mm",
             {{"screw", mm(threads.screw.pitch_radius)},
              {"roller", mm(threads.roller.pitch_radius)},
              {"nut", mm(threads.nut.pitch_radius)}}},
            {"roller_lead_mm", mm(threads.roller.lead)},
            {"nut_contact_x_mm", mm(j.radius_on_body * std::cos(j.angle_on_body))},  // (1.84)
            {"nut_contact_y_mm", mm(j.radius_on_body * std::sin(j.angle_on_body))},
            {"screw_contact_z_on_roller_mm", mm(height_on_roller(result.contacts))}};
  const double modulus = result.contacts.interfaces.screw.contact_modulus;
  if (modulus > 0.0) {
    json["relative_modulus_GPa"] = 2.0 * modulus * "GPa"_per_si;  // (1.78)
    json["hfrr"] = reciprocating_rig(modulus);
  }
  return json;
}

/// Table 1.5 against the exact a/b, for ratios of the relative curvatures.
ValidationTable ellipticity_approximations() {
  ValidationTable table{"Table 1.5: error of a/b by each approximation against the exact one, in %",
                        {"q = kappa_2/kappa_1", "exact a/b", "1.03 q^0.64", "q^(2/pi)", "q^(2/3)", "Antoine et al."},
                        {}};
  for (const double q : {1.0, 1.2, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0}) {
    const double exact = 1.0 / contact::ellipticity(1.0 / q);
    const auto error = [&](double approximation) { return 100.0 * (approximation / exact - 1.0); };
    table.rows.push_back(
        {fmt::format("{:g}", q),
         {exact, error(contact::hamrock_dowson_ellipticity(q)), error(contact::hamrock_brewe_ellipticity(q)),
          error(contact::johnson_ellipticity(q)), error(contact::antoine_ellipticity(q))}});
  }
  return table;
}

}  // namespace

SourceExtension extension() {
  return {.folder = "sandu_2018",
          .derived = derived,
          .tables = [](auto&) { return std::vector{ellipticity_approximations()}; },
          .supplement =
              [](const Case& reference, const Reference& thesis) {
                Supplement s = profile_curvatures(thesis);
                std::ranges::move(compare_statements(reference, thesis), std::back_inserter(s.statements));
                for (auto* table : {printed_ellipses, patch_convergence, efficiency_fits})
                  s.tables.push_back(table(reference));
                return s;
              },
          .subject = "reference_example.yaml"};
}

}  // namespace prs::sandu_2018
