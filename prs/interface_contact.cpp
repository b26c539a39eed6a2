#include "prs/interface_contact.h"

#include <fmt/format.h>

#include "prs/threads.h"

namespace prs {
namespace {

contact::Elasticity elasticity(const Material& m) { return {m.youngs_modulus, m.poisson_ratio}; }

}  // namespace

const char* label(Interface i) { return i == Interface::screw ? "roller-screw" : "roller-nut"; }

PerInterface<InterfaceContact> interface_contacts(const Mechanism& resolved,
                                                  const std::optional<Materials>& materials) {
  const contact::MechanismContact geometry =
      contact::mechanism_contact(threads_of(resolved), contact::Configuration::i1_j2);
  PerInterface<InterfaceContact> contacts{{geometry.screw, {}}, {geometry.nut, {}}};
  if (!materials) return contacts;
  for (const Interface i : kInterfaces) {
    InterfaceContact& c = contacts[i];
    if (!c.geometry.ok()) continue;
    c.hertz =
        contact::hertz_constants(c.geometry.relative.first, c.geometry.relative.second,
                                 contact::contact_modulus(elasticity((*materials)[body_of(i)]),
                                                          elasticity(materials->roller)));
  }
  return contacts;
}

std::string failure(const InterfaceContact& c, Interface i) {
  const contact::ContactPoint& point = c.geometry.point;
  if (point.ok()) return std::string(contact::name(c.hertz.status));
  std::string text(contact::name(point.status));
  const char* separator = ": ";
  for (const contact::FlankViolation& v : point.violations) {
    const char* part = v.of_roller ? "roller" : i == Interface::screw ? "screw" : "nut";
    text += fmt::format("{}{:.4f} mm beyond the {} of the {}", separator, v.by * 1e3,
                        contact::name(v.end), part);
    separator = ", ";
  }
  return text;
}

}  // namespace prs
