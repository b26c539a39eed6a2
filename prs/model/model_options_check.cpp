#include "prs/model/block_checks.h"

#include <algorithm>

#include "prs/model/groove.h"
#include "prs/model/quantity_text.h"

namespace prs {
namespace {

/// A stated shoulder must meet a face of the nut at each thrust section.
void check_shoulder_meets_face(const Structure::Nut& nut, double bore, Problems& problems) {
  for (const std::optional<double>& section : {nut.thrust.tension, nut.thrust.compression}) {
    if (!section) continue;
    const auto [before, behind] = nut_diameters_at(nut, *section);
    const double outer = std::max(before, behind);
    const double inner = std::max(std::min(before, behind), bore);
    if (before == behind)
      problems.add("structure.nut.shoulder",
                   fmt::format("got a shoulder for the thrust section at {}, where the nut has no "
                               "face; expected a section at an end of the nut or at the face of a "
                               "flange; move the section or leave the shoulder out",
                               mm(*section)));
    else if (nut.shoulder->inner_diameter >= outer || nut.shoulder->outer_diameter <= inner)
      problems.add("structure.nut.shoulder",
                   fmt::format("got {} to {}; expected diameters that meet the face at {}, {} to "
                               "{}; change them",
                               mm(nut.shoulder->inner_diameter), mm(nut.shoulder->outer_diameter),
                               mm(*section), mm(inner), mm(outer)));
  }
}

/// Least wall below the roots that `influence` can mesh, in pitches.
constexpr double kLeastMeshedWall = 0.42;

/// Walls outside the thread: `refined`, whose roots may be less deep there, counts them from the
/// pitch diameter, `influence` from the roots.
void check_nut_walls(const Structure::Nut& nut, double pitch_diameter, double dedendum,
                     double pitch, bool meshed, Problems& problems) {
  const double inner = pitch_diameter + (meshed ? 2.0 * dedendum : 0.0);
  const double pitches = meshed ? kLeastMeshedWall : kLeastWall;
  const double least = inner + 2.0 * pitches * pitch;
  // Paths are made where they are told alone: studies check each design.
  const auto check = [&](auto path, double outer, std::string_view what) {
    if (outer < least)
      problems.add(path(),
                   fmt::format("got {}; expected at least {} for `bodies: {}`, {} pitches of wall "
                               "outside the {} of the thread; widen the {}",
                               mm(outer), mm(least), meshed ? "influence" : "refined", pitches,
                               meshed ? "roots" : "pitch line", what));
  };
  check([] { return "structure.nut.outer_diameter"; }, nut.outer_diameter, "nut");
  for (std::size_t i = 0; i < nut.flanges.size(); ++i)
    check([&] { return fmt::format("structure.nut.flanges[{}].outer_diameter", i); },
          nut.flanges[i].outer_diameter, "flange");
}

/// Teeth and walls as `refined` and `influence` need them.
void check_threaded_walls(const Case& c, std::string_view bodies, Problems& problems) {
  const Mechanism& m = c.mechanism;
  const bool meshed = c.model.bodies == ModelOptions::Bodies::influence;
  const double pitch = axial_pitch(m);
  for (const Part part : kParts) {
    const std::optional<double>& diameter = m.pitch_diameter[part];
    if (!diameter) continue;
    const double flank = m.flank_angle[part];
    // Flanks that meet end the thread.
    const double sharp = sharp_height(pitch, flank);
    const double least = meshed ? 0.03 * pitch : 0.0;
    if (m.thread[part]) {
      const std::pair<const char*, double> heights[] = {{"addendum", m.thread[part]->addendum},
                                                        {"dedendum", m.thread[part]->dedendum}};
      for (const auto& [key, height] : heights)
        if (height < least || height >= 0.98 * sharp)
          problems.add(fmt::format("mechanism.thread.{}.{}", name(part), key),
                       fmt::format("got {}; expected {} to {} for `bodies: {}`, where the flanks "
                                   "have not met; change it",
                                   mm(height), mm(least), mm(0.98 * sharp), bodies));
    }
    if (!c.structure) continue;
    const double dedendum =
        m.thread[part] ? m.thread[part]->dedendum
                       : default_groove(part == Part::nut, pitch, 0.0, flank, flank).dedendum;
    if (part == Part::nut) {
      check_nut_walls(c.structure->nut, *diameter, dedendum, pitch, meshed, problems);
      continue;
    }
    const double root = 0.5 * *diameter - dedendum;
    const double wall = root - (part == Part::screw ? 0.5 * c.structure->screw.bore : 0.0);
    const double thinnest = (meshed ? kLeastMeshedWall : kLeastWall) * pitch;
    if (wall < thinnest)
      problems.add(
          part == Part::screw ? "structure.screw.bore" : "mechanism.pitch_diameter.roller",
          fmt::format("leaves a wall of {} below the threads, whose root lies at a diameter of {}; "
                      "expected at least {} for `bodies: {}`; change it or take `bodies: bars`",
                      mm(wall), mm(2.0 * root), mm(thinnest), bodies));
  }
}

}  // namespace

void check_bodies(const Case& c, Problems& problems) {
  using enum ModelOptions::Bodies;
  const ModelOptions& model = c.model;
  const double width = model.tooth_compliance.width;
  const double least = 0.02 * axial_pitch(c.mechanism);
  if (model.tooth_compliance.kind == ModelOptions::ToothCompliance::Kind::yamamoto && width < least)
    problems.add("model.tooth_compliance.yamamoto",
                 fmt::format("got {}; expected at least {}, 2 % of the pitch; check the unit",
                             mm(width), mm(least)));
  if (model.bodies == bars) return;
  const std::string_view bodies = model.bodies == refined ? "refined" : "influence";
  if (model.bodies == influence && c.mechanism.rollers < 2)
    problems.add("mechanism.rollers",
                 "got 1 with `bodies: influence`, where rollers around the screw hold it in the "
                 "middle; expected at least 2; take `bodies: bars` for one roller");
  if (model.bodies == influence && model.roller == ModelOptions::Roller::rigid_bending)
    problems.add("model.roller",
                 "got `rigid_bending` with `bodies: influence`, whose rollers bend; expected "
                 "`flexible`; take `bodies: bars` or `refined` for rollers that stay straight");
  if (!knows_friction(model) && model.loads == ModelOptions::Loads::running)
    problems.add("model.loads",
                 "got `running` with `bodies: influence` and all rollers, which take no friction; "
                 "expected `static`; take `bodies: bars` or `refined` for running loads");
  if (model.roller_shear)
    problems.add("model.roller_shear",
                 fmt::format("got `true` with `bodies: {}`, which has it anyway; expected it with "
                             "`bodies: bars` only; remove it",
                             bodies));
  check_threaded_walls(c, bodies, problems);
  if (c.structure && c.structure->nut.shoulder)
    check_shoulder_meets_face(c.structure->nut, c.mechanism.pitch_diameter.nut.value_or(0.0),
                              problems);
}

void check_thickness(const Case& c, Problems& problems) {
  if (c.model.bodies == ModelOptions::Bodies::bars) return;
  for (const Part part : kParts)
    if (const auto& thread = c.mechanism.thread[part]; thread && thread->thickness)
      problems.add(fmt::format("mechanism.thread.{}.thickness", name(part)),
                   fmt::format("got {}; expected none with `model.bodies` other than bars, whose "
                               "teeth are half a pitch thick; delete it, or write `bodies: bars`",
                               mm(*thread->thickness)));
}

}  // namespace prs
