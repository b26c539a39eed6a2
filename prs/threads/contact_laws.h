#pragma once

#include "prs/model/case.h"
#include "prs/threads/contact_law.h"
#include "prs/threads/contacts.h"

namespace prs {

/// Throws CaseError where an interface has no contact or, with materials, no Hertz contact: both
/// interfaces in one message.
void require_contacts(const Conditions& c, const Contacts& contacts);

/// Force law of an interface that has a Hertz contact, or all that replaces it; without teeth.
ContactLaw contact_law(const ContactOverrides& overrides, const InterfaceContact& contact,
                       Interface interface);

/// Force laws of both interfaces in the load distribution. The case's overrides come before the
/// geometry; the compliance of the teeth is added where the case asks for it. Throws CaseError for
/// interfaces whose geometry gives no Hertz contact and that are not overridden.
PerInterface<ContactLaw> contact_laws(const Conditions& c, const Contacts& contacts);

}  // namespace prs
