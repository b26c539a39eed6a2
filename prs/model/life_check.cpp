#include "prs/model/block_checks.h"
#include "prs/model/quantity_text.h"

namespace prs {
namespace {

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
    if (c.structure && !c.preload && c.life->share == LoadCase::Share::solved)
      check_thrust(l.direction, path, c.structure->nut, problems);
  }
  if (c.life->spectrum.front().share && std::abs(shares - 1.0) > 1e-3)
    problems.add("life.spectrum",
                 "got shares with the sum {:.6g}; expected 1, within 0.001; fix a share, or write "
                 "revolutions",
                 shares);
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

/// With preload, what the sides are built from.
void check_preloaded_life(const Case& c, Problems& problems) {
  if (c.preload->arrangement == Preload::Arrangement::double_nut && c.life->position &&
      std::abs(*c.life->position - c.preload->position) > kSamePlace * c.structure->nut.length)
    problems.add("life.position",
                 "got {} and preload.position {}; expected one place with `arrangement: "
                 "double_nut`, whose second nut goes with it; change one of them",
                 mm(*c.life->position), mm(c.preload->position));
}

/// The load case whose side loads act together with the forces of `life`.
void check_load_case_of_life(const Case& c, Problems& problems) {
  if (!c.life->load_case || c.model.mechanism == ModelOptions::Mechanism::sector) return;
  if (c.life->share == LoadCase::Share::equal) {
    problems.add("life.load_case",
                 "stands with `share: equal`, which has all rollers carry alike; expected no such "
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

/// Side loads that differ between load cases leave open which act together with the forces.
void require_load_case_of_life(const Case& c, Problems& problems) {
  if (c.model.mechanism == ModelOptions::Mechanism::sector || c.life->load_case ||
      c.life->share == LoadCase::Share::equal)
    return;
  const SpatialLoad* first = nullptr;
  for (const LoadCase& load : c.load_cases) {
    if (load.share == LoadCase::Share::equal) continue;
    if (!first) first = &load.spatial;
    if (load.spatial == *first) continue;
    problems.add(
        "life.load_case",
        "missing; expected the load case whose side loads, misalignment and orbit act together "
        "with the forces of `life`, as they differ; add `load_case: {}`, for example",
        load.name);
    return;
  }
}

/// What the losses need that give the temperatures of the parts.
void require_warm_life(const Case& c, Problems& problems) {
  constexpr std::string_view kWhy =
      " for `life` at the temperatures of `heat`, or "
      "`life: {temperatures: reference}`";
  if (!c.friction)
    problems.add_missing("friction", fmt::format("a law of friction{}", kWhy), "{model: jacod}");
  if (!c.operation || c.operation->speed == 0.0)
    problems.add_missing("operation", fmt::format("the speed{}", kWhy), "{speed: 400 rpm}");
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
    problems.add_missing(
        "life", "the loads and how long they act for `life`",
        "{position: 10 mm, spectrum: [{force: 10 kN, direction: tension, share: 1}]}");
  if (!c.materials)
    problems.add_missing("materials", "elastic properties for `life`", kMaterialsExample);
  if (!c.structure && c.life && c.life->share == LoadCase::Share::solved)
    problems.add("structure",
                 "missing; expected the parts around the threads for `life`; add `structure` with "
                 "`roller` and `nut`, or `share: equal` to `life`");
  if (!c.life) return;
  if (life_takes_running_loads(c)) require_friction(c, problems);
  if (c.life->takes_heat(c.heat.has_value())) require_warm_life(c, problems);
  require_load_case_of_life(c, problems);
  if (!c.preload) return;
  if (c.model.mechanism == ModelOptions::Mechanism::full &&
      c.life->share == LoadCase::Share::solved)
    problems.add("preload",
                 "got a preload with `mechanism: full`, whose flanks of the other sense are not in "
                 "the model; expected one of them; write `mechanism: sector`, or delete `preload`");
  else
    require_preload(c, problems);
}

}  // namespace prs
