#include "validation/jung_2017/measures.h"

#include "prs/life/capacity.h"
#include "prs/model/units.h"
#include "prs/threads/tooth_compliance.h"

namespace prs::jung_2017 {
namespace {

using std::numbers::pi;

constexpr double kContactAngle = pi / 4.0;
constexpr double kLead = kStarts * kPitch;
constexpr Material kSteel = {.youngs_modulus = 2.1e11, .poisson_ratio = 0.3, .density = {}};
constexpr double kDensity = 7850.0;

/// Table 3.1 prints 6.056 deg; with it four of the ten capacities of table 7.1 end in another
/// digit, with 6.054 deg none does.
constexpr double kPrintedHelixAngle = 6.054 * pi / 180.0;
/// Axial load of a thread, nowhere printed: the ten stiffnesses leave 1476 to 1509 N.
constexpr double kThreadLoad = 1500.0;

double square(double x) { return x * x; }

std::array<Diameters, 10> table(double (*roller)(int row, double screw)) {
  std::array<Diameters, 10> rows;
  for (int row = 0; row < 10; ++row) {
    Diameters& d = rows[static_cast<std::size_t>(row)];
    d.nut_outer = (54.0 + 3.0 * row) / per_si::millimetre;
    d.screw = 0.5 * d.nut_outer;
    d.roller = roller(row, d.screw);
  }
  return rows;
}

/// Lemor's factor at the ratio of the diameters; not a number outside its range.
double factor_of(const Diameters& d) {
  return geometry_factor(d.roller * std::cos(kContactAngle) / d.nut_inner()).value_or(std::nan(""));
}

double capacity(const Diameters& d, double helix_angle) {
  return lemor_capacity(factor_of(d), kContactAngle, kContacts,
                        rolling_element_diameter(kPitch, d.roller), helix_angle);
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

ThreadCompliance yamamoto(const Diameters& d, const ToothSection& tooth, double screw_width,
                          double nut_width) {
  const ToothDeflection screw = yamamoto_deflection(tooth, kSteel, d.screw);
  const ToothDeflection nut = yamamoto_deflection(tooth, kSteel, d.nut_inner(), d.nut_outer);
  ThreadCompliance c;
  c.teeth = (screw.total() - screw.radial) / screw_width + (nut.total() - nut.radial) / nut_width;
  c.screw_radial = screw.radial / screw_width;
  c.nut_radial = nut.radial / nut_width;
  return c;
}

}  // namespace

std::array<Diameters, 10> case_1() {
  return table([](int row, double) { return (9.0 + row) / per_si::millimetre; });
}

std::array<Diameters, 10> case_2() {
  return table([](int, double screw) { return screw / 3.0; });
}

ThreadCompliance compliance_as_printed(const Diameters& d) {
  constexpr double kWidth = 1e-3;
  const ToothSection tooth{.root_width = 7.0 / 8.0 * kPitch,
                           .pitch_width = kPitch / 2.0,
                           .height = kPitch / 8.0,
                           .flank_angle = kContactAngle,
                           .pitch = kLead};
  ThreadCompliance c = yamamoto(d, tooth, kWidth, kWidth);
  constexpr double kModulus = 4.333e-12, kApproach = 0.98;
  const auto approach = [](double sum) {  // (3.43), (3.44) [mm/N^(2/3)]
    sum /= per_si::millimetre;
    return kApproach * std::pow(1.5 * kModulus / sum, 2.0 / 3.0) * sum / 2.0;
  };
  const BothCurvatures rho = curvatures(d);
  const double axial = std::sin(kContactAngle) * std::cos(kPrintedHelixAngle);
  c.hertz = (approach(rho.nut.sum()) + approach(rho.screw.sum())) * std::cbrt(1.0 / kThreadLoad) *
            std::pow(axial, -5.0 / 3.0) / per_si::millimetre;
  return c;
}

Measures as_printed(const Diameters& d) {
  Measures m;
  const double outer = d.nut_outer, inner = d.nut_inner();
  m.nut_thickness = outer - inner;
  m.volume = pi * kLength *
             (square(outer) + square(d.screw) - square(inner) + kRollers * square(d.roller));
  m.stiffness = 1.0 / compliance_as_printed(d).total();
  m.load_capacity = capacity(d, kPrintedHelixAngle);
  // In mm and in this order: a weight of table 7.2 ends in a rounded 5.
  const double d_r = per_si::millimetre * d.roller, d_n = per_si::millimetre * outer;
  const double wall = d_n - per_si::millimetre * d.screw - 2.0 * d_r;
  m.weight = 0.006165 * square(d_r) * kRollers * kLength + 0.02466 * (d_n - wall) * wall * kLength;
  return m;
}

ThreadCompliance right_compliance(const Diameters& d) {
  const ToothSection tooth{.root_width = 7.0 / 8.0 * kPitch,
                           .pitch_width = kPitch / 2.0,
                           .height = 3.0 / 16.0 * kPitch,
                           .flank_angle = kContactAngle,
                           .pitch = kPitch};
  ThreadCompliance c = yamamoto(d, tooth, pi * d.screw / kRollers, pi * d.nut_inner() / kRollers);
  const double modulus = contact::contact_modulus(kSteel, kSteel);
  const auto approach = [&](const Curvatures& rho, double diameter) {
    const double axial = std::sin(kContactAngle) * std::cos(std::atan(kLead / (pi * diameter)));
    const contact::HertzContact contact = contact::at_load(
        contact::hertz_constants(rho.along, rho.across, modulus), kThreadLoad / axial);
    return contact.approach / axial;
  };
  const BothCurvatures rho = curvatures(d);
  c.hertz = (approach(rho.nut, d.nut_inner()) + approach(rho.screw, d.screw)) / kThreadLoad;
  return c;
}

Measures corrected(const Diameters& d) {
  Measures m;
  m.nut_thickness = 0.5 * (d.nut_outer - d.nut_inner());
  m.volume = 0.25 * pi * kLength *
             (square(d.nut_outer) - square(d.nut_inner()) + kRollers * square(d.roller));
  m.stiffness = 1.0 / right_compliance(d).total();
  m.load_capacity = capacity(d, std::atan(kLead / (pi * d.screw)));
  m.weight = kDensity * m.volume;
  return m;
}

}  // namespace prs::jung_2017
