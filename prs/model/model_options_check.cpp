#include "prs/model/model_options_check.h"

#include <algorithm>

#include "prs/model/groove.h"
#include "prs/model/quantity_text.h"
#include "prs/model/structure_check.h"

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
                               mm(nut.shoulder->inner_diameter), mm(nut.shoulder->outer_diameter), mm(*section),
                               mm(inner), mm(outer)));
  }
}

/// Least wall below the roots that can be meshed, in pitches.
constexpr double kLeastMeshedWall = 0.42;

/// Walls outside the thread: meshes count them from the roots, others, whose roots may be less deep there, from the
/// pitch diameter.
void check_nut_walls(const Structure::Nut& nut, double pitch_diameter, double dedendum, double pitch,
                     const BodyModel& bodies, Problems& problems) {
  const bool meshed = bodies.meshes;
  const double inner = pitch_diameter + (meshed ? 2.0 * dedendum : 0.0);
  const double pitches = meshed ? kLeastMeshedWall : kLeastWall;
  const double least = inner + 2.0 * pitches * pitch;
  // Paths are built for an error only: studies check each design.
  const auto check = [&](auto path, double outer, std::string_view what) {
    if (outer < least)
      problems.add(path(),
                   fmt::format("got {}; expected at least {} for `bodies: {}`, {} pitches of wall "
                               "outside the {} of the thread; widen the {}",
                               mm(outer), mm(least), bodies.name, pitches, meshed ? "roots" : "pitch line", what));
  };
  check([] { return "structure.nut.outer_diameter"; }, nut.outer_diameter, "nut");
  for (std::size_t i = 0; i < nut.flanges.size(); ++i)
    check([&] { return fmt::format("structure.nut.flanges[{}].outer_diameter", i); }, nut.flanges[i].outer_diameter,
          "flange");
}

/// Teeth and walls of models with grooves.
void check_threaded_walls(const Case& c, Problems& problems) {
  const BodyModel& bodies = *c.model.bodies;
  const Mechanism& m = c.mechanism;
  const bool meshed = bodies.meshes;
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
                                   mm(height), mm(least), mm(0.98 * sharp), bodies.name));
    }
    if (!c.structure) continue;
    const double dedendum = m.thread[part] ? m.thread[part]->dedendum
                                           : default_groove(part == Part::nut, pitch, 0.0, flank, flank).dedendum;
    if (part == Part::nut) {
      check_nut_walls(c.structure->nut, *diameter, dedendum, pitch, bodies, problems);
      continue;
    }
    const double root = 0.5 * *diameter - dedendum;
    const double wall = root - (part == Part::screw ? 0.5 * c.structure->screw.bore : 0.0);
    const double thinnest = (meshed ? kLeastMeshedWall : kLeastWall) * pitch;
    if (wall < thinnest)
      problems.add(part == Part::screw ? "structure.screw.bore" : "mechanism.pitch_diameter.roller",
                   fmt::format("leaves a wall of {} below the threads, whose root lies at a diameter of {}; "
                               "expected at least {} for `bodies: {}`; change it or take `bodies: bars`",
                               mm(wall), mm(2.0 * root), mm(thinnest), bodies.name));
  }
}

}  // namespace

