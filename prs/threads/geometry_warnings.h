#pragma once

#include <span>
#include <string>
#include <vector>

#include "prs/model/case.h"
#include "prs/threads/contacts.h"

namespace prs {

/// Warnings on geometry that is possible but unusual: first on the contacts, then on the bodies
/// around them, the faces that hold the nut, and the speed that the geometry stands. Each names the
/// key, then says in a sentence with the numbers what is unusual. Values that are odd by themselves
/// have a table of their own, input/usual_values.cpp.
std::vector<std::string> geometry_warnings(const Conditions& c, const Contacts& contacts,
                                           std::span<const LoadCase> loads);

}  // namespace prs
