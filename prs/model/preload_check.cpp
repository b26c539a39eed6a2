#include "prs/model/block_checks.h"

#include <algorithm>

#include "prs/model/quantity_text.h"

namespace prs {
namespace {

void check_spacer(const Spacer& spacer, const Structure::Nut& nut, const Mechanism& m,
                  Problems& problems) {
  if (spacer.inner_diameter >= spacer.outer_diameter)
    problems.add("preload.spacer.inner_diameter",
                 "got {}; expected less than its outer diameter, {}; check the two diameters",
                 mm(spacer.inner_diameter), mm(spacer.outer_diameter));
  else if (spacer.inner_diameter >= nut.outer_diameter)
    problems.add("preload.spacer.inner_diameter",
                 "got {}; expected less than the nut's outer diameter, {}, or the ring misses the "
                 "faces of the nuts; make it smaller",
                 mm(spacer.inner_diameter), mm(nut.outer_diameter));
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

void check_preload(const Case& c, Problems& problems) {
  const Preload& p = *c.preload;
  const Mechanism& m = c.mechanism;
  check_offset("preload.interference", p.interference.value_or(0.0), m, problems);
  check_offset("preload.backlash", p.backlash.value_or(0.0), m, problems);
  if (!(p.load.from < p.load.to))
    problems.add("preload.load.to", "got {}; expected more than `from`, {}; swap the two",
                 newton(p.load.to), newton(p.load.from));
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
  if (p.position >= -tolerance && last <= s.nut.length + tolerance)
    check_distance(p, s, m, problems);
}

void require_warm_preload(const Case& c, Problems& problems) {
  if (!c.heat || !c.preload) return;
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
    problems.add_missing(
        "preload", "what takes out the play, and the loads, for `preload`",
        "{arrangement: single_nut, force: 2 kN, position: 10 mm, load: {from: -10 kN, to: 10 "
        "kN}}");
  if (!c.materials)
    problems.add_missing("materials", "elastic properties for `preload`", kMaterialsExample);
  if (!c.structure)
    problems.add_missing(
        "structure", "the parts around the threads for `preload`",
        "{roller: {end_length: 5 mm, end_diameter: 5 mm}, nut: {length: 90 mm, outer_diameter: "
        "46 mm, thrust: {tension: 10 mm}}}");
  if (c.model.mechanism == ModelOptions::Mechanism::full)
    problems.add("model.mechanism",
                 "got full, whose rollers touch one flank; expected sector, which joins both for "
                 "`preload`; write `mechanism: sector` and see the rollers of the loaded flank by "
                 "`solve`");
  if (c.model.bodies == ModelOptions::Bodies::influence)
    problems.add("model.bodies",
                 "got influence; expected bars | refined: `preload` joins both sides in one "
                 "one-dimensional model; write `bodies: refined`");
}

void need_preload(const Case& c, Problems& problems) {
  require_preload(c, problems);
  require_warm_preload(c, problems);
}

}  // namespace prs
