#include "prs/model/block_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "prs/model/quantity_text.h"

namespace prs {
namespace {

/// Whether threads can reach each other across the gap between two pitch cylinders: sharp threads
/// are half a pitch over the tangent of the flank angle high.
void check_reach(const Mechanism& m, Problems& problems) {
  const auto& [screw, roller, nut] = m.pitch_diameter;
  if (!screw || !roller || !nut || !m.centre_distance) return;
  const double screw_gap = *m.centre_distance - 0.5 * (*screw + *roller);
  const double nut_gap = 0.5 * *nut - (*m.centre_distance + 0.5 * *roller);
  const double least_reach = 0.5 * axial_pitch(m);
  if (std::abs(screw_gap) <= least_reach && std::abs(nut_gap) <= least_reach) return;
  const double flank = std::min({m.flank_angle.screw, m.flank_angle.roller, m.flank_angle.nut});
  const double reach = least_reach * std::max(1.0, 1.0 / std::tan(flank));
  if (std::abs(screw_gap) > reach)
    problems.add("mechanism.centre_distance",
                 fmt::format("got {}; expected {}, the sum of the pitch radii of screw and roller, "
                             "give or take {}, or their threads cannot mesh; check centre distance "
                             "and pitch diameters",
                             mm(*m.centre_distance), mm(0.5 * (*screw + *roller)), mm(reach)));
  if (std::abs(nut_gap) > reach)
    problems.add(
        "mechanism.pitch_diameter.nut",
        fmt::format("got {}; expected {}, twice the centre distance and the roller's pitch "
                    "radius, give or take {}, or their threads cannot mesh; check centre "
                    "distance and pitch diameters",
                    mm(*nut), mm(2.0 * *m.centre_distance + *roller), mm(2.0 * reach)));
}

/// Neighbouring rollers must clear each other: 2 c sin(pi / n) > d.
void check_rollers(const Mechanism& m, Problems& problems) {
  if (!m.centre_distance || !m.pitch_diameter.roller || m.rollers < 2) return;
  const double distance = 2.0 * *m.centre_distance;
  const double diameter = *m.pitch_diameter.roller;
  const auto overlap = [&](int n) {
    return n > 1 && distance * std::sin(std::numbers::pi / n) <= diameter;
  };
  if (!overlap(m.rollers)) return;
  int most = m.rollers;
  while (overlap(most)) --most;
  problems.add("mechanism.rollers",
               fmt::format("got {}; expected at most {}: more rollers of {} overlap at the centre "
                           "distance of {}; take fewer",
                           m.rollers, most, mm(diameter), mm(*m.centre_distance)));
}

}  // namespace

void check_threads(const Mechanism& m, Problems& problems) {
  const double pitch = axial_pitch(m);
  for (Part part : kParts) {
    const std::optional<double>& diameter = m.pitch_diameter[part];
    if (diameter && pitch > 2.0 * *diameter)
      problems.add(
          "mechanism.lead",
          fmt::format("got {} with {} starts, an axial pitch of {}; expected a pitch of at "
                      "most twice each pitch diameter, one of which is {}; check the units",
                      mm(m.lead), m.starts.screw, mm(pitch), mm(*diameter)));
    if (m.profile[part].shape == Profile::Shape::centred && (part == Part::nut || !diameter))
      problems.add(
          fmt::format("mechanism.profile.{}", name(part)),
          fmt::format("got centred, an arc about the axis; expected it of {}; write the arc's "
                      "radius, for example `{{convex: 6 mm}}`",
                      part == Part::nut ? "screw or roller" : "a part with a pitch diameter"));
    if (m.pitch[part] && std::abs(*m.pitch[part] / pitch - 1.0) > 0.5)
      problems.add(
          fmt::format("mechanism.pitch.{}", name(part)),
          fmt::format("got {}; expected a measured pitch near lead / starts, {}; check the "
                      "units",
                      mm(*m.pitch[part]), mm(pitch)));
  }
}

void check_meshing(const Mechanism& m, Problems& problems) {
  check_reach(m, problems);
  check_rollers(m, problems);
}

}  // namespace prs
