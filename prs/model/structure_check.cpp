#include "prs/model/structure_check.h"

#include <algorithm>
#include <numeric>

#include "prs/model/quantity_text.h"

namespace prs {
namespace {

/// Checks that threads reach across the gap between two pitch cylinders: sharp threads are half a pitch over the
/// tangent of the flank angle high.
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
                 "got {}; expected {}, the sum of the pitch radii of screw and roller, give or "
                 "take {}, or the threads cannot mesh; check centre distance and pitch diameters",
                 mm(*m.centre_distance), mm(0.5 * (*screw + *roller)), mm(reach));
  if (std::abs(nut_gap) > reach)
    problems.add("mechanism.pitch_diameter.nut",
                 "got {}; expected {}, twice the sum of the centre distance and the roller's pitch radius, give or "
                 "take {}, or the threads cannot mesh; check centre distance and pitch diameters",
                 mm(*nut), mm(2.0 * *m.centre_distance + *roller), mm(2.0 * reach));
}

/// Crest of a roller without stated thread height, beyond its pitch radius, in pitches: not higher than where flanks
/// meet, not lower than in a catalogue.
constexpr double kLowestCrest = 0.15;

/// Neighbouring rollers must clear each other at their crests (Sandu 2018, (1.49)).
void check_rollers(const Mechanism& m, Problems& problems) {
  if (!m.centre_distance || !m.pitch_diameter.roller || m.rollers < 2) return;
  const contact::MechanismGeometry threads = threads_of(m);
  const contact::ThreadStatus status = contact::check(threads.roller);
  if (status != contact::ThreadStatus::ok && status != contact::ThreadStatus::beyond_sharp_limit) return;
  const bool unknown = !m.thread.roller;
  const double largest = contact::flank_limits(threads.roller).largest;
  const double crest =
      unknown ? std::min(largest, 0.5 * *m.pitch_diameter.roller + kLowestCrest * axial_pitch(m)) : largest;
  const int most = contact::largest_roller_count(crest, *m.centre_distance);
  if (m.rollers <= most) return;
  problems.add("mechanism.rollers",
               "got {}; expected at most {}: more rollers of {} at their crests{} overlap at the centre distance of "
               "{}; take fewer{}",
               m.rollers, most, mm(2.0 * crest), unknown ? ", 0.15 pitches high," : "", mm(*m.centre_distance),
               unknown ? ", or state lower crests as `mechanism.thread.roller`" : "");
}

}  // namespace

void check_threads(const Mechanism& m, Problems& problems) {
  const double pitch = axial_pitch(m);
  const bool grooved = contact::is_grooved(m.type);
  if (grooved != (m.starts.roller == 0))
    problems.add("mechanism.starts.roller", "got {}; expected {} with `type: {}`; change one of them", m.starts.roller,
                 grooved ? "0, grooves without a helix," : "1 or more, threads,", contact::facts_of(m.type).name);
  if (loaded_rollers(m) < 1)
    problems.add(
        "mechanism.rollers_unloaded",
        "leaves {} of {} rollers to carry the load; expected at least 1; take more rollers or fewer unloaded ones",
        loaded_rollers(m), m.rollers);
  for (Part part : kParts) {
    const std::optional<double>& diameter = m.pitch_diameter[part];
    if (diameter && pitch > 2.0 * *diameter)
      problems.add("mechanism.lead",
                   "got {} with {} starts, an axial pitch of {}; expected a pitch of at most twice "
                   "each pitch diameter, one of which is {}; check the units",
                   mm(m.lead), m.starts.screw, mm(pitch), mm(*diameter));
    if (m.profile[part].shape == Profile::Shape::centred && (part == Part::nut || !diameter))
      problems.add(fmt::format("mechanism.profile.{}", name(part)),
                   "got centred, an arc about the axis; expected it of {}; write the arc's radius, "
                   "for example `{{convex: 6 mm}}`",
                   part == Part::nut ? "screw or roller" : "a part with a pitch diameter");
    if (m.pitch[part] && std::abs(*m.pitch[part] / pitch - 1.0) > 0.5)
      problems.add(fmt::format("mechanism.pitch.{}", name(part)),
                   "got {}; expected a measured pitch near lead / starts, {}; check the units", mm(*m.pitch[part]),
                   mm(pitch));
  }
}

