#include "prs/model/check_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "contact/viscosity.h"
#include "prs/model/groove.h"

namespace prs {

namespace {

constexpr double kTolerance = kSamePlace;  ///< Of the nut's length, in axial positions.

/// Collects problems, one for each path: the first found is the one to mend.
class Problems {
 public:
  void add(std::string path, std::string message) {
    if (paths_.insert(path).second) found_.push_back({std::move(path), std::move(message)});
  }
  std::vector<Problem> take() && { return std::move(found_); }

 private:
  std::set<std::string> paths_;
  std::vector<Problem> found_;
};

std::string_view name_of(Part part) {
  return part == Part::screw ? "screw" : part == Part::roller ? "roller" : "nut";
}
std::string mm(double length) { return fmt::format("{:.7g} mm", 1e3 * length); }
std::string newton(double force) { return fmt::format("{:.7g} N", force); }
std::string rpm(double speed) { return fmt::format("{:.7g} rpm", speed * 30.0 / std::numbers::pi); }
std::string mm2_per_s(double viscosity) { return fmt::format("{:.7g} mm^2/s", 1e6 * viscosity); }
std::string celsius(double temperature) { return fmt::format("{:.7g} degC", temperature - 273.15); }

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
          fmt::format("mechanism.profile.{}", name_of(part)),
          fmt::format("got centred, an arc about the axis; expected it of {}; write the arc's "
                      "radius, for example `{{convex: 6 mm}}`",
                      part == Part::nut ? "screw or roller" : "a part with a pitch diameter"));
    if (m.pitch[part] && std::abs(*m.pitch[part] / pitch - 1.0) > 0.5)
      problems.add(
          fmt::format("mechanism.pitch.{}", name_of(part)),
          fmt::format("got {}; expected a measured pitch near lead / starts, {}; check the "
                      "units",
                      mm(*m.pitch[part]), mm(pitch)));
  }
}

/// Whether threads can reach each other across the gap between two pitch cylinders: sharp threads
/// are half a pitch over the tangent of the flank angle high.
void check_reach(const Mechanism& m, Problems& problems) {
  const auto& [screw, roller, nut] = m.pitch_diameter;
  if (!screw || !roller || !nut || !m.centre_distance) return;
  const double flank = std::min({m.flank_angle.screw, m.flank_angle.roller, m.flank_angle.nut});
  const double reach = 0.5 * axial_pitch(m) * std::max(1.0, 1.0 / std::tan(flank));
  const double screw_gap = *m.centre_distance - 0.5 * (*screw + *roller);
  const double nut_gap = 0.5 * *nut - (*m.centre_distance + 0.5 * *roller);
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

void check_flanges(const Structure::Nut& nut, const std::optional<double>& pitch_diameter,
                   Problems& problems) {
  const double tolerance = kTolerance * nut.length;
  for (std::size_t i = 0; i < nut.flanges.size(); ++i) {
    const Structure::Flange& f = nut.flanges[i];
    const auto path = [i](std::string_view key) {
      return fmt::format("structure.nut.flanges[{}].{}", i, key);
    };
    if (!(f.from < f.to))
      problems.add(path("to"), fmt::format("got {}; expected a position beyond `from`, {}; swap "
                                           "the two",
                                           mm(f.to), mm(f.from)));
    if (f.from < -tolerance)
      problems.add(path("from"), fmt::format("got {}; expected a position on the nut, 0 mm to {}; "
                                             "move the flange",
                                             mm(f.from), mm(nut.length)));
    if (f.to > nut.length + tolerance)
      problems.add(path("to"), fmt::format("got {}; expected a position on the nut, 0 mm to {}; "
                                           "move the flange or lengthen the nut",
                                           mm(f.to), mm(nut.length)));
    if (pitch_diameter && f.outer_diameter <= *pitch_diameter)
      problems.add(path("outer_diameter"),
                   fmt::format("got {}; expected more than the nut's pitch diameter, {}; check the "
                               "two diameters",
                               mm(f.outer_diameter), mm(*pitch_diameter)));
  }
  if (nut.flanges.size() < 2) return;
  std::vector<std::size_t> order(nut.flanges.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return nut.flanges[i].from; });
  for (std::size_t k = 1; k < order.size(); ++k) {
    const Structure::Flange& before = nut.flanges[order[k - 1]];
    const Structure::Flange& f = nut.flanges[order[k]];
    if (f.from < before.to - tolerance)
      problems.add(fmt::format("structure.nut.flanges[{}]", order[k]),
                   fmt::format("got a flange from {} that overlaps the one from {} to {}; expected "
                               "flanges that touch at most; move one of them",
                               mm(f.from), mm(before.from), mm(before.to)));
  }
}

