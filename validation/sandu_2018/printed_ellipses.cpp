#include "validation/sandu_2018/printed_ellipses.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/elliptic_integrals.h"
#include "contact/ellipticity_approximations.h"
#include "contact/film.h"
#include "contact/patch.h"
#include "prs/loads/analyze.h"
#include "prs/model/units.h"
#include "prs/slip/slip_model.h"
#include "validation/sandu_2018/sweep.h"

namespace prs::sandu_2018 {
namespace {

constexpr int kPointsOfFigure28 = 11;

/// Relative curvatures along the axes that the thesis gives the ellipse: table 1.4 with absolute
/// values of the curvatures, then (1.71), (1.72).
contact::PrincipalValues curvatures_by_absolute_values(const contact::InterfaceGeometry& g) {
  const double phi = g.first_directions_angle();
  const double body = std::abs(g.body.second) - std::abs(g.body.first);
  const double roller = g.roller.second - g.roller.first;
  const double phi_1 =
      0.5 *
      std::asin(roller * std::sin(2 * phi) /
                std::sqrt(body * body + roller * roller + 2 * body * roller * std::cos(2 * phi)));
  const auto along = [](const contact::PrincipalValues& k, double angle) {
    return k.first * std::cos(angle) * std::cos(angle) +
           k.second * std::sin(angle) * std::sin(angle);
  };
  contact::PrincipalValues relative;
  relative.first = along(g.body, phi_1) + along(g.roller, phi - phi_1);
  relative.second = g.curvature_sum() - relative.first;
  if (std::abs(relative.first) > std::abs(relative.second))
    std::swap(relative.first, relative.second);
  return relative;
}

/// (1.80) with k = q^(2/pi).
contact::HertzContact printed_ellipse(const contact::PrincipalValues& relative, double load,
                                      double contact_modulus) {
  const double k = contact::hamrock_brewe_ellipticity(relative.second / relative.first);
  const double second = contact::complete_elliptic_integrals(1.0 / k).second;
  const double major =
      std::cbrt(6 * k * k * second * load /
                (std::numbers::pi * (relative.first + relative.second) * 2 * contact_modulus));
  return {load, 0.0, major, major / k, 1.5 * load * k / (std::numbers::pi * major * major)};
}

/// (2.36) as printed, |u| - (u.n)^2/|u|, in place of the length of the tangential part.
double printed_rolling_speed(const contact::Vector3<double>& u,
                             const contact::Vector3<double>& normal) {
  const double u_n = u.dot(normal);
  return u.norm() - u_n * u_n / u.norm();
}

}  // namespace

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
    const double rolling = printed_rolling_speed(
        contact_motion(model.geometry, balance.motion, i).rolling, contact.geometry.point.normal);
    const contact::PatchMotion& motion = balance.sliding[i];
    const auto add = [&](std::vector<double>& row, const contact::HertzContact& ellipse,
                         double larger_curvature, double rolling_speed) {
      const contact::Film film = contact::sandu_film(
          *model.oils.threads[i], {load, larger_curvature, contact.contact_modulus}, rolling_speed);
      row.push_back(film.thickness * per_si::nanometre);
      row.push_back(contact::Patch(grid, ellipse, contact::coulomb_friction(0.0))
                        .friction(motion)
                        .max_sliding_speed *
                    per_si::millimetre);
    };
    add(thesis, printed_ellipse(relative, load, contact.contact_modulus), relative.second, rolling);
    add(here, contact::at_load(contact.hertz, load), contact.geometry.relative.second,
        motion.rolling_speed);
  }
  return {
      "Figs. 2.8 and 2.9: film thickness and largest sliding speed; `thesis` takes absolute values "
      "of the curvatures in table 1.4, k = q^(2/pi) and (2.36) as printed",
      {"", "h_cI in nm", "v_I in mm/s", "h_cJ in nm", "v_J in mm/s"},
      {{"printed", {438, 107, 495, 9.3}}, {"thesis", thesis}, {"here", here}}};
}

}  // namespace prs::sandu_2018