void check_meshing(const Mechanism& m, Problems& problems) {
  check_reach(m, problems);
  check_rollers(m, problems);
}

namespace {

void check_flanges(const Structure::Nut& nut, const std::optional<double>& pitch_diameter, Problems& problems) {
  const double tolerance = kSamePlace * nut.length;
  for (std::size_t i = 0; i < nut.flanges.size(); ++i) {
    const Structure::Flange& f = nut.flanges[i];
    const auto path = [i](std::string_view key) { return fmt::format("structure.nut.flanges[{}].{}", i, key); };
    if (!(f.from < f.to))
      problems.add(path("to"), "got {}; expected a position beyond `from`, {}; swap the two", mm(f.to), mm(f.from));
    if (f.from < -tolerance)
      problems.add(path("from"), "got {}; expected a position on the nut, 0 mm to {}; move the flange", mm(f.from),
                   mm(nut.length));
    if (f.to > nut.length + tolerance)
      problems.add(path("to"),
                   "got {}; expected a position on the nut, 0 mm to {}; move the flange or lengthen the nut", mm(f.to),
                   mm(nut.length));
    if (pitch_diameter && f.outer_diameter <= *pitch_diameter)
      problems.add(path("outer_diameter"),
                   "got {}; expected more than the nut's pitch diameter, {}; check the two diameters",
                   mm(f.outer_diameter), mm(*pitch_diameter));
  }
  std::vector<std::size_t> order;  // Order of the places; empty, without memory, if they are sorted.
  if (!std::ranges::is_sorted(nut.flanges, {}, &Structure::Flange::from)) {
    order.resize(nut.flanges.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return nut.flanges[i].from; });
  }
  const auto at = [&](std::size_t k) { return order.empty() ? k : order[k]; };
  for (std::size_t k = 1; k < nut.flanges.size(); ++k) {
    const Structure::Flange &before = nut.flanges[at(k - 1)], &f = nut.flanges[at(k)];
    if (f.from < before.to - tolerance)
      problems.add(fmt::format("structure.nut.flanges[{}]", at(k)),
                   "got a flange from {} that overlaps the one from {} to {}; expected flanges "
                   "that touch at most; move one of them",
                   mm(f.from), mm(before.from), mm(before.to));
  }
}

/// Length far out of proportion to its part: usually a wrong unit.
struct Proportion {
  std::string_view path;
  double length;
  std::optional<double> diameter;  ///< Diameter of the part [m].
  double least, greatest;          ///< Bounds as multiples of the diameter.
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
                   "got {}{}; expected {} to {}, {:g} to {:g} times the part's pitch diameter; "
                   "check the unit",
                   path == "mechanism.lead" ? "an axial pitch of " : "", mm(length), mm(least * *diameter),
                   mm(greatest * *diameter), least, greatest);
}

void check_shoulder(const Structure::Nut& nut, const std::optional<double>& pitch_diameter, Problems& problems) {
  const Structure::Shoulder& s = *nut.shoulder;
  double outer = nut.outer_diameter;
  for (const Structure::Flange& f : nut.flanges) outer = std::max(outer, f.outer_diameter);
  if (!(s.inner_diameter < s.outer_diameter))
    problems.add("structure.nut.shoulder.outer_diameter",
                 "got {}; expected more than its inner diameter, {}; swap the two", mm(s.outer_diameter),
                 mm(s.inner_diameter));
  if (s.inner_diameter >= outer)
    problems.add("structure.nut.shoulder.inner_diameter",
                 "got {}; expected less than the largest diameter of the nut, {}, or it misses the "
                 "nut; make it smaller",
                 mm(s.inner_diameter), mm(outer));
  if (pitch_diameter && s.outer_diameter <= *pitch_diameter)
    problems.add("structure.nut.shoulder.outer_diameter",
                 "got {}; expected more than the nut's pitch diameter, {}, or it misses the nut; "
                 "make it larger",
                 mm(s.outer_diameter), mm(*pitch_diameter));
}

}  // namespace

