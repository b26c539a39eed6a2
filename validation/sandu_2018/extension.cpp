#include "validation/extensions.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "contact/ellipticity_approximations.h"
#include "contact/hertz.h"
#include "prs/model/units.h"
#include "validation/sandu_2018/printed_ellipses.h"
#include "validation/sandu_2018/statements.h"
#include "validation/sandu_2018/sweep.h"

namespace prs::sandu_2018 {
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
  const contact::HertzConstants ball =
      contact::hertz_constants(1.0 / kBallRadius, 1.0 / kBallRadius, contact_modulus);
  const double pressure = contact::at_load(ball, kMass * kGravity).peak_pressure;
  return {{"peak_pressure_GPa", pressure * per_si::gigapascal},  // (2.41)
          {"max_speed_mm_per_s",
           std::numbers::pi * kStroke * kFrequency * per_si::millimetre},  // (2.42)
          {"mass_for_2_5_GPa_kg", kMass * std::pow(kPressureInScrew / pressure, 3.0)}};
}

Json derived(const Result& result) {
  const contact::MechanismGeometry& threads = result.contacts.threads;
  const contact::ContactPoint& j = result.contacts.interfaces.nut.geometry.point;
  const auto mm = [](double metres) { return metres * per_si::millimetre; };
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
    json["relative_modulus_GPa"] = 2.0 * modulus * per_si::gigapascal;  // (1.78)
    json["hfrr"] = reciprocating_rig(modulus);
  }
  return json;
}

/// Table 1.5 against the exact a/b, for ratios of the relative curvatures.
ValidationTable ellipticity_approximations() {
  ValidationTable table{
      "Table 1.5: error of a/b by each approximation against the exact one, in %",
      {"q = kappa_2/kappa_1", "exact a/b", "1.03 q^0.64", "q^(2/pi)", "q^(2/3)", "Antoine et al."},
      {}};
  for (const double q :
       {1.0, 1.2, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0}) {
    const double exact = 1.0 / contact::ellipticity(1.0 / q);
    const auto error = [&](double approximation) { return 100.0 * (approximation / exact - 1.0); };
    table.rows.push_back(
        {fmt::format("{:g}", q),
         {exact, error(contact::hamrock_dowson_ellipticity(q)),
          error(contact::hamrock_brewe_ellipticity(q)), error(contact::johnson_ellipticity(q)),
          error(contact::antoine_ellipticity(q))}});
  }
  return table;
}

}  // namespace

SourceExtension extension() {
  return {.folder = "sandu_2018",
          .derived = derived,
          .tables = [] { return std::vector{ellipticity_approximations()}; },
          .supplement =
              [](const Case& reference, const std::filesystem::path&) {
                return Supplement{
                    .statements = compare_statements(reference),
                    .tables = {printed_ellipses(reference), patch_convergence(reference),
                               efficiency_fits(reference)}};
              },
          .subject = "reference_example.yaml"};
}

}  // namespace prs::sandu_2018
