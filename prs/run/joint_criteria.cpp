#include "prs/run/joint_criteria.h"

#include <fmt/format.h>

#include "prs/indices.h"
#include "prs/loads/load_criteria.h"
#include "prs/losses/slip_criteria.h"
#include "prs/measures/measures_criteria.h"
#include "prs/model/check_case.h"
#include "prs/preload/preloaded_mechanism.h"

namespace prs {
namespace {

constexpr double kTouching = 1e-9 * "mm"_per_si;  ///< Play of threads that touch [mm].

/// Threads that overlap before any load; none where they have no contact.
std::optional<FoundCriterion> axial_play(const Contacts& contacts) {
  FoundCriterion found("axial_play");
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = contacts.interfaces[i];
    const contact::Thread& body = thread_of(contacts.threads, body_of(i));
    const std::string at = fmt::format("roller-{}", name(i));
    if (contact.geometry.point.ok() && contact::same_pitch(body, contacts.threads.roller))
      found.take(contact.geometry.point.backlash * "mm"_per_si, "", at);
    if (!contact.clearance) continue;
    for (const auto& crest : {contact.clearance->body_crest, contact.clearance->roller_crest})
      if (crest) found.take(2.0 * *crest * "mm"_per_si, "", at + ", at a crest");
  }
  if (!found.value) return std::nullopt;
  found.best.reset();  // At another place.
  found.limit = 0.0;
  found.standing = *found.value < -kTouching ? Standing::red : Standing::green;
  if (found.standing == Standing::red) found.note += ": the threads interfere";
  return found;
}

/// A count below the least that is usual.
std::optional<FoundCriterion> few(CriterionKey key, int count, int least, const char* note) {
  if (count >= least) return std::nullopt;
  FoundCriterion found(key);
  found.value = count;
  found.limit = least;
  found.standing = Standing::amber;
  found.note = note;
  return found;
}

/// Supports of the screw between which its nut does not fit.
std::optional<FoundCriterion> short_shaft(const Case& c) {
  if (!c.structure || !c.measures || !c.measures->shaft || carrier_part(c.mechanism.type) != Part::nut ||
      c.measures->shaft->length >= c.structure->nut.length)
    return std::nullopt;
  FoundCriterion found("shaft_length");
  found.value = c.measures->shaft->length * "mm"_per_si;
  found.limit = c.structure->nut.length * "mm"_per_si;
  found.standing = Standing::red;
  found.note = "the nut is longer";
  return found;
}

/// Ends of rollers that overlap those of their neighbours, or the core of the screw's thread.
std::optional<FoundCriterion> thick_ends(const Case& c, const Mechanism& m) {
  if (!c.structure || !m.centre_distance || !m.pitch_diameter.screw) return std::nullopt;
  const double core = *m.pitch_diameter.screw - axial_pitch(m);
  const double beside_screw = 2.0 * *m.centre_distance - core,
               beside_neighbour = 2.0 * *m.centre_distance * std::sin(std::numbers::pi / std::max(m.rollers, 2));
  FoundCriterion found("roller_ends");
  found.limit = std::min(beside_screw, beside_neighbour) * "mm"_per_si;
  found.value = c.structure->roller.end_diameter * "mm"_per_si;
  if (*found.value <= *found.limit) return std::nullopt;
  found.standing = Standing::red;
  found.note = beside_screw < beside_neighbour ? "the ends stand in the screw" : "the ends of neighbours overlap";
  return found;
}

/// A size of the nut's body: room is left for flanges.
void take_nut(const Case& c, double Structure::Nut::*size, FoundCriterion& found) {
  found.why = "add structure";
  if (c.structure)
    found.take(c.structure->nut.*size * "mm"_per_si, "", c.structure->nut.flanges.empty() ? "" : "without flanges");
}

/// A value that follows from the worst of another quantity.
FoundCriterion following(CriterionKey key, const FoundCriterion& other, std::optional<double> value) {
  FoundCriterion found(key, other.why);
  found.take(value, other.where, other.note);
  found.best.reset();
  return found;
}

}  // namespace

