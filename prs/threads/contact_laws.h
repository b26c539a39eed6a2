#pragma once

#include <string_view>

#include "prs/model/case.h"
#include "prs/threads/contact_law.h"
#include "prs/threads/contacts.h"

namespace prs {

/// Throws CaseError where an interface `lacks` a contact, both in one message; `mend` says how.
void require_contacts(const Contacts& contacts, const PerInterface<bool>& lacks,
                      std::string_view mend);

/// What the load distribution uses at both interfaces: the case's overrides before the geometry,
/// and the compliance of the teeth where the case asks for it. Throws CaseError for interfaces
/// whose geometry gives no Hertz contact and that are not overridden.
PerInterface<ContactLaw> contact_laws(const Case& c, const Contacts& contacts);

}  // namespace prs
