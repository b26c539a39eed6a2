#pragma once

#include <string>

#include "contact/hertz.h"
#include "contact/mechanism_geometry.h"
#include "prs/model/part.h"

namespace prs {

/// Problem of a contact, and the input to fix.
struct ContactFailure {
  std::string path;
  std::string reason;  ///< Which surface, which limit, by how much.
};

/// Why an interface has no contact point, or, where it has one, no Hertz contact.
ContactFailure why_no_contact(const contact::MechanismGeometry& threads,
                              const contact::InterfaceGeometry& geometry,
                              contact::HertzStatus hertz, Interface interface);

/// "roller-screw" or "roller-nut".
const char* label(Interface interface);

/// The pair of threads of an interface.
contact::ThreadPair pair_of(const contact::MechanismGeometry& threads, Interface interface);

}  // namespace prs
