#include "prs/summary.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "prs/threads.h"

namespace prs {
namespace {

constexpr double kMillimetre = 1e-3;

/// Radial distance by which the pitch cylinders of an interface miss each other, overlap < 0 [m].
double pitch_cylinder_gap(const Mechanism& m, Interface i) {
  const double c = *m.centre_distance, roller = 0.5 * *m.pitch_diameter.roller;
  return i == Interface::screw ? c - roller - 0.5 * *m.pitch_diameter.screw
                               : 0.5 * *m.pitch_diameter.nut - roller - c;
}

void note_pitch_cylinders(const Mechanism& m, std::vector<std::string>& notes) {
  for (const Interface i : kInterfaces) {
    const double gap = pitch_cylinder_gap(m, i);
    if (std::abs(gap) > 1e-3 * axial_pitch(m))
      notes.push_back(fmt::format("the pitch cylinders of roller and {} {} by {:.4f} mm",
                                  i == Interface::screw ? "screw" : "nut",
                                  gap > 0 ? "miss each other" : "overlap",
                                  std::abs(gap) / kMillimetre));
  }
}

/// The roller keeps its axial place on the part whose helix angle it shares.
void note_roller_migration(const Mechanism& m, std::vector<std::string>& notes) {
  const Part fixed = m.type == Mechanism::Type::standard ? Part::nut : Part::screw;
  const double diameters = *m.pitch_diameter[fixed] / *m.pitch_diameter.roller;
  const double starts = static_cast<double>(m.starts.screw) / m.starts.roller;
  if (std::abs(diameters / starts - 1.0) > 1e-3)
    notes.push_back(fmt::format(
        "the rollers migrate along the {}: its pitch diameter is {:.4f} times the roller's, the "
        "starts ask for {:g}",
        fixed == Part::nut ? "nut" : "screw", diameters, starts));
}

void note_proportions(const Case& c, std::vector<std::string>& notes) {
  const Mechanism& m = c.mechanism;
  if (m.rollers < 3)
    notes.push_back(
        fmt::format("{} roller{} cannot centre the screw", m.rollers, m.rollers == 1 ? "" : "s"));
  for (const Part p : kParts)
    if (m.flank_angle[p] < 20 * std::numbers::pi / 180 ||
        m.flank_angle[p] > 70 * std::numbers::pi / 180)
      notes.push_back(fmt::format("a flank angle of {:g} deg is far from the usual 45 deg",
                                  m.flank_angle[p] * 180 / std::numbers::pi));
  if (!c.structure) return;
  const Structure& s = *c.structure;
  if (s.screw.bore > 0.8 * *m.pitch_diameter.screw)
    notes.push_back(fmt::format("the screw's bore leaves a wall of {:.2f} mm at the pitch diameter",
                                0.5 * (*m.pitch_diameter.screw - s.screw.bore) / kMillimetre));
  if (s.roller.end_diameter > *m.pitch_diameter.roller)
    notes.push_back(fmt::format("the roller's ends ({:g} mm) are thicker than its thread ({:g} mm)",
                                s.roller.end_diameter / kMillimetre,
                                *m.pitch_diameter.roller / kMillimetre));
}

}  // namespace

MechanismSummary summarize(const Mechanism& m) {
  MechanismSummary s;
  s.axial_pitch = axial_pitch(m);
  s.contact_length = (m.contacts_per_roller - 1) * s.axial_pitch;
  const contact::MechanismGeometry threads = threads_of(m);
  const auto helix_angle = [](const contact::Thread& thread) {
    return contact::ThreadSurface(thread).helix_angle();
  };
  s.helix_angle = {helix_angle(threads.screw), helix_angle(threads.roller),
                   helix_angle(threads.nut)};
  const double c = *m.centre_distance;
  s.roller_spacing = m.rollers > 1 ? 2.0 * c * std::sin(std::numbers::pi / m.rollers) : 0.0;
  s.rollers_that_fit = contact::largest_roller_count(threads);
  return s;
}

std::vector<std::string> unusual_geometry(const Case& c) {
  std::vector<std::string> notes;
  note_pitch_cylinders(c.mechanism, notes);
  note_roller_migration(c.mechanism, notes);
  note_proportions(c, notes);
  return notes;
}

}  // namespace prs
