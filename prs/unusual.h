#pragma once

#include <string>
#include <vector>

#include "prs/case.h"
#include "prs/contacts.h"

namespace prs {

/// What is possible and unusual in a case: each a sentence with the numbers. The warnings of its
/// contacts come first.
std::vector<std::string> unusual_geometry(const Case& c, const Contacts& contacts);

}  // namespace prs