/// A length that is out of all proportion to the part it belongs to: most often a wrong unit.
struct Proportion {
  std::string_view path;
  double length;
  std::optional<double> diameter;  ///< Of the part [m].
  double least, greatest;          ///< Multiples of it.
};

void check_proportions(const Structure& s, const Mechanism& m, Problems& problems) {
  const auto& d = m.pitch_diameter;
  const Proportion proportions[] = {
      {"mechanism.lead", axial_pitch(m), d.roller, 1e-3, 2.0},
      {"structure.screw.free_length", s.screw.free_length, d.screw, 0.0, 1e4},
      {"structure.roller.end_length", s.roller.end_length, d.roller, 1e-3, 1e3},
      {"structure.roller.end_diameter", s.roller.end_diameter, d.roller, 2e-2, 20.0},
      {"structure.nut.length", s.nut.length, d.nut, 0.0, 1e4},
      {"structure.nut.outer_diameter", s.nut.outer_diameter, d.nut, 1.0001, 100.0},
  };
  for (const auto& [path, length, diameter, least, greatest] : proportions)
    if (diameter && (length < least * *diameter || length > greatest * *diameter))
      problems.add(std::string(path),
                   fmt::format("got {}{}; expected {} to {}, {:g} to {:g} times the part's pitch "
                               "diameter; check the unit",
                               path == "mechanism.lead" ? "an axial pitch of " : "", mm(length),
                               mm(least * *diameter), mm(greatest * *diameter), least, greatest));
}

void check_shoulder(const Structure::Nut& nut, const std::optional<double>& pitch_diameter,
                    Problems& problems) {
  const Structure::Shoulder& s = *nut.shoulder;
  double outer = nut.outer_diameter;
  for (const Structure::Flange& f : nut.flanges) outer = std::max(outer, f.outer_diameter);
  if (!(s.inner_diameter < s.outer_diameter))
    problems.add("structure.nut.shoulder.outer_diameter",
                 fmt::format("got {}; expected more than its inner diameter, {}; swap the two",
                             mm(s.outer_diameter), mm(s.inner_diameter)));
  if (s.inner_diameter >= outer)
    problems.add("structure.nut.shoulder.inner_diameter",
                 fmt::format("got {}; expected less than the largest diameter of the nut, {}, or "
                             "it misses the nut; make it smaller",
                             mm(s.inner_diameter), mm(outer)));
  if (pitch_diameter && s.outer_diameter <= *pitch_diameter)
    problems.add("structure.nut.shoulder.outer_diameter",
                 fmt::format("got {}; expected more than the nut's pitch diameter, {}, or it "
                             "misses the nut; make it larger",
                             mm(s.outer_diameter), mm(*pitch_diameter)));
}

