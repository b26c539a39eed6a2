#pragma once

#include <span>
#include <string>
#include <vector>

#include "prs/model/case.h"
#include "prs/threads/contacts.h"

namespace prs {

/// What is possible and unusual: the warnings of the contacts, then those of the bodies around them
/// and of the faces that hold the nut under the loads; each a sentence with the numbers.
std::vector<std::string> geometry_warnings(const Conditions& c, const Contacts& contacts,
                                           std::span<const LoadCase> loads);

}  // namespace prs
