#include "prs/configurations/heat_estimate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prs {
namespace {

constexpr double kPi = std::numbers::pi;

double of_nut(const Structure::Nut& nut, double bore) {
  const double d = nut.outer_diameter;
  return kStillAir * (kPi * d * nut.length + 0.5 * kPi * (d * d - bore * bore));
}

double of_shaft(double diameter, double length) {
  const double perimeter = kPi * diameter, area = 0.25 * kPi * diameter * diameter;
  const double rate = std::sqrt(kStillAir * perimeter / (kSteelConductivity * area));
  return kSteelConductivity * area * rate * std::tanh(rate * length);
}

}  // namespace

Heat::Conductance estimated_conductance(const CompleteScrew& s, double shaft_length) {
  const Contacts contacts = find_contacts(s.c.mechanism, s.c.materials);
  const Mechanism& m = contacts.mechanism;
  const double count = static_cast<double>(m.rollers) * m.contacts_per_roller;
  const auto spots = [&](Interface i) {
    const InterfaceContact& contact = contacts.interfaces[i];
    const contact::HertzContact e =
        contact::at_load(contact.hertz, s.load / count / std::cos(contact.normal_angle()));
    return count * 2.0 * kSteelConductivity * std::sqrt(e.semi_major * e.semi_minor);
  };
  const Structure::Nut& nut = s.c.structure->nut;
  const double beyond = std::max(0.5 * (shaft_length - nut.length), 0.0);
  return {.screw_ambient = 2.0 * of_shaft(s.data.screw_diameter, beyond),
          .nut_ambient = of_nut(nut, s.pitch_diameter.nut),
          .screw_rollers = spots(Interface::screw),
          .rollers_nut = spots(Interface::nut)};
}

}  // namespace prs