void check_structure(const Structure& s, const Mechanism& m, Problems& problems) {
  const auto& diameter = m.pitch_diameter;
  if (diameter.screw && s.screw.bore >= *diameter.screw)
    problems.add("structure.screw.bore",
                 fmt::format("got {}; expected less than the screw's pitch diameter, {}; check the "
                             "two diameters",
                             mm(s.screw.bore), mm(*diameter.screw)));
  if (diameter.nut && s.nut.outer_diameter <= *diameter.nut)
    problems.add(
        "structure.nut.outer_diameter",
        fmt::format("got {}; expected more than the nut's pitch diameter, {}; check the two "
                    "diameters",
                    mm(s.nut.outer_diameter), mm(*diameter.nut)));
  const double tolerance = kTolerance * s.nut.length;
  const std::pair<std::string_view, std::optional<double>> sections[] = {
      {"tension", s.nut.thrust.tension}, {"compression", s.nut.thrust.compression}};
  for (const auto& [direction, section] : sections)
    if (section && (*section < -tolerance || *section > s.nut.length + tolerance))
      problems.add(
          fmt::format("structure.nut.thrust.{}", direction),
          fmt::format("got {}; expected a position on the nut, 0 mm to {}; move the section",
                      mm(*section), mm(s.nut.length)));
  check_flanges(s.nut, diameter.nut, problems);
  if (s.nut.shoulder) check_shoulder(s.nut, diameter.nut, problems);
  check_proportions(s, m, problems);
}

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
  const auto check = [&](std::string path, double outer, std::string_view what) {
    if (outer < least)
      problems.add(std::move(path),
                   fmt::format("got {}; expected at least {} for `bodies: {}`, {} pitches of wall "
                               "outside the {} of the thread; widen the {}",
                               mm(outer), mm(least), meshed ? "influence" : "refined", pitches,
                               meshed ? "roots" : "pitch line", what));
  };
  check("structure.nut.outer_diameter", nut.outer_diameter, "nut");
  for (std::size_t i = 0; i < nut.flanges.size(); ++i)
    check(fmt::format("structure.nut.flanges[{}].outer_diameter", i), nut.flanges[i].outer_diameter,
          "flange");
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
    const std::string path = fmt::format("mechanism.thread.{}", name(part));
    if (m.thread[part]) {
      const std::pair<const char*, double> heights[] = {{"addendum", m.thread[part]->addendum},
                                                        {"dedendum", m.thread[part]->dedendum}};
      for (const auto& [key, height] : heights)
        if (height < least || height >= 0.98 * sharp)
          problems.add(fmt::format("{}.{}", path, key),
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

/// What only some models of the bodies know.
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

/// The roller's contacts, from the first at `position`, must lie on the nut.
void check_position(const LoadCase& load, const Mechanism& m, const Structure::Nut& nut,
                    Problems& problems) {
  const double span = (m.contacts_per_roller - 1) * axial_pitch(m);
  const double last = nut.length - span;
  const double tolerance = kTolerance * nut.length;
  if (last < -tolerance)
    problems.add(
        "mechanism.contacts_per_roller",
        fmt::format("got {}, which span {}; expected contacts within the nut's length, {}; "
                    "take at most {} or lengthen the nut",
                    m.contacts_per_roller, mm(span), mm(nut.length),
                    1 + static_cast<int>((nut.length + tolerance) / axial_pitch(m))));
  else if (*load.position < -tolerance || *load.position > last + tolerance)
    problems.add(load.input_path + ".position",
                 fmt::format("got {}; expected 0 mm to {}, so that all {} contacts lie on the nut; "
                             "move the roller or lengthen the nut",
                             mm(*load.position), mm(std::max(last, 0.0)), m.contacts_per_roller));
}

void check_thrust(const LoadCase& load, const Structure::Nut& nut, Problems& problems) {
  const bool tension = load.direction == Direction::tension;
  if (tension ? nut.thrust.tension : nut.thrust.compression) return;
  const std::string_view direction = tension ? "tension" : "compression";
  problems.add(fmt::format("structure.nut.thrust.{}", direction),
               fmt::format("missing; expected the axial position of the section that holds {} in "
                           "case `{}`; add `{}: 10 mm`, for example",
                           direction, load.name, direction));
}

void check_force(const LoadCase& load, Problems& problems) {
  const double written = load.axial_force;
  if (load.direction ? written > 0.0 : written != 0.0) return;
  problems.add(load.input_path + ".axial_force",
               fmt::format("got {} in case `{}`; expected a force {}; {}", newton(written),
                           load.name, load.direction ? "> 0" : "other than 0",
                           load.direction ? "`direction` tells its sense" : "give it a value"));
}

void check_load_cases(const Case& c, Problems& problems) {
  std::unordered_set<std::string_view> names;
  for (const LoadCase& load : c.load_cases) {
    if (!names.insert(load.name).second)
      problems.add(load.input_path + ".name",
                   fmt::format("got `{}` a second time; expected names that differ, ranges "
                               "expanded; rename this case",
                               load.name));
    check_force(load, problems);
    if (load.share == LoadCase::Share::equal || !c.structure || !load.direction || !load.position)
      continue;
    check_position(load, c.mechanism, c.structure->nut, problems);
    check_thrust(load, c.structure->nut, problems);
  }
}

/// The two points must give a line along which the oil gets thinner with temperature; empty where
/// they do not.
std::optional<contact::WaltherLine> line_through(const std::vector<ViscosityPoint>& points,
                                                 double density, Problems& problems) {
  struct Measured {
    std::string path, text;
    double temperature, viscosity;  ///< Kinematic.
  };
  if (points.size() != 2) {
    problems.add("lubricant.viscosity_at",
                 fmt::format("got a list of {}; expected a list of 2, through which the line goes; "
                             "choose two points",
                             points.size()));
    return std::nullopt;
  }
  std::vector<Measured> measured;
  bool sound = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ViscosityPoint& p = points[i];
    const double viscosity = p.viscosity ? *p.viscosity / density : *p.kinematic_viscosity;
    std::string text = mm2_per_s(viscosity);
    if (p.viscosity) text = fmt::format("{:.7g} mPa s, {}", 1e3 * *p.viscosity, text);
    measured.push_back({fmt::format("lubricant.viscosity_at[{}].{}", i,
                                    p.viscosity ? "viscosity" : "kinematic_viscosity"),
                        text, p.temperature, viscosity});
    if (viscosity > contact::kLeastKinematicViscosity) continue;
    sound = false;
    problems.add(measured.back().path,
                 fmt::format("got {}; expected more than {}, where the line of ASTM D341 ends; "
                             "check value and unit",
                             text, mm2_per_s(contact::kLeastKinematicViscosity)));
  }
  if (!sound) return std::nullopt;
  Measured cold = measured[0], hot = measured[1];
  if (cold.temperature == hot.temperature) {
    problems.add("lubricant.viscosity_at[1].temperature",
                 fmt::format("got {} a second time; expected two temperatures that differ, usually "
                             "40 degC and 100 degC; change one of them",
                             celsius(hot.temperature)));
    return std::nullopt;
  }
  if (cold.temperature > hot.temperature) std::swap(cold, hot);
  if (hot.viscosity >= cold.viscosity) {
    problems.add(hot.path,
                 fmt::format("got {} at {}; expected less than {}, the viscosity at {}: oil gets "
                             "thinner as it warms; check the two points",
                             hot.text, celsius(hot.temperature), mm2_per_s(cold.viscosity),
                             celsius(cold.temperature)));
    return std::nullopt;
  }
  return contact::walther_line(cold.temperature, cold.viscosity, hot.temperature, hot.viscosity);
}

/// The viscosity as it stands, or as it follows from the temperature.
void check_lubricant(const Lubricant& l, Problems& problems) {
  if (l.viscosity && *l.viscosity <= contact::kRoelandsViscosity)
    problems.add("lubricant.viscosity",
                 fmt::format("got {:.7g} mPa s; expected more than {:.4f} mPa s, below which "
                             "Roelands' viscosity falls with pressure; check the unit",
                             1e3 * *l.viscosity, 1e3 * contact::kRoelandsViscosity));
  if (!l.temperature) return;
  const bool kinematic = l.walther || std::ranges::any_of(l.viscosity_at, [](const auto& p) {
                           return p.kinematic_viscosity.has_value();
                         });
  if (kinematic && !l.density)
    return problems.add("lubricant.density",
                        "missing; expected the density of the oil, by which its kinematic "
                        "viscosity becomes dynamic; add `density: 870 kg/m^3`, for example");
  const std::optional<contact::WaltherLine> line =
      l.walther
          ? l.walther
          : line_through(l.viscosity_at, l.density.value_or(contact::kTypicalOilDensity), problems);
  if (!line) return;
  const double viscosity = contact::kinematic_viscosity(*line, *l.temperature);
  if (viscosity > contact::kLeastKinematicViscosity &&
      viscosity <= contact::kGreatestKinematicViscosity)
    return;
  problems.add("lubricant.temperature",
               fmt::format("got {}, where the oil's line gives {}; expected more than {} and at "
                           "most {} there, within ASTM D341; check the temperature and {}",
                           celsius(*l.temperature), mm2_per_s(viscosity),
                           mm2_per_s(contact::kLeastKinematicViscosity),
                           mm2_per_s(contact::kGreatestKinematicViscosity),
                           l.walther ? "`walther`" : "the two points"));
}

void check_carrier(const Carrier& carrier, Problems& problems) {
  if (!carrier.bearing) return;
  const contact::JournalBearing& b = *carrier.bearing;
  if (carrier.roller_torque > 0.0)
    problems.add("carrier.roller_torque",
                 fmt::format("got {:.7g} N m beside `bearing`, from which it follows; expected one "
                             "of the two; delete the other",
                             carrier.roller_torque));
  if (!(b.radial_clearance < 0.1 * b.diameter))
    problems.add("carrier.bearing.radial_clearance",
                 fmt::format("got {}; expected less than {}, a tenth of the diameter, so that the "
                             "film is thin; check the unit",
                             mm(b.radial_clearance), mm(0.1 * b.diameter)));
  if (b.length > 2.0 * b.diameter)
    problems.add("carrier.bearing.length",
                 fmt::format("got {}; expected at most {}, twice the diameter: longer bearings are "
                             "beyond the theory of short ones; shorten it or give "
                             "`roller_torque` instead",
                             mm(b.length), mm(2.0 * b.diameter)));
}

/// The screw drives the load where force and speed have one sign. A left-handed screw may also be
/// driven by its load.
void check_speed(const LoadCase& load, double speed, const Mechanism& m, Problems& problems) {
  const double force = axial_force_on_nut(load);
  const std::string path = load.input_path + (load.speed ? ".speed" : "");
  if (speed == 0.0)
    problems.add(load.speed ? path : "operation.speed",
                 fmt::format("got {} in case `{}`; expected a speed other than 0: at rest nothing "
                             "slips; change `operation.speed` or give the case a `speed` of its "
                             "own",
                             rpm(speed), load.name));
  else if (m.lead > 0.0 && force * speed <= 0.0)
    problems.add(path,
                 fmt::format("got {} of axial force and {} in case `{}`; expected both of one sign "
                             "(tension > 0, compression < 0), so that the screw drives the load; "
                             "change the sign of the speed or give the case a `speed` of its own",
                             newton(force), rpm(speed), load.name));
}

/// Errors of position beyond this share of the pitch are other threads, or other units.
constexpr double kMostDeviation = 0.25;

void check_pitch_error(const PitchError& e, Part part, const Mechanism& m, Problems& problems) {
  const auto path = [&] { return fmt::format("deviations.pitch_error.{}", name(part)); };
  const auto contacts = static_cast<std::size_t>(m.contacts_per_roller);
  if (!e.list.empty() && e.list.size() != contacts)
    problems.add(path() + ".list",
                 fmt::format("got {} values; expected {}, one a contact of a roller", e.list.size(),
                             contacts));
  double largest = std::max(std::abs(e.linear), e.periodic ? std::abs(e.periodic->amplitude) : 0.0);
  for (const double value : e.list) largest = std::max(largest, std::abs(value));
  if (largest > kMostDeviation * axial_pitch(m))
    problems.add(path(), fmt::format("got up to {}; expected at most {}, a quarter of the pitch; "
                                     "check the unit",
                                     mm(largest), mm(kMostDeviation * axial_pitch(m))));
}

void check_deviations(const Case& c, Problems& problems) {
  const Deviations& d = c.deviations;
  const Mechanism& m = c.mechanism;
  for (const Part part : kParts) check_pitch_error(d.pitch_error[part], part, m, problems);
  const std::pair<const char*, double> drops[] = {
      {"deviations.roller_diameter", d.roller_diameter},
      {"deviations.crowning", d.crowning},
      {"deviations.end_relief.drop", d.end_relief ? d.end_relief->drop : 0.0}};
  for (const auto& [path, value] : drops)
    if (std::abs(value) > kMostDeviation * axial_pitch(m))
      problems.add(path, fmt::format("got {}; expected at most {}, a quarter of the pitch; check "
                                     "the unit",
                                     mm(value), mm(kMostDeviation * axial_pitch(m))));
  if (d.end_relief && 2 * d.end_relief->threads > m.contacts_per_roller)
    problems.add("deviations.end_relief.threads",
                 fmt::format("got {}; expected at most {}, half of the contacts of a roller",
                             d.end_relief->threads, m.contacts_per_roller / 2));
  if (!d.temperature || !c.materials) return;
  for (const Part part : kParts)
    if ((*d.temperature)[part] != d.reference_temperature &&
        !(*c.materials)[part].thermal_expansion)
      problems.add("materials",
                   fmt::format("the {} lacks `thermal_expansion`; expected it where a temperature "
                               "differs from the reference, {}; add `thermal_expansion: 11.5 "
                               "um/m/K`, for example",
                               name(part), celsius(d.reference_temperature)));
}

void check_spacer(const Spacer& spacer, const Structure::Nut& nut, const Mechanism& m,
                  Problems& problems) {
  if (spacer.inner_diameter >= spacer.outer_diameter)
    problems.add("preload.spacer.inner_diameter",
                 fmt::format("got {}; expected less than its outer diameter, {}; check the two "
                             "diameters",
                             mm(spacer.inner_diameter), mm(spacer.outer_diameter)));
  else if (spacer.inner_diameter >= nut.outer_diameter)
    problems.add("preload.spacer.inner_diameter",
                 fmt::format("got {}; expected less than the nut's outer diameter, {}, or the ring "
                             "misses the faces of the nuts; make it smaller",
                             mm(spacer.inner_diameter), mm(nut.outer_diameter)));
  else if (m.pitch_diameter.nut && spacer.outer_diameter <= *m.pitch_diameter.nut)
    problems.add("preload.spacer.outer_diameter",
                 fmt::format("got {}; expected more than the nut's pitch diameter, {}, or the ring "
                             "misses the faces of the nuts; make it larger",
                             mm(spacer.outer_diameter), mm(*m.pitch_diameter.nut)));
}

/// The rollers of the second nut must lie on it, and clear those of the first.
void check_distance(const Preload& p, const Structure& s, const Mechanism& m, Problems& problems) {
  const double span = (m.contacts_per_roller - 1) * axial_pitch(m);
  const double least = *p.distance - second_position(m, s.nut, p);
  const double most = least + s.nut.length - span;
  const double tolerance = kTolerance * s.nut.length;
  const double ends = axial_pitch(m) + 2.0 * s.roller.end_length;
  if (*p.distance < least - tolerance || *p.distance > most + tolerance)
    problems.add(
        "preload.distance",
        fmt::format("got {}; expected {} to {}, so that all {} contacts lie on the second "
                    "nut; move its rollers or change the spacer",
                    mm(*p.distance), mm(least), mm(std::max(least, most)), m.contacts_per_roller));
  else if (*p.distance < ends - tolerance)
    problems.add("preload.distance",
                 fmt::format("got {}; expected at least {}, a pitch and two ends of a roller, or "
                             "the rollers of both nuts overlap; move them apart",
                             mm(*p.distance), mm(ends)));
}

void check_preload(const Case& c, Problems& problems) {
  const Preload& p = *c.preload;
  const Mechanism& m = c.mechanism;
  const std::pair<const char*, double> fits[] = {
      {"preload.interference", p.interference.value_or(0.0)},
      {"preload.backlash", p.backlash.value_or(0.0)}};
  for (const auto& [path, value] : fits)
    if (value > kMostDeviation * axial_pitch(m))
      problems.add(path, fmt::format("got {}; expected at most {}, a quarter of the pitch; check "
                                     "the unit",
                                     mm(value), mm(kMostDeviation * axial_pitch(m))));
  if (!(p.load.from < p.load.to))
    problems.add("preload.load.to", fmt::format("got {}; expected more than `from`, {}; swap the "
                                                "two",
                                                newton(p.load.to), newton(p.load.from)));
  if (!c.structure) return;
  const Structure& s = *c.structure;
  if (!s.nut.thrust.tension && !s.nut.thrust.compression)
    problems.add("structure.nut.thrust",
                 "missing; expected the axial position of the section that holds the nut; add "
                 "`thrust: {tension: 10 mm}`, for example: one section holds both senses of the "
                 "load");
  LoadCase load;
  load.position = p.position;
  load.input_path = "preload";
  check_position(load, m, s.nut, problems);
  if (p.arrangement != Preload::Arrangement::double_nut) return;
  check_spacer(*p.spacer, s.nut, m, problems);
  const double last = p.position + (m.contacts_per_roller - 1) * axial_pitch(m);
  const double tolerance = kTolerance * s.nut.length;
  if (p.position >= -tolerance && last <= s.nut.length + tolerance)
    check_distance(p, s, m, problems);
}

/// How long the loads of a spectrum act: all by shares, or none.
void check_spectrum(const Case& c, Problems& problems) {
  double shares = 0.0;
  for (std::size_t i = 0; i < c.life->spectrum.size(); ++i) {
    const SpectrumLoad& l = c.life->spectrum[i];
    const std::string path = fmt::format("life.spectrum[{}]", i);
    shares += l.share.value_or(0.0);
    if (l.share.has_value() != c.life->spectrum.front().share.has_value())
      problems.add(path,
                   "mixes `share` with revolutions, distance or duration; expected shares of "
                   "all loads, or of none; change one kind into the other");
    if (l.duration && !(c.operation && c.operation->speed != 0.0))
      problems.add(path + ".duration",
                   "got a duration without speed; expected the speed that turns it into "
                   "revolutions; add `operation: {speed: 400 rpm}`, for example");
    LoadCase load;
    load.name = path;
    load.direction = l.direction;
    if (c.structure && c.life->share == LoadCase::Share::solved)
      check_thrust(load, c.structure->nut, problems);
  }
  if (c.life->spectrum.front().share && std::abs(shares - 1.0) > 1e-3)
    problems.add("life.spectrum",
                 fmt::format("got shares with the sum {:.6g}; expected 1, within 0.001; mend a "
                             "share, or write revolutions",
                             shares));
}

/// How far the screw turns between two samples.
void check_history(const Case& c, Problems& problems) {
  const HistorySource& h = *c.life->history;
  if (h.position) return;
  if (!h.time && !h.interval)
    problems.add(
        "life.history",
        "got neither `position` nor a clock; expected how far the screw turns between two "
        "samples; add `position: {column: .., unit: mm}`, or `time: {column: .., unit: s}` "
        "or `interval: 10 ms`, for example");
  else if (!h.speed && !(c.operation && c.operation->speed != 0.0))
    problems.add("life.history",
                 "got neither `position` nor a speed; expected how far the screw turns between two "
                 "samples; add `speed: {column: .., unit: rpm}` or `operation: {speed: 400 rpm}`, "
                 "for example");
}

void check_life(const Case& c, Problems& problems) {
  if (c.structure && c.life->share == LoadCase::Share::solved) {
    LoadCase load;
    load.position = c.life->position;
    load.input_path = "life";
    check_position(load, c.mechanism, c.structure->nut, problems);
  }
  if (c.life->history)
    check_history(c, problems);
  else
    check_spectrum(c, problems);
}

void check_life_requirements(const Case& c, Problems& problems) {
  const auto missing = [&](const char* path, std::string_view what, std::string_view example) {
    problems.add(path, fmt::format("missing; expected {} for `life`; add `{}: {}`, for example",
                                   what, path, example));
  };
  if (!c.life)
    missing("life", "the loads and how long they act",
            "{position: 10 mm, spectrum: [{force: 10 kN, direction: tension, share: 1}]}");
  if (!c.materials)
    missing("materials", "elastic properties", "{youngs_modulus: 210 GPa, poisson_ratio: 0.3}");
  if (!c.structure && c.life && c.life->share == LoadCase::Share::solved)
    problems.add("structure",
                 "missing; expected the parts around the threads for `life`; add `structure` with "
                 "`roller` and `nut`, or `share: equal` to `life`");
}

void check_preload_requirements(const Case& c, Problems& problems) {
  const auto missing = [&](const char* path, std::string_view what, std::string_view example) {
    problems.add(path, fmt::format("missing; expected {} for `preload`; add `{}: {}`, for example",
                                   what, path, example));
  };
  if (!c.preload)
    missing("preload", "what takes out the play, and the loads,",
            "{arrangement: single_nut, force: 2 kN, position: 10 mm, load: {from: -10 kN, to: 10 "
            "kN}}");
  if (!c.materials)
    missing("materials", "elastic properties", "{youngs_modulus: 210 GPa, poisson_ratio: 0.3}");
  if (!c.structure)
    missing("structure", "the parts around the threads",
            "{roller: {end_length: 5 mm, end_diameter: 5 mm}, nut: {length: 90 mm, outer_diameter: "
            "46 mm, thrust: {tension: 10 mm}}}");
  if (c.model.bodies == ModelOptions::Bodies::influence)
    problems.add("model.bodies",
                 "got influence; expected bars | refined: `preload` joins both sides in one "
                 "one-dimensional model; write `bodies: refined`");
}

/// The bodies of `refined` and `influence` have teeth of half a pitch.
void check_thickness(const Case& c, Problems& problems) {
  if (c.model.bodies == ModelOptions::Bodies::bars) return;
  for (const Part part : kParts)
    if (const auto& thread = c.mechanism.thread[part]; thread && thread->thickness)
      problems.add(fmt::format("mechanism.thread.{}.thickness", name(part)),
                   fmt::format("got {}; expected none with `model.bodies` other than bars, whose "
                               "teeth are half a pitch thick; delete it, or write `bodies: bars`",
                               mm(*thread->thickness)));
}

void check_slip(const Case& c, Problems& problems) {
  const auto missing = [&](const char* path, std::string_view what, std::string_view example) {
    problems.add(
        path, fmt::format("missing; expected {}; add `{}: {}`, for example", what, path, example));
  };
  if (!c.friction) missing("friction", "a law of friction for `slip`", "{model: jacod}");
  if (c.friction && c.friction->model == Friction::Model::jacod && !c.lubricant)
    missing("lubricant", "the lubricant for `friction: {model: jacod}`",
            "{viscosity: 160 mPa s, pressure_viscosity: 30 1/GPa, eyring_stress: 12 MPa}");
  if (c.carrier.bearing && !c.lubricant)
    missing("lubricant", "the lubricant of `carrier.bearing`, whatever the law of friction",
            "{viscosity: 160 mPa s, pressure_viscosity: 30 1/GPa, eyring_stress: 12 MPa}");
  for (const LoadCase& load : c.load_cases) {
    if (!load.speed && !c.operation) {
      missing("operation", "the speed for `slip`", "{speed: 400 rpm}");
      continue;
    }
    check_speed(load, load.speed ? *load.speed : c.operation->speed, c.mechanism, problems);
  }
}

}  // namespace