void check_bodies(const Case& c, Problems& problems) {
  const ModelOptions& model = c.model;
  const BodyModel& bodies = *model.bodies;
  const bool full = model.all_rollers();
  const double width = model.tooth_compliance.width;
  const double least = 0.02 * axial_pitch(c.mechanism);
  if (model.tooth_compliance.kind == ModelOptions::ToothCompliance::Kind::yamamoto && width < least)
    problems.add("model.tooth_compliance.yamamoto",
                 fmt::format("got {}; expected at least {}, 2 % of the pitch; check the unit", mm(width), mm(least)));
  if (!bodies.single_roller && c.mechanism.rollers < 2)
    problems.add("mechanism.rollers",
                 "got 1 with `bodies: {}`, where rollers around the screw hold it in the "
                 "middle; expected at least 2; take `bodies: bars` for one roller",
                 bodies.name);
  if (!bodies.straight_rollers && model.roller == ModelOptions::Roller::rigid_bending)
    problems.add("model.roller",
                 "got `rigid_bending` with `bodies: {}`, whose rollers bend; expected "
                 "`flexible`; take `bodies: bars` or `refined` for rollers that stay straight",
                 bodies.name);
  if (!model.friction() && model.loads == ModelOptions::Loads::running)
    problems.add("model.loads",
                 "got `running` with `bodies: {}`{}, which take no friction; "
                 "expected `static`; take `bodies: bars` or `refined` for running loads",
                 bodies.name, full ? " and all rollers" : "");
  if (!bodies.all_rollers && full)
    problems.add("model.mechanism",
                 "got full with `bodies: {}`, which know one roller with its share; expected sector; take `bodies: "
                 "bars` or `refined` for all rollers",
                 bodies.name);
  if (!bodies.loose_guides_of_all_rollers && full && c.structure && c.structure->roller.guidance.clearance > 0.0)
    problems.add("structure.roller.guidance.clearance",
                 "got {} with `bodies: {}` and `mechanism: full`, whose rings are rigid lines; "
                 "expected 0; take `bodies: bars` or `refined`, or `mechanism: sector`",
                 mm(c.structure->roller.guidance.clearance), bodies.name);
  if (!bodies.grooves) return;
  if (model.roller_shear)
    problems.add("model.roller_shear",
                 "got `true` with `bodies: {}`, which has it anyway; expected it with "
                 "`bodies: bars` only; remove it",
                 bodies.name);
  check_threaded_walls(c, problems);
  if (c.structure && c.structure->nut.shoulder)
    check_shoulder_meets_face(c.structure->nut, c.mechanism.pitch_diameter.nut.value_or(0.0), problems);
}

void check_thickness(const Case& c, Problems& problems) {
  if (!c.model.bodies->grooves) return;
  for (const Part part : kParts)
    if (const auto& thread = c.mechanism.thread[part]; thread && thread->thickness)
      problems.add(fmt::format("mechanism.thread.{}.thickness", name(part)),
                   fmt::format("got {}; expected none with `model.bodies` other than bars, whose "
                               "teeth are half a pitch thick; delete it, or write `bodies: bars`",
                               mm(*thread->thickness)));
}

