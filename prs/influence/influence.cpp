#include "prs/influence/influence.h"

#include <cmath>
#include <numbers>

namespace prs {

HertzPatch patch_at_load(const InterfaceContact& contact, double normal_load) {
  const contact::HertzContact at = contact::at_load(contact.hertz, normal_load);
  const contact::InterfaceGeometry& g = contact.geometry;
  const double along_helix = std::abs(g.major_axis.dot(g.helix_tangent));
  const bool major_around_axis = along_helix > 0.5 * std::numbers::sqrt2;
  return major_around_axis ? HertzPatch{at.semi_minor, at.semi_major}
                           : HertzPatch{at.semi_major, at.semi_minor};
}

BodyFlexibilities body_flexibilities(const BodyGeometry& geometry, Direction direction,
                                     double position, const FlexibilityOptions& options) {
  return {screw_flexibility(geometry, direction, options),
          nut_flexibility(geometry, direction, position, options),
          roller_flexibility(geometry, direction, options)};
}

}  // namespace prs
