#include "prs/threads/contact_laws.h"

#include "prs/threads/tooth_compliance.h"

namespace prs {
namespace {

void require(const Contacts& contacts, const PerInterface<bool>& lacks, std::string_view fix) {
  std::string path, message;
  for (const Interface i : kInterfaces) {
    if (!lacks[i]) continue;
    const Problem why = failure(contacts, i);
    if (path.empty()) path = why.path;
    message += fmt::format("the {} threads give no Hertz contact: {}; ", label(i), why.message);
  }
  if (!path.empty()) throw CaseError(path, message.append(fix));
}

}  // namespace

void require_contacts(const Conditions& c, const Contacts& contacts) {
  PerInterface<bool> lacks;
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = contacts.interfaces[i];
    lacks[i] = !contact.geometry.ok() || (c.materials && !contact.hertz.ok());
  }
  require(contacts, lacks, "fix profiles, flank angles or diameters");
}

ContactLaw contact_law(const ContactOverrides& overrides, const InterfaceContact& contact,
                       Interface i) {
  return {overrides.hertz_constant[i].value_or(contact.hertz.hertz_constant),
          overrides.normal_angle[i] ? *overrides.normal_angle[i] : contact.normal_angle()};
}

PerInterface<ContactLaw> contact_laws(const Conditions& c, const Contacts& contacts) {
  PerInterface<bool> lacks;
  for (const Interface i : kInterfaces)
    lacks[i] = !contacts.interfaces[i].has_hertz() &&
               !(c.contact.hertz_constant[i] && c.contact.normal_angle[i]);
  require(contacts, lacks,
          "fix profiles, flank angles or diameters, or give both "
          "contact.hertz_constant and contact.normal_angle of the interface");
  PerInterface<ContactLaw> laws;
  for (const Interface i : kInterfaces) laws[i] = contact_law(c.contact, contacts.interfaces[i], i);
  if (c.structure &&
      c.model.tooth_compliance.kind == ModelOptions::ToothCompliance::Kind::yamamoto) {
    const PerInterface<double> teeth = yamamoto_compliance(
        contacts.mechanism, *c.structure, *c.materials,
        {laws.screw.normal_angle, laws.nut.normal_angle}, c.model.tooth_compliance.width);
    for (const Interface i : kInterfaces) laws[i].compliance = teeth[i];
  }
  return laws;
}

}  // namespace prs
