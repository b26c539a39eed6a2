#pragma once

#include <string>
#include <vector>

#include "prs/model/case.h"
#include "prs/threads/contacts.h"

namespace prs {

/// What is possible and unusual in a case beyond the warnings of its contacts: each a sentence with
/// the numbers.
std::vector<std::string> unusual_geometry(const Case& c, const Contacts& contacts);

}  // namespace prs