std::vector<FoundCriterion> case_criteria(const Case& c, const Contacts& contacts) {
  FoundCriterion speed("largest_speed", "add operation.speed"), compression("largest_compression"),
      tension("largest_tension"), diameter("nut_diameter"), length("nut_length"),
      stroke = stroke_criterion(c, "add life.stroke");
  for (const LoadCase& load : c.load_cases) {
    if (load.speed) speed.take(std::abs(*load.speed), load.name);
    if (axial_force_on_nut(load) < 0.0) compression.take(std::abs(load.axial_force), load.name);
  }
  if (c.life)
    for (const SpectrumLoad& load : c.life->spectrum)
      if (load.force > 0.0)
        (load.direction == Direction::compression ? compression : tension).take(load.force, "life.spectrum");
  if (c.measures && c.measures->shaft)
    compression.take(c.measures->shaft->largest_compression, "measures.shaft.largest_compression");
  if (c.operation) {
    speed.take(std::abs(c.operation->speed), "", "operation.speed");
    speed.take(c.operation->largest_speed, "", "operation.largest_speed");
  }
  take_nut(c, &Structure::Nut::outer_diameter, diameter);
  take_nut(c, &Structure::Nut::length, length);
  if (const auto loaded = loaded_length(c); loaded && c.life->stroke)
    stroke.take(*c.life->stroke / *loaded, "life.stroke", "life of shorter strokes needs a calculation of its own");
  std::vector<FoundCriterion> all{speed, compression, tension, diameter, length, stroke};
  if (!c.heat) all.push_back({"temperature", "add heat"});
  for (std::optional<FoundCriterion>& found : std::array{
           axial_play(contacts),
           few("contacts_per_roller", c.mechanism.contacts_per_roller, 8,  // Catalogues have 20 contacts and more.
               "makers' nuts have more: check the length of the nut"),
           few("rollers", c.mechanism.rollers, 3, "fewer do not centre the screw"), thick_ends(c, contacts.mechanism),
           short_shaft(c)})
    if (found) all.push_back(*found);
  return all;
}

std::optional<MeasuresResult> measures_under_load(const Case& c) {
  const auto is_idle = [](const LoadCase& load) { return load.axial_force == 0.0; };
  Case loaded = c;
  if (std::erase_if(loaded.load_cases, is_idle) == 0 || loaded.load_cases.empty()) return std::nullopt;
  return missing(loaded, Command::measures).empty() ? std::optional(analyze_measures(loaded)) : std::nullopt;
}

std::optional<MeasuresResult> warm_measures(const Case& c, const MeasuresResult& measures, const Result* slip) {
  if (!warms(c.heat) || !slip) return std::nullopt;
  MeasuresResult warm = measures;
  for (const auto k : indices(warm.load_measures)) {
    Conditions of_case = c;
    of_case.load_cases = {warm.analysis.load_cases[k].load_case};
    const auto place = std::ranges::find(c.load_cases, of_case.load_cases.front().name, &LoadCase::name);
    of_case.deviations.temperature = temperature_of(*slip, c, static_cast<std::size_t>(place - c.load_cases.begin()));
    if (!of_case.deviations.temperature) return std::nullopt;
    MeasuresResult one = analyze_measures(of_case, measures.analysis.contacts);
    warm.load_measures[k] = std::move(one.load_measures.front());
    warm.analysis.load_cases[k] = std::move(one.analysis.load_cases.front());
  }
  return warm;
}

std::optional<PreloadedLoads> loads_under_preload(const Case& c, const Contacts& contacts, const Result* slip) {
  PreloadedLoads found;
  found.loads.contacts = contacts;
  for (const auto k : indices(c.load_cases)) {
    const LoadCase& load = c.load_cases[k];
    if (!has_both_flanks(c, load.share)) continue;
    Conditions warm = c;
    if (const auto temperature = slip ? temperature_of(*slip, c, k) : std::nullopt)
      warm.deviations.temperature = temperature;
    found.loads.load_cases.push_back(FlankSolver(warm, contacts).solve(load));
    found.forces.push_back(load.axial_force > 0.0
                               ? solved_static_forces(warm, contacts, *load.direction, *load.position, load.axial_force)
                               : StaticForces{});
  }
  return found.forces.empty() ? std::nullopt : std::optional(std::move(found));
}