void check_structure(const Structure& s, const Mechanism& m, Problems& problems) {
  const auto& diameter = m.pitch_diameter;
  if (diameter.screw && s.screw.bore >= *diameter.screw)
    problems.add("structure.screw.bore",
                 "got {}; expected less than the screw's pitch diameter, {}; check the two diameters", mm(s.screw.bore),
                 mm(*diameter.screw));
  if (diameter.nut && s.nut.outer_diameter <= *diameter.nut)
    problems.add("structure.nut.outer_diameter",
                 "got {}; expected more than the nut's pitch diameter, {}; check the two diameters",
                 mm(s.nut.outer_diameter), mm(*diameter.nut));
  const double tolerance = kSamePlace * s.nut.length;
  const std::pair<std::string_view, std::optional<double>> sections[] = {{"tension", s.nut.thrust.tension},
                                                                         {"compression", s.nut.thrust.compression}};
  for (const auto& [direction, section] : sections)
    if (section && (*section < -tolerance || *section > s.nut.length + tolerance))
      problems.add(fmt::format("structure.nut.thrust.{}", direction),
                   "got {}; expected a position on the nut, 0 mm to {}; move the section", mm(*section),
                   mm(s.nut.length));
  check_flanges(s.nut, diameter.nut, problems);
  if (s.nut.shoulder) check_shoulder(s.nut, diameter.nut, problems);
  check_proportions(s, m, problems);
}

namespace {

void check_pitch_error(const PitchError& e, Part part, const Mechanism& m, Problems& problems) {
  const auto path = [&] { return fmt::format("deviations.pitch_error.{}", name(part)); };
  const auto contacts = static_cast<std::size_t>(m.contacts_per_roller);
  if (!e.list.empty() && e.list.size() != contacts)
    problems.add(path() + ".list", "got {} value{}; expected {}, one per contact of a roller; {}", e.list.size(),
                 e.list.size() == 1 ? "" : "s", contacts,
                 e.list.size() < contacts ? "add the others, 0 where nothing deviates" : "delete the others");
  double largest = std::max(std::abs(e.linear), e.periodic ? std::abs(e.periodic->amplitude) : 0.0);
  for (const double value : e.list) largest = std::max(largest, std::abs(value));
  if (largest > kMostDeviation * axial_pitch(m))
    problems.add(path(), "got up to {}; expected at most {}, a quarter of the pitch; check the unit", mm(largest),
                 mm(kMostDeviation * axial_pitch(m)));
}

}  // namespace

void check_offset(const char* path, double offset, const Mechanism& m, Problems& problems) {
  const double most = kMostDeviation * axial_pitch(m);
  if (std::abs(offset) > most)
    problems.add(path, "got {}; expected at most {} either way, a quarter of the pitch; check the unit", mm(offset),
                 mm(most));
}

void check_deviations(const Case& c, Problems& problems) {
  const Deviations& d = c.deviations;
  const Mechanism& m = c.mechanism;
  for (const Part part : kParts) check_pitch_error(d.pitch_error[part], part, m, problems);
  const std::pair<const char*, double> drops[] = {
      {"deviations.roller_diameter", d.roller_diameter},
      {"deviations.crowning", d.crowning},
      {"deviations.end_relief.drop", d.end_relief ? d.end_relief->drop : 0.0}};
  for (const auto& [path, value] : drops) check_offset(path, value, m, problems);
  if (d.end_relief && 2 * d.end_relief->threads > m.contacts_per_roller)
    problems.add("deviations.end_relief.threads", "got {}; expected at most {}, half of the contacts of a roller",
                 d.end_relief->threads, m.contacts_per_roller / 2);
  if (!d.temperature || !c.materials) return;
  for (const Part part : kParts)
    if ((*d.temperature)[part] != d.reference_temperature && !(*c.materials)[part].thermal_expansion)
      problems.add("materials",
                   "the {} lacks `thermal_expansion`; expected it where a temperature differs from "
                   "the reference, {}; add `thermal_expansion: 11.5 um/m/K`, for example",
                   name(part), celsius(d.reference_temperature));
}

}  // namespace prs
