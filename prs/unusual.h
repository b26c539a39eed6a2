#pragma once

#include <string>
#include <vector>

#include "prs/case.h"
#include "prs/contacts.h"

namespace prs {

/// What is possible and unusual in a case beyond the warnings of its contacts: each a sentence with
/// the numbers.
std::vector<std::string> unusual_geometry(const Case& c, const Contacts& contacts);

}  // namespace prs