std::vector<FoundCriterion> preloaded_criteria(const PreloadedLoads& preloaded, const JudgedCase& of,
                                               const MeasuresResult* measures) {
  FoundCriterion safety = static_safety_criterion(of.c), edge("flank_edge");
  for (const auto k : indices(preloaded.forces)) {
    const auto& [rating, edge_load] = preloaded.forces[k];
    const LoadCase& load = preloaded.loads.load_cases[k].load_case;
    if (rating)
      safety.take(rating->force / load.axial_force, load.name, describe(rating->limit) + ", at rest under preload");
    if (edge_load) edge.take(*edge_load / load.axial_force, load.name, "at rest under preload");
  }
  const bool is_play = of.c.preload->backlash.has_value();
  return {pressure_criterion(preloaded.loads, of, false), safety, edge,
          is_play
              ? FoundCriterion("stiffness")
              : stiffness_criterion(preloaded.loads, of, measures ? in_series_of(*measures, of) : InSeriesOf{}, true),
          convergence(failed_cases(preloaded.loads, "thread loads under preload",
                                   [](const LoadCaseResult& r) { return r.converged(); }))};
}

std::vector<FoundCriterion> criteria_under(const JudgedCase& of, const Contacts& contacts,
                                           const std::optional<PerPart<double>>& temperature, bool solves,
                                           Direction direction, const FoundCriterion& force) {
  const Case& c = of.c;
  FoundCriterion safety("static_safety"), edge("flank_edge"), bearing("bearing_static_safety");
  const double largest = *force.value;
  const std::string note = fmt::format("largest force in {}", name(direction));
  const auto take = [&](FoundCriterion& found, const std::optional<double>& load, const std::string& what) {
    if (load) found.take(*load / largest, force.where, note + what);
    found.best.reset();  // The best value is one of load cases.
  };
  if (c.bearings) take(bearing, c.bearings->fixed.static_capacity, "");
  double position = std::numeric_limits<double>::quiet_NaN();
  if (c.life && c.life->position)
    position = *c.life->position;
  else if (!c.load_cases.empty())
    position = c.load_cases[0].position.value_or(position);
  if (c.life && c.life->static_capacity) take(safety, c.life->static_capacity, ", stated static capacity");
  if (solves && std::isfinite(position) && missing(c, Command::solve).empty()) try {
      Conditions warm = c;
      if (temperature) warm.deviations.temperature = temperature;
      const StaticForces found = solved_static_forces(warm, contacts, direction, position, largest);
      if (found.rating && !safety.value)
        take(safety, found.rating->force, fmt::format(", {}, {}", describe(found.rating->limit), of.at_rest()));
      take(edge, found.flank_edge_load, ", " + of.at_rest());
    } catch (const CaseError&) {  // Nothing holds the nut in that sense: said where its loads are needed.
    }
  std::vector<FoundCriterion> all;
  for (const FoundCriterion& found : {safety, edge, bearing})
    if (found.value) all.push_back(found);
  return all;
}

FoundCriterion buckling_safety(const Case& c, const MeasuresResult& measures, const FoundCriterion& compression,
                               bool is_unknown) {
  const auto& load = measures.measures.buckling_load;
  FoundCriterion found("buckling_safety", !compression.value && !is_unknown ? "no load compresses the screw"
                                          : lacks_shaft(c)                  ? kAddShaft
                                          : compression.value
                                              ? "no buckling load"
                                              : "no load case compresses the screw, others were not computed");
  found.applies = compression.value || is_unknown;
  if (!compression.value || !load) return found;
  found.take(*load / *compression.value, compression.where, compression.note);
  if (compression.best) found.best = *load / *compression.best;
  return found;
}

FoundCriterion critical_speed_share(const Case& c, const MeasuresResult& measures, const FoundCriterion& speed) {
  const auto& critical = measures.measures.critical_speed;
  const bool turns = carrier_part(c.mechanism.type) == Part::nut;
  if (speed.value && critical) return following("critical_speed_share", speed, *speed.value / *critical);
  FoundCriterion found("critical_speed_share", !turns           ? "the nut turns, not the screw"
                                               : lacks_shaft(c) ? kAddShaft
                                               : !critical && c.materials && !c.materials->screw.density
                                                   ? "add materials.screw.density"
                                               : !critical ? "no critical speed"
                                                           : std::string_view(speed.why));
  found.applies = turns;
  return found;
}

FoundCriterion speed_times_diameter(const Case& c, const FoundCriterion& speed) {
  std::optional<double> value = speed.value;
  if (value) *value = *value * "rpm"_per_si * *c.mechanism.pitch_diameter.screw * "mm"_per_si;
  return following("speed_times_diameter", speed, value);
}

}  // namespace prs