namespace {

/// Refuses keys that a sector does not take. No text is built for absent keys, as every design of a study passes here.
void refuse_in_sector(const Case& c, Problems& problems) {
  const auto refuse = [&](bool stands, std::string_view block, std::string_view key) {
    if (!stands) return;
    problems.add(fmt::format("{}.{}", block, key),
                 "cannot be combined with `mechanism: sector`, which has one roller and no side loads; "
                 "expected no such key there; delete it, or write `model: {mechanism: full}`");
  };
  refuse(c.model.contact_phase != ModelOptions::ContactPhase::equal, "model", "contact_phase");
  refuse(c.model.shear, "model", "shear");
  const Deviations& d = c.deviations;
  refuse(!d.roller_diameters.empty(), "deviations", "roller_diameter");
  refuse(!d.roller_position.near.empty() || !d.roller_position.far.empty(), "deviations", "roller_position");
  refuse(!d.missing_rollers.empty(), "deviations", "missing_rollers");
  refuse(!d.index_error.screw.empty() || !d.index_error.nut.empty(), "deviations", "index_error");
  refuse(d.thread_eccentricity != PerInterface<Lateral>{}, "deviations", "thread_eccentricity");
  refuse(d.turning != Turning{}, "deviations", "turning");
  refuse(!d.pitch_error.roller.lists.empty(), "deviations", "pitch_error.roller.list");
  if (c.structure) {
    const Structure& s = *c.structure;
    refuse(s.screw.far_length != 0.0, "structure", "screw.far_length");
    refuse(!s.screw.bearings.empty(), "structure", "screw.bearings");
    refuse(s.screw.drive.has_value(), "structure", "screw.drive");
    refuse(!s.masses.empty(), "structure", "masses");
    refuse(s.roller.rings != Rings{}, "structure", "roller.rings");
    refuse(s.nut.housing != Housing{}, "structure", "nut.housing");
  }
  if (c.life) refuse(c.life->load_case.has_value(), "life", "load_case");
  const SpatialLoad nothing;
  for (const LoadCase& load : c.load_cases) {
    const SpatialLoad& s = load.spatial;
    refuse(load.travel.has_value(), load.input_path, "travel");
    refuse(load.modes.has_value(), load.input_path, "modes");
    if (s == nothing) continue;
    refuse(s.carrier_angle != 0.0, load.input_path, "carrier_angle");
    refuse(s.eccentricity != nothing.eccentricity, load.input_path, "eccentricity");
    refuse(s.side_force != nothing.side_force, load.input_path, "side_force");
    refuse(s.moment != nothing.moment, load.input_path, "moment");
    refuse(s.nut_tilt != nothing.nut_tilt || s.nut_offset != nothing.nut_offset, load.input_path, "misalignment");
    refuse(s.orbit.has_value(), load.input_path, "orbit");
  }
}

void check_list(std::string path, std::size_t size, int wanted, std::string_view of, Problems& problems) {
  if (size != 0 && size != static_cast<std::size_t>(wanted))
    problems.add(
        std::move(path), "got {} value{}; expected {}, one for each {}; {}", size, size == 1 ? "" : "s", wanted, of,
        size < static_cast<std::size_t>(wanted) ? "add the others, 0 where nothing deviates" : "delete the others");
}

void check_lists(const Case& c, Problems& problems) {
  const Deviations& d = c.deviations;
  const Mechanism& m = c.mechanism;
  check_list("deviations.roller_diameter", d.roller_diameters.size(), m.rollers, "roller", problems);
  check_list("deviations.roller_position", d.roller_position.near.size(), m.rollers, "roller", problems);
  check_list("deviations.roller_position", d.roller_position.far.size(), m.rollers, "roller", problems);
  check_list("deviations.pitch_error.roller.list", d.pitch_error.roller.lists.size(), m.rollers, "roller", problems);
  for (const std::vector<double>& list : d.pitch_error.roller.lists) {
    check_list("deviations.pitch_error.roller.list", list.size(), m.contacts_per_roller, "contact of a roller",
               problems);
    for (const double value : list) check_offset("deviations.pitch_error.roller.list", value, m, problems);
  }
  for (const Part part : {Part::screw, Part::nut})
    if (!d.pitch_error[part].lists.empty())
      problems.add(fmt::format("deviations.pitch_error.{}.list", name(part)),
                   "got a list of lists; expected one list, as the part has one thread for all "
                   "rollers; write one list");
  for (const Interface i : kInterfaces)
    check_list(fmt::format("deviations.index_error.{}", name(i)), d.index_error[i].size(), m.starts.screw, "start",
               problems);
  for (const auto* list : {&d.roller_diameters, &d.roller_position.near, &d.roller_position.far, &d.index_error.screw,
                           &d.index_error.nut}) {
    const char* path = list == &d.roller_diameters    ? "deviations.roller_diameter"
                       : list == &d.index_error.screw ? "deviations.index_error.screw"
                       : list == &d.index_error.nut   ? "deviations.index_error.nut"
                                                      : "deviations.roller_position";
    for (const double value : *list) check_offset(path, value, m, problems);
  }
  for (const Interface i : kInterfaces) {
    const std::string path = fmt::format("deviations.thread_eccentricity.{}", name(i));
    for (const double value : {d.thread_eccentricity[i].y, d.thread_eccentricity[i].z})
      check_offset(path.c_str(), value, m, problems);
  }
}

void check_missing_rollers(const Case& c, Problems& problems) {
  std::vector<int> missing = c.deviations.missing_rollers;
  const int rollers = c.mechanism.rollers;
  std::ranges::sort(missing);
  const auto wrong = std::ranges::find_if(missing, [&](int k) { return k < 1 || k > rollers; });
  if (wrong != missing.end())
    problems.add("deviations.missing_rollers", "got {}; expected numbers from 1 to {}; write one of them, or delete it",
                 *wrong, rollers);
  else if (const auto twice = std::ranges::adjacent_find(missing); twice != missing.end())
    problems.add("deviations.missing_rollers", "got {} twice; expected each number once; delete one", *twice);
  else if (static_cast<int>(missing.size()) == rollers && rollers > 0)
    problems.add("deviations.missing_rollers", "got all {} rollers; expected one that is left; delete a number",
                 rollers);
  if (missing.empty()) return;
  const auto refuse_equal = [&](LoadCase::Share share, std::string path) {
    if (share == LoadCase::Share::equal)
      problems.add(std::move(path),
                   "got equal, which has all rollers carry alike, with "
                   "`deviations.missing_rollers`; expected solved; write it, or delete the list");
  };
  for (const LoadCase& load : c.load_cases) refuse_equal(load.share, load.input_path + ".share");
  if (c.life) refuse_equal(c.life->share, "life.share");
}

/// Refuses loads and places that need an equilibrium if shares are equal.
void check_equal_shares(const Case& c, Problems& problems) {
  const SpatialLoad none;
  for (const LoadCase& load : c.load_cases) {
    const SpatialLoad& s = load.spatial;
    if (load.share != LoadCase::Share::equal || (s == none && !load.travel && !load.modes)) continue;
    const auto refuse = [&](bool stands, std::string_view key) {
      if (stands)
        problems.add(fmt::format("{}.{}", load.input_path, key),
                     "cannot be combined with `share: equal`, by which all rollers carry the same; expected no "
                     "such key there; delete it, or delete `share`");
    };
    refuse(s.side_force.value != Lateral{}, "side_force");
    refuse(s.moment.value != Lateral{}, "moment");
    refuse(s.eccentricity != Lateral{}, "eccentricity");
    refuse(s.nut_tilt != Lateral{} || s.nut_offset != Lateral{}, "misalignment");
    refuse(s.orbit.has_value(), "orbit");
    refuse(load.travel.has_value(), "travel");
    refuse(load.modes.has_value(), "modes");
  }
}

/// Largest rotation, for which sin(x) = x, as the model assumes, holds within 0.13 % [rad].
constexpr double kMostRotation = 5.0 * std::numbers::pi / 180.0;

/// Checks values that turn with screw, nut and rollers.
void check_turning(const Case& c, Problems& problems) {
  const Turning& t = c.deviations.turning;
  if (t == Turning{}) return;
  const Mechanism& m = c.mechanism;
  const std::string root = "deviations.turning.";
  const auto check = [&](const std::string& path, const RollerValue& v, bool is_length) {
    check_list(path, v.many.size(), m.rollers, "roller", problems);
    if (!is_length) return;
    check_offset(path.c_str(), v.one, m, problems);
    for (const double value : v.many) check_offset(path.c_str(), value, m, problems);
  };
  const auto check_tilt = [&](std::string path, double tilt) {
    if (std::abs(tilt) > kMostRotation)
      problems.add(std::move(path),
                   "got {:.7g} deg; expected at most 5 deg, as the model is for small rotations; "
                   "check the unit",
                   tilt * 180.0 / std::numbers::pi);
  };
  const TurningRollers& r = t.rollers;
  check(root + "roller.eccentricity.amount", r.eccentricity.amount, true);
  check(root + "roller.eccentricity.angle", r.eccentricity.angle, false);
  check(root + "roller.wobble.amount", r.wobble.amount, false);
  check(root + "roller.wobble.angle", r.wobble.angle, false);
  check_tilt(root + "roller.wobble.amount", r.wobble.amount.one);
  for (const double tilt : r.wobble.amount.many) check_tilt(root + "roller.wobble.amount", tilt);
  for (std::size_t k = 0; k < r.harmonics.size(); ++k) {
    const std::string path = fmt::format("{}roller.lead.harmonics[{}].", root, k);
    check(path + "amplitude", r.harmonics[k].amplitude, true);
    check(path + "phase", r.harmonics[k].phase, false);
  }
  for (const Interface i : kInterfaces) {
    const TurningThread& thread = t.thread[i];
    const std::string path = fmt::format("{}{}.", root, name(i));
    check_offset((path + "eccentricity.amount").c_str(), thread.eccentricity.amount, m, problems);
    check_tilt(path + "wobble.amount", thread.wobble.amount);
    check_offset((path + "lead.per_300_mm").c_str(),
                 thread.per_300_mm * (m.contacts_per_roller - 1) * axial_pitch(m) / 0.3, m, problems);
    for (std::size_t k = 0; k < thread.harmonics.size(); ++k)
      check_offset(fmt::format("{}lead.harmonics[{}].amplitude", path, k).c_str(), thread.harmonics[k].amplitude, m,
                   problems);
    for (std::size_t k = 0; k < thread.waves.size(); ++k)
      check_offset(fmt::format("{}lead.waves[{}].amplitude", path, k).c_str(), thread.waves[k].amplitude, m, problems);
    if (!thread.measured) continue;
    const MeasuredLead& lead = *thread.measured;
    if (lead.at.size() != lead.deviation.size())
      problems.add(path + "lead.measured.deviation",
                   "got {} values; expected {}, one for each place of `at`; add or delete some", lead.deviation.size(),
                   lead.at.size());
    for (std::size_t k = 1; k < lead.at.size(); ++k)
      if (!(lead.at[k] > lead.at[k - 1]))
        problems.add(path + "lead.measured.at",
                     "got {} after {}; expected places that rise; sort them with their "
                     "deviations",
                     mm(lead.at[k]), mm(lead.at[k - 1]));
    for (const double value : lead.deviation)
      check_offset((path + "lead.measured.deviation").c_str(), value, m, problems);
  }
}

/// Measured errors must cover all contacts at all positions of a load case.
void check_measured(const Case& c, Problems& problems) {
  const Mechanism& m = c.mechanism;
  const bool on_nut = carrier_part(m.type) == Part::nut;
  const bool helical = c.model.contact_phase == ModelOptions::ContactPhase::helical;
  const double margin = helical ? 0.5 * axial_pitch(m) : 0.0;
  for (const Interface i : kInterfaces) {
    const auto& measured = c.deviations.turning.thread[i].measured;
    if (!measured || measured->at.size() < 2) continue;
    std::vector<double> moved;
    for (const LoadCase& load : c.load_cases) {
      const Travel t = load.travel.value_or(Travel{});
      for (const double theta : {t.from, load.travel ? t.angle(t.last()) : t.from}) {
        const double lambda = m.lead * theta / (2.0 * std::numbers::pi);
        moved.push_back((on_nut ? 0.0 : lambda) - (i == Interface::screw ? lambda : 0.0));
      }
    }
    if (moved.empty()) moved = {0.0};
    const auto [least, most] = std::ranges::minmax(moved);
    const double from = least - margin;
    const double to = most + (m.contacts_per_roller - 1) * axial_pitch(m) + margin;
    const double tolerance = 1e-9 * (to - from) + 1e-12;
    if (measured->at.front() > from + tolerance || measured->at.back() < to - tolerance)
      problems.add(fmt::format("deviations.turning.{}.lead.measured.at", name(i)),
                   "got places from {} to {}; expected the whole thread that comes into contact, "
                   "{} to {}; measure further, or travel less",
                   mm(measured->at.front()), mm(measured->at.back()), mm(from), mm(to));
  }
}

void check_masses(const Case& c, Problems& problems) {
  const Structure& s = *c.structure;
  const double tolerance = kSamePlace * s.nut.length;
  for (std::size_t k = 0; k < s.masses.size(); ++k) {
    const ExtraMass& m = s.masses[k];
    const std::string path = fmt::format("structure.masses[{}]", k);
    if (m.mass == 0.0 && m.inertia.x == 0.0 && m.inertia.y == 0.0 && m.inertia.z == 0.0)
      problems.add(path + ".mass", "got 0 kg and no inertia; expected one of them; write it, or delete the mass");
    if (m.carrier == ExtraMass::Carrier::nut && (m.position < -tolerance || m.position > s.nut.length + tolerance))
      problems.add(path + ".position",
                   "got {}; expected a place on the nut, 0 mm to {}; move it, or write "
                   "`carried_by: screw`",
                   mm(m.position), mm(s.nut.length));
  }
}

void check_motion(const Case& c, Problems& problems) {
  for (const LoadCase& load : c.load_cases) {
    if (load.travel && load.travel->turns == 0)
      problems.add(load.input_path + ".travel.turns",
                   "got 0; expected a whole number other than 0, < 0 to turn back; write `turns: "
                   "1`, for example");
    if (load.travel && std::abs(static_cast<double>(load.travel->turns)) * load.travel->steps > 1e5)
      problems.add(load.input_path + ".travel.steps",
                   "got {} steps in each of {} turns; expected at most 100,000 positions; take "
                   "fewer",
                   load.travel->steps, load.travel->turns);
    if (!load.modes) continue;
    const std::string path = load.input_path + ".modes";
    if (!c.model.bodies->masses)
      problems.add(path,
                   "cannot be combined with `model.bodies` other than bars, whose masses are not in the model; "
                   "expected no such key there; delete it, or write `bodies: bars`");
    if (load.modes->positions && !load.travel)
      problems.add(path + ".positions",
                   "got {} without `travel`; expected the travel that they lie on; add `travel: "
                   "{{turns: 1}}`, or delete it",
                   *load.modes->positions);
    else if (load.modes->positions && *load.modes->positions > load.travel->last())
      problems.add(path + ".positions", "got {}; expected at most {}, the steps of the travel; take fewer",
                   *load.modes->positions, load.travel->last());
    for (const Part part : kParts)
      if (c.materials && !(*c.materials)[part].density)
        problems.add("materials",
                     "the {} lacks `density`; expected it for `modes`; add `density: 7810 kg/m^3`, "
                     "for example",
                     name(part));
  }
}

/// Refuses two bearings that hold the same section rigidly: the share of each would be undetermined.
void check_bearings(const std::vector<Bearing>& bearings, double same_place, Problems& problems) {
  for (std::size_t k = 0; k < bearings.size(); ++k)
    for (std::size_t i = 0; i < k; ++i) {
      const Bearing &a = bearings[i], &b = bearings[k];
      const bool both_hold = (a.lateral == kRigid && b.lateral == kRigid) || (a.tilt == kRigid && b.tilt == kRigid);
      if (both_hold && std::abs(a.position - b.position) <= same_place)
        problems.add(fmt::format("structure.screw.bearings[{}].position", k),
                     "got {}, where bearings[{}] is rigid too; expected one rigid bearing at a "
                     "place; move it, or delete one of the two",
                     mm(b.position), i);
    }
}

void check_rotation(std::string path, const Lateral& rotation, Problems& problems) {
  for (const double value : {rotation.y, rotation.z})
    if (std::abs(value) > kMostRotation)
      problems.add(path,
                   "got {:.7g} deg; expected at most 5 deg, as the model is for small rotations; "
                   "check the unit",
                   value * 180.0 / std::numbers::pi);
}

/// Largest displacement that counts as small, as a share of the screw's pitch diameter.
constexpr double kMostDisplacement = 0.1;

void check_seat(std::string path, const Lateral& offset, const Mechanism& m, Problems& problems) {
  if (!m.pitch_diameter.screw) return;
  const double most = kMostDisplacement * *m.pitch_diameter.screw;
  for (const double value : {offset.y, offset.z})
    if (std::abs(value) > most)
      problems.add(path,
                   "got {}; expected at most {}, a tenth of the screw's pitch diameter, as the "
                   "model is for small displacements; check the unit",
                   mm(value), mm(most));
}

void check_small_motions(const Case& c, Problems& problems) {
  for (const LoadCase& load : c.load_cases) {
    check_rotation(load.input_path + ".misalignment.nut_tilt", load.spatial.nut_tilt, problems);
    check_seat(load.input_path + ".misalignment.nut_offset", load.spatial.nut_offset, c.mechanism, problems);
  }
  if (!c.structure) return;
  const auto& bearings = c.structure->screw.bearings;
  for (std::size_t k = 0; k < bearings.size(); ++k) {
    const std::string path = fmt::format("structure.screw.bearings[{}]", k);
    check_rotation(path + ".angle", bearings[k].angle, problems);
    check_seat(path + ".offset", bearings[k].offset, c.mechanism, problems);
  }
}

/// Checks places on the screw of a load case: from the loaded section to the far end.
void check_places(const Case& c, Problems& problems) {
  const Structure& s = *c.structure;
  for (const LoadCase& load : c.load_cases) {
    if (!load.position) continue;
    const double first = *load.position - free_length(s);
    const double last =
        *load.position + (c.mechanism.contacts_per_roller - 1) * axial_pitch(c.mechanism) + s.screw.far_length;
    const double tolerance = kSamePlace * s.nut.length;
    const auto check = [&](std::string path, double x) {
      if (x < first - tolerance || x > last + tolerance)
        problems.add(std::move(path),
                     "got {}; expected a place on the screw, {} to {} in case `{}`; move it, or "
                     "lengthen `structure.screw.{}`",
                     mm(x), mm(first), mm(last), load.name, x < first ? "free_length" : "far_length");
    };
    for (std::size_t k = 0; k < s.screw.bearings.size(); ++k)
      check(fmt::format("structure.screw.bearings[{}].position", k), s.screw.bearings[k].position);
    if (load.spatial.side_force.at) check(load.input_path + ".side_force.at", *load.spatial.side_force.at);
    if (load.spatial.moment.at) check(load.input_path + ".moment.at", *load.spatial.moment.at);
    if (s.screw.drive) check("structure.screw.drive.position", s.screw.drive->position);
    for (std::size_t k = 0; k < s.masses.size(); ++k)
      if (s.masses[k].carrier == ExtraMass::Carrier::screw)
        check(fmt::format("structure.masses[{}].position", k), s.masses[k].position);
  }
}

}  // namespace

