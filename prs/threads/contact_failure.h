#pragma once

#include "contact/hertz.h"
#include "contact/mechanism_geometry.h"
#include "prs/model/part.h"
#include "prs/model/problems.h"

namespace prs {

/// Why an interface has no contact point, or, where it has one, no Hertz contact: the input to fix,
/// which surface, which limit, by how much.
Problem why_no_contact(const contact::MechanismGeometry& threads,
                       const contact::InterfaceGeometry& geometry, contact::HertzStatus hertz,
                       Interface interface);

/// "roller-screw" or "roller-nut".
const char* label(Interface interface);

/// The pair of threads of an interface.
contact::ThreadPair pair_of(const contact::MechanismGeometry& threads, Interface interface);

}  // namespace prs
