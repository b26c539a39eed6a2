#include "prs/threads.h"

#include <fmt/format.h>

#include <cmath>

#include "prs/case_error.h"

namespace prs {
namespace {

contact::MechanismType type_of(const Mechanism& m) {
  return m.type == Mechanism::Type::standard ? contact::MechanismType::standard
                                             : contact::MechanismType::inverted;
}

double pitch_of(const Mechanism& m, Part part) { return m.pitch[part].value_or(axial_pitch(m)); }

double lead_of(const Mechanism& m, Part part) {
  if (part == Part::roller)
    return contact::roller_lead(type_of(m), m.lead, pitch_of(m, part), m.starts.roller);
  return std::copysign(pitch_of(m, part) * m.starts.screw, m.lead);
}

double curvature_of(const Profile& profile) {
  switch (profile.shape) {
    case Profile::Shape::convex:
      return 1.0 / profile.radius;
    case Profile::Shape::concave:
      return -1.0 / profile.radius;
    case Profile::Shape::straight:
      return 0.0;
  }
  return 0.0;
}

contact::Thread thread_of(const Mechanism& m, Part part) {
  contact::Thread thread;
  thread.internal = part == Part::nut;
  thread.pitch_radius = 0.5 * m.pitch_diameter[part].value_or(0.0);
  thread.lead = lead_of(m, part);
  thread.pitch = pitch_of(m, part);
  thread.flank_angle = m.flank_angle[part];
  thread.profile_curvature = curvature_of(m.profile[part]);
  thread.plane = m.profile_plane == Mechanism::ProfilePlane::normal ? contact::ProfilePlane::normal
                                                                    : contact::ProfilePlane::axial;
  if (m.thread[part]) {
    thread.addendum = m.thread[part]->addendum;
    thread.dedendum = m.thread[part]->dedendum;
  }
  return thread;
}

}  // namespace

contact::MechanismGeometry threads_of(const Mechanism& m) {
  return {type_of(m), thread_of(m, Part::screw), thread_of(m, Part::roller),
          thread_of(m, Part::nut), m.centre_distance.value_or(0.0)};
}

Mechanism resolved(const Mechanism& m) {
  if (m.geometry == Mechanism::Geometry::simulation) return m;
  const contact::DesignResult design = contact::design_by_backlash(
      threads_of(m), m.starts.screw, m.starts.roller, {m.backlash.screw, m.backlash.nut});
  if (!design.ok())
    throw CaseError("mechanism.backlash",
                    fmt::format("no mechanism with this screw has the backlash wanted: {}; give "
                                "other diameters, starts or profiles, or the radii themselves with "
                                "`geometry: simulation`",
                                contact::name(design.status)));
  Mechanism designed = m;
  designed.pitch_diameter.screw = 2.0 * design.mechanism.screw.pitch_radius;
  designed.pitch_diameter.roller = 2.0 * design.mechanism.roller.pitch_radius;
  designed.pitch_diameter.nut = 2.0 * design.mechanism.nut.pitch_radius;
  designed.centre_distance = design.mechanism.centre_distance;
  return designed;
}

}  // namespace prs
