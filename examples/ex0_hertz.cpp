// Example 0: a Hertz contact.
//
// A steel ball of 5 mm radius is pressed on a steel plate. What the library computes for any two
// principal curvatures is compared with Hertz's closed form for the circle,
//
//     a^3 = 3 N R/(4 E*),   delta = a^2/R,   p_0 = 3 N/(2 pi a^2).
//
// Then one of the curvatures becomes smaller, as at the flank of a thread: the circle becomes an
// ellipse. All values are in SI units: m, N, Pa.
#include <prs/contact/hertz.h>

#include <cmath>
#include <cstdio>
#include <numbers>

int main() {
  const contact::Elasticity steel{210e9, 0.3};
  const double modulus = contact::contact_modulus(steel, steel);  // E*
  const double radius = 5e-3, load = 100.0;

  // Constants of the contact, which do not depend on the load; then the contact under the load.
  const auto constants = contact::hertz_constants(1.0 / radius, 1.0 / radius, modulus);
  const contact::HertzContact ball = contact::at_load(constants, load);
  const double a = std::cbrt(0.75 * load * radius / modulus);
  const double pressure = 1.5 * load / (std::numbers::pi * a * a);
  std::printf("ball on plate     computed   closed form\n");
  std::printf("radius a, um     %9.4f     %9.4f\n", 1e6 * ball.semi_major, 1e6 * a);
  std::printf("approach, um     %9.4f     %9.4f\n", 1e6 * ball.approach, 1e6 * a * a / radius);
  std::printf("peak, GPa        %9.4f     %9.4f\n", 1e-9 * ball.peak_pressure, 1e-9 * pressure);

  std::printf("\nratio of curvatures     b/a   peak, GPa\n");
  for (const double ratio : {1.0, 0.5, 0.1}) {
    const auto flank = contact::hertz_constants(ratio / radius, 1.0 / radius, modulus);
    std::printf("%19.1f  %6.4f  %10.4f\n", ratio, flank.ellipticity,
                1e-9 * contact::at_load(flank, load).peak_pressure);
  }
}

// Prints:
//
//     ball on plate     computed   closed form
//     radius a, um      148.1248      148.1248
//     approach, um        4.3882        4.3882
//     peak, GPa           2.1761        2.1761
//
//     ratio of curvatures     b/a   peak, GPa
//                     1.0  1.0000      2.1761
//                     0.5  0.6306      1.7501
//                     0.1  0.2222      1.1502
