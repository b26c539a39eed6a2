#pragma once

#include <span>
#include <string>
#include <vector>

#include "prs/model/case.h"
#include "prs/threads/contacts.h"

namespace prs {

/// Warnings on geometry that is possible but unusual: first on the contacts, then on the bodies
/// around them and the faces that hold the nut. Each is a sentence with the numbers.
std::vector<std::string> geometry_warnings(const Conditions& c, const Contacts& contacts,
                                           std::span<const LoadCase> loads);

}  // namespace prs
