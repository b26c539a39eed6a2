#include "prs/sector/influence/influence.h"

#include <cmath>
#include <future>
#include <numbers>

namespace prs {
namespace {

constexpr double kNominalPressure = 0.02;  ///< Over E*.

}  // namespace

HertzPatch patch_at_load(const InterfaceContact& contact, double normal_load) {
  const contact::HertzContact at = contact::at_load(contact.hertz, normal_load);
  const contact::InterfaceGeometry& g = contact.geometry;
  const double along_helix = std::abs(g.major_axis.dot(g.helix_tangent));
  const bool major_around_axis = along_helix > 0.5 * std::numbers::sqrt2;
  return major_around_axis ? HertzPatch{at.semi_minor, at.semi_major}
                           : HertzPatch{at.semi_major, at.semi_minor};
}

HertzPatch nominal_patch(const InterfaceContact& contact, const ContactLaw& law,
                         const Material& body, const Material& roller) {
  const double modulus = contact::contact_modulus(body, roller);
  if (contact.has_hertz()) {
    const double at_one_newton = contact::at_load(contact.hertz, 1.0).peak_pressure;
    return patch_at_load(contact, std::pow(kNominalPressure * modulus / at_one_newton, 3.0));
  }
  const double root = 0.75 * law.hertz_constant / modulus;
  const double radius = 0.5 * std::numbers::pi * kNominalPressure * root * root;
  return {radius, radius};
}

BodyFlexibilities body_flexibilities(const BodyGeometry& geometry, Direction direction,
                                     double position, const FlexibilityOptions& options,
                                     MatrixCache& cache) {
#ifdef __EMSCRIPTEN__
  constexpr auto when = std::launch::deferred;  // It has no threads.
#else
  constexpr auto when = std::launch::async | std::launch::deferred;
#endif
  auto roller =
      std::async(when, [&] { return roller_flexibility(geometry, direction, options, cache); });
  Flexibility screw = screw_flexibility(geometry, direction, options, cache);
  Flexibility nut = nut_flexibility(geometry, direction, position, options, cache);
  return {std::move(screw), std::move(nut), roller.get()};
}

}  // namespace prs