std::vector<Problem> check_case(const Case& c) {
  Problems problems;
  check_threads(c.mechanism, problems);
  check_bodies(c, problems);
  check_reach(c.mechanism, problems);
  check_rollers(c.mechanism, problems);
  if (c.structure) check_structure(*c.structure, c.mechanism, problems);
  check_load_cases(c, problems);
  check_thickness(c, problems);
  check_deviations(c, problems);
  if (c.preload) check_preload(c, problems);
  if (c.life) check_life(c, problems);
  if (c.lubricant) check_lubricant(*c.lubricant, problems);
  check_carrier(c.carrier, problems);
  return std::move(problems).take();
}

std::vector<Problem> check_requirements(const Case& c, Command command) {
  Problems problems;
  if (command == Command::preload) check_preload_requirements(c, problems);
  if (command == Command::life) check_life_requirements(c, problems);
  const bool measures = command == Command::measures && !c.load_cases.empty();
  if (command != Command::solve && command != Command::slip && !measures)
    return std::move(problems).take();
  const std::string_view verb = command == Command::solve  ? "solve"
                                : command == Command::slip ? "slip"
                                                           : "measures";

  if (c.load_cases.empty())
    problems.add("load_cases",
                 fmt::format("missing; expected at least one load case for `{}`; add `load_cases: "
                             "[{{axial_force: 10 kN, direction: tension, position: 10 mm}}]`, for "
                             "example",
                             verb));
  if (!c.materials)
    problems.add("materials", fmt::format("missing; expected elastic properties for `{}`; add "
                                          "`materials: {{youngs_modulus: 210 GPa, poisson_ratio: "
                                          "0.3}}`, for example",
                                          verb));
  const auto solved = [](const LoadCase& load) { return load.share == LoadCase::Share::solved; };
  if (!c.structure && std::ranges::any_of(c.load_cases, solved))
    problems.add("structure",
                 fmt::format("missing; expected the parts around the threads for `{}`; add "
                             "`structure` with `roller` and `nut`, or `share: equal` to each load "
                             "case",
                             verb));
  if (command == Command::slip) check_slip(c, problems);
  return std::move(problems).take();
}

}  // namespace prs
