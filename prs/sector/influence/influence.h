#pragma once

#include "prs/sector/influence/contact_problem.h"
#include "prs/threads/contacts.h"

namespace prs {

/// Contact ellipse at a normal load, its axes taken as along the profile and around the axis,
/// whichever the major axis lies closer to. Needs `contact.has_hertz()`.
HertzPatch patch_at_load(const InterfaceContact& contact, double normal_load);

/// The ellipse with which flexibilities are worked out, whatever the loads are: its size drops out
/// with the half-space part. Peak pressure is 2 % of E*, 1/E* = (1 - nu^2)/E of both bodies, that
/// is 2.3 GPa for steel; a circle where the geometry gives no contact, of the sphere that
/// k_0 = 4/3 E* sqrt(R) asks for.
HertzPatch nominal_patch(const InterfaceContact& contact, const ContactLaw& law,
                         const Material& body, const Material& roller);

/// Flexibility of the three bodies of a roller screw for one direction of the load and one position
/// of the first contact on the nut.
struct BodyFlexibilities {
  Flexibility screw;
  Flexibility nut;
  Flexibility roller;

  Eigen::MatrixXd joined() const { return joined_flexibility(screw, nut, roller); }
};

/// The bodies are worked out at the same time where the cache does not hold them.
BodyFlexibilities body_flexibilities(const BodyGeometry& geometry, Direction direction,
                                     double position, const FlexibilityOptions& options,
                                     MatrixCache& cache = shared_matrix_cache());

}  // namespace prs
