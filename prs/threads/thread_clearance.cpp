#include "prs/threads/thread_clearance.h"

namespace prs {
namespace {

bool has_heights(const contact::Thread& t) { return t.addendum && t.dedendum; }

double crest_radius(const contact::Thread& t) {
  return t.internal ? t.pitch_radius - *t.addendum : t.pitch_radius + *t.addendum;
}

double root_radius(const contact::Thread& t) {
  return t.internal ? t.pitch_radius + *t.dedendum : t.pitch_radius - *t.dedendum;
}

/// Half the groove of the material at a radius, phi in Yao 2023, (2) to (4) [m].
std::optional<double> half_groove(const contact::ThreadSurface& s, double radius) {
  if (!s.exists_at(radius)) return std::nullopt;
  const double f = s.profile(radius).height;
  return s.side > 0.0 ? f : 0.5 * s.pitch - f;
}

std::optional<double> width(const contact::ThreadSurface& s, double radius) {
  const std::optional<double> groove = half_groove(s, radius);
  return groove ? std::optional(s.pitch - 2.0 * *groove) : std::nullopt;
}

/// From the edge of a crest to the flank of the other part at that radius of it [m].
std::optional<double> crest_clearance(const contact::Thread& crest, const contact::Thread& flank,
                                      double radius_on_flank) {
  const std::optional<double> thread = width(contact::ThreadSurface(crest), crest_radius(crest));
  const std::optional<double> groove = half_groove(contact::ThreadSurface(flank), radius_on_flank);
  return thread && groove ? std::optional(*groove - 0.5 * *thread) : std::nullopt;
}

}  // namespace

std::optional<ThreadWidths> thread_widths(const contact::Thread& thread) {
  if (!has_heights(thread)) return std::nullopt;
  const contact::ThreadSurface surface(thread);
  return ThreadWidths{width(surface, crest_radius(thread)), width(surface, root_radius(thread))};
}

std::optional<ThreadClearance> thread_clearance(const contact::MechanismGeometry& threads,
                                                Interface interface,
                                                const contact::ContactPoint& point) {
  const contact::Thread& body = interface == Interface::screw ? threads.screw : threads.nut;
  const contact::Thread& roller = threads.roller;
  if (!point.ok() || !has_heights(body) || !has_heights(roller) ||
      !contact::same_pitch(body, roller))
    return std::nullopt;
  // The roller stands outside the screw and inside the nut.
  const double towards_body = interface == Interface::screw ? -1.0 : 1.0;
  const double c = threads.centre_distance;
  return ThreadClearance{
      .flank = 0.5 * point.backlash,
      .body_crest = crest_clearance(body, roller, towards_body * (crest_radius(body) - c)),
      .roller_crest = crest_clearance(roller, body, c + towards_body * crest_radius(roller)),
  };
}

}  // namespace prs