void check_full_mechanism(const Case& c, Problems& problems) {
  if (!c.model.all_rollers()) return refuse_in_sector(c, problems);
  if (contact::is_grooved(c.mechanism.type)) {
    problems.add("model.mechanism",
                 "got full with `type: {}`; expected sector: threads of rollers that leave their place, moments, modes "
                 "and teeth are not modelled; write `mechanism: sector`",
                 contact::facts_of(c.mechanism.type).name);
    return;
  }
  if (!c.model.bodies->helical_contacts && c.model.contact_phase != ModelOptions::ContactPhase::equal)
    problems.add("model.contact_phase",
                 "got helical with `bodies: {}`, bodies of revolution whose ridges have no "
                 "lead; expected equal; delete it, or take `bodies: refined`",
                 c.model.bodies->name);
  if (c.mechanism.rollers < 2)
    problems.add("mechanism.rollers",
                 "got {}; expected at least 2 with `mechanism: full`; add rollers, or write "
                 "`mechanism: sector`",
                 c.mechanism.rollers);
  check_lists(c, problems);
  check_missing_rollers(c, problems);
  check_equal_shares(c, problems);
  check_small_motions(c, problems);
  check_turning(c, problems);
  check_motion(c, problems);
  check_measured(c, problems);
  if (!c.structure) return;
  check_masses(c, problems);
  const Rings& rings = c.structure->roller.rings;
  if (c.model.roller == ModelOptions::Roller::rigid_bending && rings.carrier != Rings::Carrier::housing)
    problems.add("structure.roller.rings",
                 "got rings that move with a part and rollers that stay straight; expected `rings: "
                 "housing` with `model.roller: rigid_bending`");
  check_places(c, problems);
  check_bearings(c.structure->screw.bearings, kSamePlace * c.structure->nut.length, problems);
}

}  // namespace prs
