#include "prs/model/mechanism.h"

namespace prs {
namespace {

double lead_of(const Mechanism& m, Part part, double pitch) {
  if (part == Part::roller) return contact::roller_lead(m.type, m.lead, pitch, m.starts.roller);
  return std::copysign(pitch * m.starts.screw, m.lead);
}

double curvature_of(const Profile& profile, double pitch_radius, double flank_angle) {
  switch (profile.shape) {
    case Profile::Shape::convex:
      return 1.0 / profile.radius;
    case Profile::Shape::concave:
      return -1.0 / profile.radius;
    case Profile::Shape::centred:
      return std::sin(flank_angle) / pitch_radius;
    case Profile::Shape::straight:
      return 0.0;
  }
  return 0.0;
}

contact::Thread thread_of(const Mechanism& m, Part part, double pitch) {
  contact::Thread thread;
  thread.internal = part == Part::nut;
  thread.pitch_radius = 0.5 * m.pitch_diameter[part].value_or(0.0);
  thread.lead = lead_of(m, part, pitch);
  thread.pitch = pitch;
  thread.flank_angle = m.flank_angle[part];
  thread.profile_curvature = curvature_of(m.profile[part], thread.pitch_radius, thread.flank_angle);
  thread.plane =
      m.profile_plane == Mechanism::ProfilePlane::normal ? contact::ProfilePlane::normal : contact::ProfilePlane::axial;
  if (m.thread[part]) {
    thread.addendum = m.thread[part]->addendum;
    thread.dedendum = m.thread[part]->dedendum;
    thread.thickness = m.thread[part]->thickness;
  }
  return thread;
}

}  // namespace

PerPart<double> axial_pitches(const Mechanism& m) {
  const double nominal = axial_pitch(m);
  PerPart<double> pitches{nominal, nominal, nominal};
  for (const Part part : kParts) {
    if (!m.pitch[part]) continue;
    pitches[part] = *m.pitch[part];
    for (const double known : {nominal, pitches.screw, pitches.roller})
      if (contact::same_pitch(*m.pitch[part], known)) {
        pitches[part] = known;
        break;
      }
  }
  return pitches;
}

contact::MechanismGeometry threads_of(const Mechanism& m) {
  const PerPart<double> pitches = axial_pitches(m);
  return {m.type, thread_of(m, Part::screw, pitches.screw), thread_of(m, Part::roller, pitches.roller),
          thread_of(m, Part::nut, pitches.nut), m.centre_distance.value_or(0.0)};
}

}  // namespace prs
