#include "prs/model/load_case_check.h"

#include <algorithm>
#include <unordered_set>

#include "prs/model/operation_check.h"
#include "prs/model/quantity_text.h"
#include "prs/model/structure_check.h"

namespace prs {
namespace {

/// A force of 0 is allowed under preload only.
void check_force(const LoadCase& load, bool preloaded, Problems& problems) {
  const double written = load.axial_force;
  const bool may_be_zero = preloaded && load.is_solved();
  if (load.direction ? written > 0.0 || (may_be_zero && written == 0.0) : written != 0.0) return;
  problems.add(load.input_path + ".axial_force", "got {} in case `{}`; expected a force {}; {}", newton(written),
               load.name, load.direction ? "> 0" : "other than 0",
               load.direction ? "`direction` gives its sense" : "give it a value");
}

/// Positions of the first contact for which all contacts are on the nut [m].
struct RoomOnNut {
  double span, last, tolerance;

  RoomOnNut(const Mechanism& m, const Structure::Nut& nut)
      : span((m.contacts_per_roller - 1) * axial_pitch(m)),
        last(nut.length - span),
        tolerance(kSamePlace * nut.length) {}
  bool none() const { return last < -tolerance; }
  bool holds(double position) const { return !none() && !(position < -tolerance || position > last + tolerance); }
};

void check_spacer(const Spacer& spacer, const Structure::Nut& nut, const Mechanism& m, Problems& problems) {
  if (spacer.inner_diameter >= spacer.outer_diameter)
    problems.add("preload.spacer.inner_diameter",
                 "got {}; expected less than its outer diameter, {}; check the two diameters",
                 mm(spacer.inner_diameter), mm(spacer.outer_diameter));
  else if (spacer.inner_diameter >= nut.outer_diameter)
    problems.add("preload.spacer.inner_diameter",
                 "got {}; expected less than the nut's outer diameter, {}, or the ring misses the "
                 "faces of the nuts; make it smaller",
                 mm(spacer.inner_diameter), mm(nut.outer_diameter));
  else if (m.pitch_diameter.screw && spacer.inner_diameter <= *m.pitch_diameter.screw)
    problems.add("preload.spacer.inner_diameter",
                 "got {}; expected more than the screw's pitch diameter, {}, or the ring cuts into the screw; make it "
                 "larger",
                 mm(spacer.inner_diameter), mm(*m.pitch_diameter.screw));
  else if (m.pitch_diameter.nut && spacer.outer_diameter <= *m.pitch_diameter.nut)
    problems.add("preload.spacer.outer_diameter",
                 "got {}; expected more than the nut's pitch diameter, {}, or the ring misses the "
                 "faces of the nuts; make it larger",
                 mm(spacer.outer_diameter), mm(*m.pitch_diameter.nut));
}

/// The rollers of the second nut must lie on it, and clear those of the first.
void check_distance(const Preload& p, const Structure& s, const Mechanism& m, Problems& problems) {
  const double span = (m.contacts_per_roller - 1) * axial_pitch(m);
  const double least = *p.distance - second_position(m, s.nut, p);
  const double most = least + s.nut.length - span;
  const double tolerance = kSamePlace * s.nut.length;
  const double ends = axial_pitch(m) + 2.0 * s.roller.end_length;
  if (*p.distance < least - tolerance || *p.distance > most + tolerance)
    problems.add("preload.distance",
                 "got {}; expected {} to {}, so that all {} contacts lie on the second nut; move "
                 "its rollers or change the spacer",
                 mm(*p.distance), mm(least), mm(std::max(least, most)), m.contacts_per_roller);
  else if (*p.distance < ends - tolerance)
    problems.add("preload.distance",
                 "got {}; expected at least {}, a pitch and two ends of a roller, or the rollers "
                 "of both nuts overlap; move them apart",
                 mm(*p.distance), mm(ends));
}

}  // namespace

void check_position(std::string_view block, double position, const Mechanism& m, const Structure::Nut& nut,
                    Problems& problems) {
  const RoomOnNut room(m, nut);
  if (room.holds(position)) return;
  if (room.none())
    problems.add("mechanism.contacts_per_roller",
                 "got {}, which span {}; expected contacts within the nut's length, {}; take at "
                 "most {} or lengthen the nut",
                 m.contacts_per_roller, mm(room.span), mm(nut.length),
                 1 + static_cast<int>((nut.length + room.tolerance) / axial_pitch(m)));
  else
    problems.add(fmt::format("{}.position", block),
                 "got {}; expected 0 mm to {}, so that all {} contacts lie on the nut; move the "
                 "roller or lengthen the nut",
                 mm(position), mm(std::max(room.last, 0.0)), m.contacts_per_roller);
}

void check_thrust(Direction direction, std::string_view load, const Structure::Nut& nut, Problems& problems) {
  if (direction == Direction::tension ? nut.thrust.tension : nut.thrust.compression) return;
  problems.add(fmt::format("structure.nut.thrust.{}", name(direction)),
               "missing; expected the axial position of the section that holds {} in case `{}`; "
               "add `{}: 10 mm`, for example",
               name(direction), load, name(direction));
}

void check_load_cases(const Case& c, Problems& problems) {
  // Longest list of names that is compared pair by pair, which takes no memory: designs of a study have few.
  constexpr std::size_t kFew = 64;
  std::unordered_set<std::string_view> names;
  const auto is_repeated = [&](const LoadCase& load) {
    if (c.load_cases.size() > kFew) return !names.insert(load.name).second;
    const LoadCase* first = c.load_cases.data();
    return std::any_of(first, &load, [&](const LoadCase& l) { return l.name == load.name; });
  };
  std::optional<RoomOnNut> room;
  if (c.structure) room.emplace(c.mechanism, c.structure->nut);
  for (const LoadCase& load : c.load_cases) {
    if (is_repeated(load))
      problems.add(load.input_path + ".name",
                   "got `{}` a second time; expected names that differ, ranges expanded; rename this case", load.name);
    check_force(load, c.preload && !c.preload->backlash, problems);
    if (load.share == LoadCase::Share::equal || !c.structure || !load.direction || !load.position) continue;
    if (!room->holds(*load.position))
      check_position(load.input_path, *load.position, c.mechanism, c.structure->nut, problems);
    check_thrust(*load.direction, load.name, c.structure->nut, problems);
  }
}

void check_loads(const Case& c, Problems& problems) {
  if (c.model.loads != ModelOptions::Loads::running) return;
  if (!c.friction)
    problems.add_missing("friction", "a law of friction for `model: {loads: running}`", "{model: {coulomb: 0.1}}");
  const auto check_share = [&](LoadCase::Share share, std::string path) {
    if (share == LoadCase::Share::equal)
      problems.add(std::move(path),
                   "got `equal` with `model: {loads: running}`, whose loads are solved; expected "
                   "`solved`; delete it, or write `loads: static`");
  };
  bool has_speed = !c.life || c.operation.has_value();
  for (const LoadCase& load : c.load_cases) {
    check_share(load.share, path_in(load, "share"));
    has_speed = has_speed && (load.speed || c.operation);
  }
  if (c.life) check_share(c.life->share, "life.share");
  if (!has_speed) problems.add_missing("operation", "the speed for `model: {loads: running}`", "{speed: 400 rpm}");
}

void check_preload(const Case& c, Problems& problems) {
  const Preload& p = *c.preload;
  const Mechanism& m = c.mechanism;
  check_offset("preload.interference", p.interference.value_or(0.0), m, problems);
  check_offset("preload.backlash", p.backlash.value_or(0.0), m, problems);
  if (!(p.load.from < p.load.to))
    problems.add("preload.load.to", "got {}; expected more than `from`, {}; swap the two", newton(p.load.to),
                 newton(p.load.from));
  if (p.load_case && !warms(c.heat) && std::ranges::none_of(c.load_cases, [&](const LoadCase& load) {
        return load.name == *p.load_case || load.name.starts_with(*p.load_case + "[");  // `pull[0]` of a range.
      }))
    problems.add("preload.load_case",
                 "got {}; expected the name of a load case; write that of one in the file, or delete the key",
                 *p.load_case);
  if (!c.structure) return;
  const Structure& s = *c.structure;
  if (!s.nut.thrust.tension && !s.nut.thrust.compression)
    problems.add("structure.nut.thrust",
                 "missing; expected the axial position of the section that holds the nut; add "
                 "`thrust: {tension: 10 mm}`, for example: one section holds both senses of the "
                 "load");
  check_position("preload", p.position, m, s.nut, problems);
  if (p.arrangement != Preload::Arrangement::double_nut) return;
  check_spacer(*p.spacer, s.nut, m, problems);
  const double last = p.position + (m.contacts_per_roller - 1) * axial_pitch(m);
  const double tolerance = kSamePlace * s.nut.length;
  if (p.position >= -tolerance && last <= s.nut.length + tolerance) check_distance(p, s, m, problems);
}

void require_warm_preload(const Case& c, Problems& problems) {
  if (!warms(c.heat) || !c.preload) return;
  std::string names;
  bool found = false;
  for (const LoadCase& load : c.load_cases) {
    if (!load.is_solved()) continue;
    names += (names.empty() ? "" : ", ") + load.name;
    found = found || !c.preload->load_case || load.name == *c.preload->load_case;
  }
  if (!found)
    problems.add("preload.load_case",
                 "{}; expected the load case whose steady temperatures the parts have with "
                 "`heat`: {}; {}",
                 c.preload->load_case ? "got " + *c.preload->load_case : "missing",
                 names.empty() ? "the file has none that is solved" : names,
                 names.empty() ? "add one, or delete `heat`" : "write one of them");
  require_slip(c, problems);
  require_expansion(c, problems);
}

void require_preload(const Case& c, Problems& problems) {
  if (!c.preload)
    problems.add_missing("preload", "what takes out the play, and the loads, for `preload`",
                         "{arrangement: single_nut, force: 2 kN, position: 10 mm, load: {from: -10 kN, to: 10 "
                         "kN}}");
  if (!c.materials) problems.add_missing("materials", "elastic properties for `preload`", kMaterialsExample);
  if (!c.structure)
    problems.add_missing("structure", "the parts around the threads for `preload`",
                         "{roller: {end_length: 5 mm, end_diameter: 5 mm}, nut: {length: 90 mm, outer_diameter: "
                         "46 mm, thrust: {tension: 10 mm}}}");
  if (c.model.all_rollers())
    problems.add("model.mechanism",
                 "got full, whose rollers touch one flank; expected sector, which joins both for "
                 "`preload`; write `mechanism: sector` and see the rollers of the loaded flank by "
                 "`solve`");
  if (!c.model.bodies->both_flanks)
    problems.add("model.bodies",
                 "got {}; expected bars | refined: `preload` joins both sides in one "
                 "one-dimensional model; write `bodies: refined`",
                 c.model.bodies->name);
}

void need_preload(const Case& c, Problems& problems) {
  require_preload(c, problems);
  require_warm_preload(c, problems);
}

namespace {

/// How long the loads of a spectrum act: all by shares, or none.
void check_spectrum(const Case& c, Problems& problems) {
  double shares = 0.0, way = 0.0;
  const double lead = std::abs(c.mechanism.lead);
  for (std::size_t i = 0; i < c.life->spectrum.size(); ++i) {
    const SpectrumLoad& l = c.life->spectrum[i];
    const std::string path = fmt::format("life.spectrum[{}]", i);
    shares += l.share.value_or(0.0);
    way += l.distance.value_or(l.revolutions.value_or(0.0) * lead);
    if (l.force == 0.0 && !(c.preload && !c.preload->backlash))
      problems.add(path + ".force",
                   "got 0 N; expected a force > 0, or a `preload`, under which threads roll without one; delete the "
                   "load, or add `preload`");
    if (l.share.has_value() != c.life->spectrum.front().share.has_value())
      problems.add(path,
                   "mixes `share` with revolutions, distance or duration; expected shares of "
                   "all loads, or of none; change one kind into the other");
    if (l.duration && !(c.operation && c.operation->speed != 0.0))
      problems.add(path + ".duration",
                   "got a duration without speed; expected the speed that turns it into "
                   "revolutions; add `operation: {speed: 400 rpm}`, for example");
    if (c.structure && !c.preload && c.life->share == LoadCase::Share::solved)
      check_thrust(l.direction, path, c.structure->nut, problems);
  }
  if (c.life->travel && *c.life->travel < (1.0 - 1e-9) * way)
    problems.add(
        "life.travel",
        "got {}; expected at least {}, the travel under the loads of the spectrum; add the travel without load",
        mm(*c.life->travel), mm(way));
  if (c.life->spectrum.front().share && std::abs(shares - 1.0) > 1e-3)
    problems.add("life.spectrum",
                 "got shares with the sum {:.6g}; expected 1, within 0.001; fix a share, or write "
                 "revolutions",
                 shares);
}

/// Checks that the turning of the screw between two samples is known.
void check_history(const Case& c, Problems& problems) {
  const HistorySource& h = *c.life->history;
  if (h.position) return;
  if (!h.time && !h.interval)
    problems.add("life.history",
                 "got neither `position` nor a clock; expected how far the screw turns between two "
                 "samples; add `position: {column: .., unit: mm}`, or `time: {column: .., unit: s}` "
                 "or `interval: 10 ms`, for example");
  else if (!h.speed && !(c.operation && c.operation->speed != 0.0))
    problems.add("life.history",
                 "got neither `position` nor a speed; expected how far the screw turns between two "
                 "samples; add `speed: {column: .., unit: rpm}` or `operation: {speed: 400 rpm}`, "
                 "for example");
}

/// Checks the inputs from which the sides of a preloaded mechanism are made.
void check_preloaded_life(const Case& c, Problems& problems) {
  if (c.preload->arrangement == Preload::Arrangement::double_nut && c.life->position &&
      std::abs(*c.life->position - c.preload->position) > kSamePlace * c.structure->nut.length)
    problems.add("life.position",
                 "got {} and preload.position {}; expected one place with `arrangement: "
                 "double_nut`, whose second nut goes with it; change one of them",
                 mm(*c.life->position), mm(c.preload->position));
}

/// Checks the load case whose side loads act together with the forces of `life`.
void check_load_case_of_life(const Case& c, Problems& problems) {
  if (!c.life->load_case || !c.model.all_rollers()) return;
  if (c.life->share == LoadCase::Share::equal) {
    problems.add("life.load_case",
                 "cannot be combined with `share: equal`, by which all rollers carry the same; expected no such "
                 "key there; delete it, or delete `share`");
    return;
  }
  std::string names;
  for (const LoadCase& load : c.load_cases) {
    if (load.share == LoadCase::Share::equal) continue;
    if (load.name == *c.life->load_case) return;
    names += (names.empty() ? "" : ", ") + load.name;
  }
  problems.add("life.load_case",
               "got {}; expected the name of a load case that is solved: {}; write one of them, or "
               "delete the key",
               *c.life->load_case, names.empty() ? "the file has none" : names);
}

/// Requires a choice of load case if side loads differ between them.
void require_load_case_of_life(const Case& c, Problems& problems) {
  if (!c.model.all_rollers() || c.life->load_case || c.life->share == LoadCase::Share::equal) return;
  const SpatialLoad* first = nullptr;
  for (const LoadCase& load : c.load_cases) {
    if (load.share == LoadCase::Share::equal) continue;
    if (!first) first = &load.spatial;
    if (load.spatial == *first) continue;
    problems.add("life.load_case",
                 "missing; expected the load case whose side loads, misalignment and orbit act together "
                 "with the forces of `life`, since load cases differ in them; add `load_case: {}`, for example",
                 load.name);
    return;
  }
}

/// Requirements of the losses that give the temperatures of the parts.
void require_warm_life(const Case& c, Problems& problems) {
  constexpr std::string_view kWhy =
      " for `life` at the temperatures of `heat`, or "
      "`life: {temperatures: reference}`";
  if (!c.friction) problems.add_missing("friction", fmt::format("a law of friction{}", kWhy), "{model: jacod}");
  if (!c.operation)
    problems.add_missing("operation", fmt::format("the speed{}", kWhy), "{speed: 400 rpm}");
  else if (c.operation->speed == 0.0)
    problems.add("operation.speed", fmt::format("got 0 rpm; expected a speed other than 0{}", kWhy));
  require_friction(c, problems);
  require_expansion(c, problems);
}

}  // namespace

void check_life(const Case& c, Problems& problems) {
  if (c.structure && c.life->share == LoadCase::Share::solved)
    check_position("life", *c.life->position, c.mechanism, c.structure->nut, problems);
  if (c.life->history)
    check_history(c, problems);
  else
    check_spectrum(c, problems);
  if (c.preload && c.structure) check_preloaded_life(c, problems);
  check_load_case_of_life(c, problems);
}

void need_life(const Case& c, Problems& problems) {
  if (!c.life)
    problems.add_missing("life", "the loads and how long they act for `life`",
                         "{position: 10 mm, spectrum: [{force: 10 kN, direction: tension, share: 1}]}");
  if (!c.materials) problems.add_missing("materials", "elastic properties for `life`", kMaterialsExample);
  if (!c.structure && c.life && c.life->share == LoadCase::Share::solved)
    problems.add("structure",
                 "missing; expected the parts around the threads for `life`; add `structure` with "
                 "`roller` and `nut`, or `share: equal` to `life`");
  if (!c.life) return;
  if (life_takes_running_loads(c)) require_friction(c, problems);
  if (c.life->takes_heat(warms(c.heat))) require_warm_life(c, problems);
  require_load_case_of_life(c, problems);
  if (!c.preload) return;
  if (c.model.all_rollers() && c.life->share == LoadCase::Share::solved)
    problems.add("preload",
                 "got a preload with `mechanism: full`, whose flanks of the other sense are not in "
                 "the model; expected one of them; write `mechanism: sector`, or delete `preload`");
  else
    require_preload(c, problems);
}

void check_measures(const Case& c, Problems& problems) {
  const MeasureOptions& m = *c.measures;
  if (m.shaft && m.shaft->stroke && c.structure && carrier_part(c.mechanism.type) == Part::nut)
    if (const double least = *m.shaft->stroke + c.structure->nut.length; m.shaft->length < least)
      problems.add("measures.shaft.length",
                   "got {}; expected at least {}, the stroke of {} and the nut's length; lengthen the shaft or shorten "
                   "the stroke",
                   mm(m.shaft->length), mm(least), mm(*m.shaft->stroke));
  if (m.system && m.system->support_bearing && c.bearings && c.bearings->fixed.stiffness)
    problems.add("measures.system.support_bearing",
                 "got a stiffness next to `bearings.fixed.stiffness`; expected one of them; delete the other");
  if (!m.system || !m.system->shaft) return;
  const MeasureOptions::System::Shaft& shaft = *m.system->shaft;
  if (shaft.from_bearing && *shaft.from_bearing >= shaft.length)
    problems.add("measures.system.shaft.from_bearing",
                 "got {}; expected less than `length`, {}, between whose ends the loaded section "
                 "lies; change one of them",
                 mm(*shaft.from_bearing), mm(shaft.length));
}

}  // namespace prs
