#pragma once

#include "prs/contacts.h"
#include "prs/influence/contact_problem.h"
#include "prs/influence/flexibility.h"

namespace prs {

/// Contact ellipse at a normal load, its axes taken as along the profile and around the axis,
/// whichever the major axis lies closer to. Needs `contact.has_hertz()`.
HertzPatch patch_at_load(const InterfaceContact& contact, double normal_load);

/// Flexibility of the three bodies of a roller screw for one direction of the load and one position
/// of the first contact on the nut.
struct BodyFlexibilities {
  Flexibility screw;
  Flexibility nut;
  Flexibility roller;

  Eigen::MatrixXd joined() const { return joined_flexibility(screw, nut, roller); }
};

BodyFlexibilities body_flexibilities(const BodyGeometry& geometry, Direction direction,
                                     double position, const FlexibilityOptions& options);

}  // namespace prs
