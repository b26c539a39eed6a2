#include "contact/flash_temperature.h"

#include "contact/hertz_formulas.h"

namespace contact {
namespace {

/// max over x of the integral of sqrt(1 - s^2)/sqrt(x - s) from -1 to x, at x = 0.652, over
/// sqrt(pi).
constexpr double kBand = 1.234619830961;

}  // namespace

double surface_rise(const HertzContact& ellipse, const HeatedBody& body, double power) {
  constexpr double kPi = std::numbers::pi;
  const double a = ellipse.semi_major, b = ellipse.semi_minor;
  const double at_rest =
      3.0 * power * complete_elliptic_integrals(b / a).first / (4.0 * kPi * body.conductivity * a);
  const double speed = std::hypot(body.speed_major, body.speed_minor);
  if (!(speed > 0.0)) return at_rest;
  // l/V, how long half of the band takes.
  const double time = 1.0 / std::hypot(body.speed_major / a, body.speed_minor / b);
  const double flux = 3.0 * power / (2.0 * kPi * a * b);
  const double fast =
      kBand * flux * std::sqrt(time / (body.conductivity * body.density * body.specific_heat));
  return at_rest / std::hypot(1.0, at_rest / fast);
}

double flash_temperature(const HertzContact& ellipse, const std::array<HeatedBody, 2>& bodies,
                         double power) {
  if (!(power > 0.0)) return 0.0;
  return 1.0 / (1.0 / surface_rise(ellipse, bodies[0], power) +
                1.0 / surface_rise(ellipse, bodies[1], power));
}

}  // namespace contact
