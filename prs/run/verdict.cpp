#include "prs/run/check.h"

#include <fmt/ranges.h>

#include "prs/life/life_record.h"
#include "prs/life/load_history.h"
#include "prs/loads/full_result.h"
#include "prs/loads/load_record.h"
#include "prs/losses/motor_demand.h"

namespace prs {
namespace {

constexpr double kRounding = 1e-9;                       ///< Relative, of a value that just meets its limit.
constexpr double kTouching = 1e-9 * per_si::millimetre;  ///< Play of threads that touch [mm].

/// What a case has of a criterion: the worst value, or why there is none.
struct Found {
  Sense sense = Sense::least;
  std::optional<double> value = {}, best = {};
  std::string where = {}, note = {}, why = {};
  std::string_view title = {};          ///< Title if it is not that of the row.
  std::optional<double> physical = {};  ///< Physical limit, where the row has none.
  bool applies = true;
  bool asked = true;

  /// NaN is no value.
  void take(double v, std::string_view load_case, std::string_view what = {}) {
    if (std::isnan(v)) return;
    const auto worse = [&](double a, double b) { return sense == Sense::least ? a < b : a > b; };
    if (!best || worse(*best, v)) best = v;
    if (value && !worse(v, *value)) return;
    value = v;
    where = load_case;
    note = what;
  }
  void take(const std::optional<double>& v, std::string_view load_case, std::string_view what = {}) {
    if (v) take(*v, load_case, what);
  }
};

/// A command that gives the value was not run.
Found without(const VerdictFacts& f, Command command, Sense sense) {
  Found found{sense};
  const auto lacking = f.lacking.find(command);
  found.asked = lacking != f.lacking.end();
  if (found.asked) found.why = lacking->second;
  return found;
}

/// A drive could not be computed, and might be worse.
void note_response(const VerdictFacts& f, Found& found) {
  if (found.value && f.lacking.contains(Command::response))
    found.note += found.note.empty() ? "without `response`" : ", without `response`";
}

std::string_view loads_of(const LifeResult& life) { return life.history ? "life.history" : "life.spectrum"; }

Found life(const VerdictFacts& f) {
  if (!f.life) return without(f, Command::life, Sense::least);
  Found found;
  const LifeResult& r = *f.life;
  if (!r.converged()) {
    found.why = "the life did not converge";
    return found;
  }
  // A maker's capacity comes from real screws: uneven sharing is in it.
  const LifeInUse in = in_use(r, r.lemor ? r.system_life : r.catalogue_life);
  const std::string note = fmt::format(
      "{:g} % reach it; {}{}", r.life.reliability * per_si::percent,
      r.lemor ? r.life.share == LoadCase::Share::solved ? "real thread loads" : "equal thread loads"
              : "stated C_a already includes uneven sharing",
      r.modified ? fmt::format("; {:.3g} times as long with film and dirt by ISO 281", r.modified->factor) : "");
  const bool as_travel = f.limits.life ? f.limits.life->travel.has_value() : !in.hours.has_value();
  if (as_travel)
    found.take(in.rated * in.travel * per_si::kilometre, loads_of(r), note);
  else if (in.hours)
    found.take(in.rated * *in.hours, loads_of(r), r.duration ? note : note + "; hours of motion");
  else
    found.why = "hours need `operation.speed`";
  if (found.value && !std::isfinite(*found.value)) found.value.reset(), found.why = "no load";
  return found;
}

/// Whether a load case has both flanks under preload, so that what it has without says nothing.
bool is_preloaded(const VerdictFacts& f, const LoadCase& load) {
  return f.preloaded &&
         std::ranges::any_of(f.preloaded->load_cases, [&](const auto& r) { return r.load_case.name == load.name; });
}

/// For values that lack a preload; a play is none.
std::string_view without_preload(const VerdictFacts& f) {
  return f.c.preload && !f.c.preload->backlash ? ", without the preload" : "";
}

/// The preload that the case asks for cannot be had.
std::optional<Found> without_fit(const VerdictFacts& f, Sense sense) {
  const auto lacking = f.lacking.find(Command::preload);
  if (!f.c.preload || lacking == f.lacking.end()) return std::nullopt;
  Found found{sense};
  found.why = lacking->second;
  return found;
}

/// Largest normal load of an interface in the other positions of a turn or a travel [N]; 0 without any.
double largest_elsewhere(const LoadCaseResult& r, Interface i) {
  double largest = 0.0;
  if (!r.full) return largest;
  if (r.full->orbit && r.full->orbit->converged()) largest = r.full->orbit->loads[i].largest;
  if (r.full->travel && r.full->travel->converged()) largest = std::max(largest, r.full->travel->loads[i].largest);
  return largest;
}

/// Largest normal load of all positions over that of the position where the carrier stands.
double rise_elsewhere(const LoadCaseResult& r) {
  double rise = 1.0;
  for (const Interface i : kInterfaces) {
    const double here = r.threads ? std::ranges::max((*r.threads)[i].normal_load) : 0.0;
    if (here > 0.0) rise = std::max(rise, largest_elsewhere(r, i) / here);
  }
  return rise;
}

/// The static safety by the contact pressure beside that by a stated capacity.
std::string by_pressure(const FlankLife& flank) {
  if (flank.static_rating->limit != StaticLimit::given || !flank.static_capacity) return {};
  return fmt::format("; {:.4g} by the contact pressure of the first thread",
                     *flank.static_capacity / flank.largest_force);
}

Found static_safety(const VerdictFacts& f) {
  if (!f.measures && !f.life) return without(f, Command::measures, Sense::least);
  if (auto none = without_fit(f, Sense::least)) return *std::move(none);
  Found found;
  if (f.life && f.life->converged())
    for (const Direction d : kDirections)
      if (const auto& flank = f.life->flanks[d]; flank && flank->static_safety())
        found.take(*flank->static_safety(), loads_of(*f.life),
                   fmt::format("{} in {}{}", describe(flank->static_rating->limit), name(d), by_pressure(*flank)));
  for (std::size_t k = 0; f.preloaded && k < f.preloaded_forces.size(); ++k)
    if (const auto& rating = f.preloaded_forces[k].rating) {
      const LoadCase& load = f.preloaded->load_cases[k].load_case;
      found.take(rating->force / load.axial_force, load.name, describe(rating->limit) + ", under preload");
    }
  for (std::size_t k = 0; f.measures && k < f.measures->load_measures.size(); ++k) {
    const auto& m = f.measures->load_measures[k];
    const LoadCase& load = f.measures->analysis.load_cases[k].load_case;
    if (!m || is_preloaded(f, load)) continue;
    if (m->solved_static_safety)
      found.take(*m->solved_static_safety, load.name,
                 fmt::format("{}{}", describe(*m->solved_static_safety_limit), without_preload(f)));
    else if (m->thread_static_safety)
      found.take(*m->thread_static_safety / (*m->thread_static_safety_limit == StaticLimit::given
                                                 ? 1.0
                                                 : rise_elsewhere(f.measures->analysis.load_cases[k])),
                 load.name,
                 fmt::format(
                     "{}, {}{}",
                     load.share == LoadCase::Share::equal ? "equal shares" : "estimate with the shares under this load",
                     describe(*m->thread_static_safety_limit), without_preload(f)));
  }
  if (!found.value) found.why = "no load whose thread loads are known";
  return found;
}

/// The margin of the flank's edge with the shares of threads as they are under a load case.
std::optional<double> flank_edge_estimate(const MeasuresResult& r, std::size_t k) {
  const LoadCaseResult& loaded = r.analysis.load_cases[k];
  const auto& threads = loaded.threads;
  std::optional<double> margin;
  for (const Interface i : kInterfaces) {
    const std::optional<double>& edge = r.measures.interface_flank_edge_load[i];
    const double largest = threads ? std::ranges::max((*threads)[i].axial_load) : 0.0;
    if (!edge || !(largest > 0.0)) return std::nullopt;
    const Mechanism& mechanism = r.analysis.contacts.mechanism;
    const double own = *edge / (mechanism.rollers * mechanism.contacts_per_roller * largest);
    margin = std::min(own, margin.value_or(own));
  }
  if (margin) *margin /= rise_elsewhere(loaded);
  return margin;
}

/// Force at which the first ellipse reaches the edge of a flank over the largest force.
Found flank_edge(const VerdictFacts& f) {
  if (!f.measures && !f.life) return without(f, Command::measures, Sense::least);
  if (auto none = without_fit(f, Sense::least)) return *std::move(none);
  Found found;
  if (f.life && f.life->converged())
    for (const Direction d : kDirections)
      if (const auto& flank = f.life->flanks[d]; flank)
        found.take(flank->flank_edge_margin(), loads_of(*f.life), fmt::format("in {}, at rest", name(d)));
  for (std::size_t k = 0; f.preloaded && k < f.preloaded_forces.size(); ++k)
    if (const auto& edge = f.preloaded_forces[k].flank_edge_load) {
      const LoadCase& load = f.preloaded->load_cases[k].load_case;
      found.take(*edge / load.axial_force, load.name, "under preload");
    }
  for (std::size_t k = 0; f.measures && k < f.measures->load_measures.size(); ++k) {
    const auto& m = f.measures->load_measures[k];
    const LoadCase& load = f.measures->analysis.load_cases[k].load_case;
    if (!m || is_preloaded(f, load)) continue;
    if (m->flank_edge_margin)
      found.take(m->flank_edge_margin, load.name,
                 without_preload(f).empty() ? std::string_view() : without_preload(f).substr(2));
    else
      found.take(flank_edge_estimate(*f.measures, k), load.name,
                 fmt::format(
                     "{}{}",
                     load.share == LoadCase::Share::equal ? "equal shares" : "estimate with the shares under this load",
                     without_preload(f)));
  }
  if (!found.value) found.why = "no load whose thread loads are known";
  return found;
}

/// Largest pressure of the threads of a load case at an interface, on both flanks and in all positions [Pa].
std::optional<double> largest_pressure(const Result& result, const LoadCaseResult& r, Interface i) {
  const auto& named = (*r.threads)[i].peak_pressure;
  if (named.empty()) return std::nullopt;
  double largest = std::ranges::max(named);
  const InterfaceContact& contact = result.contacts.interfaces[i];
  if (const double elsewhere = largest_elsewhere(r, i); elsewhere > 0.0 && contact.has_hertz())
    largest = std::max(largest, contact::at_load(contact.hertz, elsewhere).peak_pressure);
  if (r.other_flank && contact.has_hertz())
    for (const double load : r.other_flank->threads[i].normal_load)
      largest = std::max(largest, contact::at_load(contact.hertz, load).peak_pressure);
  return largest;
}

Found peak_pressure(const VerdictFacts& f) {
  if (!f.loads && !f.slip && !f.life && !f.response) return without(f, Command::solve, Sense::greatest);
  if (auto none = without_fit(f, Sense::greatest)) return *std::move(none);
  Found found{Sense::greatest};
  std::optional<double> limit = f.c.materials ? std::nullopt : std::optional(kStaticPressureLimit);
  if (const auto& m = f.c.materials)
    if (const auto screw = static_pressure_limit(m->screw, m->roller), nut = static_pressure_limit(m->nut, m->roller);
        screw || nut)
      limit = std::min(screw.value_or(HUGE_VAL), nut.value_or(HUGE_VAL));
  if (limit) found.physical = *limit * per_si::megapascal;
  const auto at = [](Interface i) { return fmt::format("roller-{}", name(i)); };
  // Slip has running loads of warm parts, but in a duty cycle at steady temperatures that it never reaches.
  const bool has_cycle = f.slip && f.slip->heat_cycle;
  for (const Result* result : {f.loads, f.preloaded, has_cycle ? nullptr : f.slip})
    for (std::size_t k = 0; result && k < result->load_cases.size(); ++k) {
      const LoadCaseResult& r = result->load_cases[k];
      const bool plain = result == f.loads;
      if (!r.threads || (plain && is_preloaded(f, r.load_case))) continue;
      for (const Interface i : kInterfaces)
        if (const auto pressure = largest_pressure(*result, r, i))
          found.take(*pressure * per_si::megapascal, r.load_case.name,
                     fmt::format("{}{}", at(i), plain ? without_preload(f) : ""));
    }
  if (f.life && f.life->converged())
    for (const Direction d : kDirections)
      for (const Interface i : kInterfaces)
        if (const auto& flank = f.life->flanks[d]; flank && flank->peak_pressure[i])
          found.take(*flank->peak_pressure[i] * per_si::megapascal, loads_of(*f.life),
                     fmt::format("{}, {}", at(i), name(d)));
  const std::optional<double> best = found.best;
  if (f.response)
    for (const Direction d : kDirections)
      if (const auto& largest = f.response->largest[d]; largest && largest->peak_pressure)
        found.take(*largest->peak_pressure * per_si::megapascal, "response",
                   fmt::format("largest force in {}", name(d)));
  found.best = best;  // Of load cases.
  note_response(f, found);
  if (!found.value) found.why = "no load whose thread loads are known";
  return found;
}

bool lacks_shaft(const VerdictFacts& f) { return !f.c.measures || !f.c.measures->shaft; }
constexpr const char* kAddShaft = "add measures.shaft";

Found buckling_safety(const VerdictFacts& f) {
  if (!f.measures) return without(f, Command::measures, Sense::least);
  Found found;
  bool compressed = false;
  for (std::size_t k = 0; k < f.measures->load_measures.size(); ++k) {
    const LoadCase& load = f.measures->analysis.load_cases[k].load_case;
    compressed = compressed || axial_force_on_nut(load) < 0.0;
    if (const auto& m = f.measures->load_measures[k]) found.take(m->buckling_safety, load.name);
  }
  if (f.life && f.life->converged())
    if (const auto& flank = f.life->flanks.compression; flank && flank->largest_force > 0.0) {
      compressed = true;
      if (const auto& buckling = f.measures->measures.buckling_load)
        found.take(*buckling / flank->largest_force, loads_of(*f.life));
    }
  if (f.response)
    if (const auto& largest = f.response->largest.compression; largest && largest->force != 0.0) {
      compressed = true;
      if (const auto& buckling = f.measures->measures.buckling_load)
        found.take(*buckling / std::abs(largest->force), "response", "largest force in compression");
    }
  const bool unknown = f.lacking.contains(Command::response);  // Which may compress it.
  note_response(f, found);
  found.applies = compressed || unknown;
  found.why = !found.applies   ? "no load compresses the screw"
              : lacks_shaft(f) ? kAddShaft
              : compressed     ? "no buckling load"
                               : "no load case compresses the screw, `response` was not computed";
  return found;
}

/// The largest speed of the load cases, of the operation, of a history and of a drive [rad/s].
Found largest_speed(const VerdictFacts& f) {
  Found found{Sense::greatest};
  for (const LoadCase& load : f.c.load_cases)
    if (load.speed) found.take(std::abs(*load.speed), load.name);
  if (f.c.operation) found.take(std::abs(f.c.operation->speed), "", "operation.speed");
  if (f.c.operation) found.take(f.c.operation->largest_speed, "", "operation.largest_speed");
  if (f.life && f.life->history)
    if (const std::optional<double> speed = largest_speed(*f.life->history, f.c.mechanism.lead))
      found.take(*speed, "life.history");
  if (f.response) found.take(f.response->run.largest_speed, "response");
  note_response(f, found);
  found.why = "add operation.speed";
  return found;
}

Found critical_speed_share(const VerdictFacts& f) {
  if (!f.measures) return without(f, Command::measures, Sense::greatest);
  Found found = largest_speed(f);
  found.applies = f.c.mechanism.type == Mechanism::Type::standard;
  const auto& critical = f.measures->measures.critical_speed;
  if (found.value && critical) {
    found.value = *found.value / *critical;
  } else if (!found.applies || lacks_shaft(f) || !critical) {
    found.value.reset();
    found.why = !found.applies ? "the screw does not turn" : lacks_shaft(f) ? kAddShaft : "no critical speed";
  }
  found.best.reset();
  return found;
}

Found speed_times_diameter(const VerdictFacts& f) {
  Found found = largest_speed(f);
  if (found.value)
    found.value =
        *found.value * per_si::revolution_per_minute * *f.c.mechanism.pitch_diameter.screw * per_si::millimetre;
  found.best.reset();
  return found;
}

/// Size of the nut's body: room is left for flanges.
template <double Structure::Nut::*size>
Found of_nut(const VerdictFacts& f) {
  Found found{Sense::greatest};
  if (f.c.structure)
    found.take(f.c.structure->nut.*size * per_si::millimetre, "",
               f.c.structure->nut.flanges.empty() ? "" : "without flanges");
  found.why = "add structure";
  return found;
}

Found weight(const VerdictFacts& f) {
  if (!f.measures) return without(f, Command::measures, Sense::greatest);
  Found found{Sense::greatest};
  const Measures& m = f.measures->measures;
  if (m.weight && m.screw_weight_per_length && !lacks_shaft(f))
    found.take(*m.weight + *m.screw_weight_per_length * f.c.measures->shaft->length, "");
  found.why = lacks_shaft(f) ? kAddShaft : "add structure and materials.density";
  return found;
}

/// Stiffness under the largest force.
Found stiffness(const VerdictFacts& f) {
  if (!f.loads) return without(f, Command::solve, Sense::least);
  Found found;
  found.why = "no load case has one";
  const auto& loads = f.loads->load_cases;
  double largest = 0.0;
  for (const LoadCaseResult& r : loads) largest = std::max(largest, std::abs(r.load_case.axial_force));
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const LoadCaseResult& r = loads[k];
    if (std::abs(r.load_case.axial_force) < (1.0 - kRounding) * largest) continue;
    const auto take = [&](std::optional<double> stiffness, std::string_view kind) {
      if (!stiffness) return;
      std::string note = fmt::format("largest force{}{}", without_preload(f), kind);
      // A limit is that of the drive: what is in series with the screw counts too.
      const auto* const measures = f.limits.stiffness && f.measures ? &*f.measures : nullptr;
      const auto* const system =
          measures && measures->load_measures[k] ? &measures->load_measures[k]->system_stiffness : nullptr;
      if (system && *system) {
        found.title = "Stiffness of the axis";
        const auto& mechanism = (*system)->contributions.mechanism;
        const double others = 1.0 / (*system)->total - (mechanism ? 1.0 / mechanism->stiffness : 0.0);
        stiffness = 1.0 / (1.0 / *stiffness + others);
      } else if (measures && measures->measures.shaft_stiffness) {
        found.title = "Stiffness with the shaft";
        stiffness = 1.0 / (1.0 / *stiffness + 1.0 / *measures->measures.shaft_stiffness);
      } else if (f.limits.stiffness) {
        note += ", without the shaft: measures.shaft is missing";
      }
      found.take(*stiffness * per_si::newton_per_micrometre, r.load_case.name, note);
    };
    // What acts across the axis moves the screw too, and force over displacement may say nothing; a seat
    // that stands askew does so without any load.
    const SpatialLoad& spatial = r.load_case.spatial;
    const bool askew = spatial.nut_tilt != Lateral{} || spatial.nut_offset != Lateral{};
    if (!askew) take(r.axial_stiffness, "");
    if (spatial.acts_across()) take(r.tangent_stiffness, ", tangent, for something acts across the axis");
  }
  return found;
}

/// The efficiency over a spectrum of distances whose steps that the screw drives are load cases, each at its force:
/// sum F s over sum F s/eta. Absent where a step is none.
std::optional<double> efficiency_over_spectrum(const VerdictFacts& f) {
  if (!f.c.life || f.c.life->history) return std::nullopt;
  double out = 0.0, in = 0.0;
  for (const SpectrumLoad& step : f.c.life->spectrum) {
    if (!step.distance) return std::nullopt;
    const double work = step.force * *step.distance;
    if (step.driven_by == DrivenBy::load || work == 0.0) continue;
    std::optional<double> worst;  // Of load cases at other speeds.
    for (const LoadCaseResult& r : f.slip->load_cases) {
      const double force = std::abs(r.load_case.axial_force);
      if (r.load_case.direction == step.direction && std::abs(force - step.force) <= kRounding * force &&
          r.slip->driven_by == DrivenBy::screw && r.slip->efficiency)
        worst = std::min(*r.slip->efficiency, worst.value_or(*r.slip->efficiency));
    }
    if (!worst) return std::nullopt;
    out += work;
    in += work / *worst;
  }
  return in > 0.0 ? std::optional(out / in) : std::nullopt;
}

/// Efficiency of the load cases in which the screw drives, over the duty cycle or the spectrum if there is one.
Found efficiency(const VerdictFacts& f) {
  if (!f.slip) return without(f, Command::slip, Sense::least);
  Found found;
  const auto drives = [](const LoadCaseResult& r) {
    return r.slip && !r.slip->is_held() && r.slip->driven_by == DrivenBy::screw;
  };
  found.applies = std::ranges::any_of(f.slip->load_cases, drives);
  found.why = "the screw drives in no load case";
  if (const auto& cycle = f.slip->heat_cycle) {
    if (found.applies && cycle->converged()) found.take(cycle->efficiency, "heat.duty", "over the cycle");
    if (!cycle->converged()) found.why = "the duty cycle did not converge", found.applies = true;
    return found;
  }
  for (const LoadCaseResult& r : f.slip->load_cases) {
    if (!r.slip || !r.slip->has_answer()) {
      Found failed;
      failed.why = fmt::format("the slip of {} did not converge", r.load_case.name);
      return failed;
    }
    if (drives(r)) found.take(r.slip->efficiency, r.load_case.name);
  }
  if (const std::optional<double> whole = efficiency_over_spectrum(f)) {
    found.value = found.best = whole;
    found.where = "life.spectrum";
    found.note = "over its travel";
  }
  return found;
}

Found temperature(const VerdictFacts& f) {
  Found found{Sense::greatest};
  found.why = "add heat";
  if (!f.c.heat) return found;
  const bool life_has_them = f.life && f.life->temperature && f.life->temperature_status == HeatStatus::converged;
  if (!f.slip && !life_has_them) return without(f, Command::slip, Sense::greatest);
  found.why = "the temperatures did not converge";
  const auto take = [&](const PerPart<double>& kelvin, std::string_view where) {
    const PartNumbers t = celsius_of(kelvin);
    found.take(t.screw, where, "screw");
    found.take(t.rollers, where, "rollers");
    found.take(t.nut, where, "nut");
  };
  if (life_has_them) take(*f.life->temperature, loads_of(*f.life));
  if (!f.slip) return found;
  if (f.slip->heat_cycle) {
    if (f.slip->heat_cycle->converged()) take(f.slip->heat_cycle->peak, "heat.duty");
  } else {
    const auto& all = f.slip->load_cases;
    if (std::ranges::all_of(all, [](const auto& r) { return r.heat && r.heat->converged(); }))
      for (const LoadCaseResult& r : all) take(r.heat->temperature, r.load_case.name);
  }
  found.best.reset();  // Of another part.
  return found;
}

/// Stroke under load over the length of the nut, or of the rollers' threads that travel in an inverted one.
Found stroke(const VerdictFacts& f) {
  Found found;
  found.why = "add life.stroke";
  if (!f.c.structure || !f.c.life) return found;
  const Mechanism& m = f.c.mechanism;
  const double length = m.type == Mechanism::Type::standard ? f.c.structure->nut.length
                                                            : m.contacts_per_roller * std::abs(m.lead) / m.starts.screw;
  if (f.c.life->stroke)
    found.take(*f.c.life->stroke / length, "life.stroke", "life of shorter strokes needs a calculation of its own");
  else if (f.life && f.life->history)
    if (const auto way = loaded_stroke(*f.life->history, 0.5 * f.life->mean_load))
      found.take(*way / length, "life.history", "positions under more than half of the mean load");
  return found;
}

/// Central film over roughness, the least of all threads.
Found film(const VerdictFacts& f) {
  if (!f.slip) return without(f, Command::slip, Sense::least);
  Found found;
  found.applies = f.c.lubricant.has_value();
  found.why = !found.applies ? "no lubricant" : !f.c.roughness ? "add roughness" : "the slip did not converge";
  if (f.slip->heat_cycle && !f.films) {  // Films of steady temperatures, which a duty never reaches, say nothing.
    if (f.c.roughness) found.why = "the temperatures of the duty did not converge";
    return found;
  }
  for (const LoadCaseResult& r : (f.films ? f.films : f.slip)->load_cases)
    if (r.slip && r.slip->converged())
      for (const Interface i : kInterfaces)
        for (const double ratio : r.slip->threads[i].film_ratio)
          if (ratio > 0.0)
            found.take(ratio, r.load_case.name,
                       fmt::format("roller-{}{}{}", name(i), f.films ? ", at the mean temperatures of the duty" : "",
                                   f.c.life ? "; the life above is that of full, clean films" : ""));
  return found;
}

/// A criterion, what it is held against, and whether it is told where there is nothing of both.
struct Row {
  std::string_view name, title, unit;
  Found (*find)(const VerdictFacts&);
  std::optional<double> Limits::*limit = nullptr;  ///< None of the life, which has two, and of the flank's edge.
  double factor = 1.0;                             ///< From SI to the unit.
  bool is_plain = true;                            ///< Told without a limit too.
  double zero = 0.0;                               ///< Zero of the unit [K].
  std::optional<double> physical = {}, recommended = {};

  std::optional<double> stated(const Limits& l) const {
    if (limit) return l.*limit ? std::optional(*(l.*limit) * factor - zero) : std::nullopt;
    if (name != "life" || !l.life) return {};
    return l.life->travel ? *l.life->travel * per_si::kilometre : *l.life->duration / 3600.0;
  }
};

constexpr double kMillimetrePerMinute = 60.0 * per_si::millimetre;

const Row kRows[] = {
    {"life", "Life", "h", life, nullptr},
    {"static_safety", "Static safety", "", static_safety, &Limits::static_safety, 1.0, true, 0.0, 1.0,
     kRecommendedStaticSafety},
    {.name = "flank_edge", .title = "Flank's edge", .unit = "", .find = flank_edge, .recommended = 1.0},
    {"peak_pressure", "Peak pressure", "MPa", peak_pressure, &Limits::peak_pressure, per_si::megapascal},
    {"buckling_safety", "Buckling safety", "", buckling_safety, &Limits::buckling_safety, 1.0, true, 0.0, 1.0,
     kRecommendedBucklingSafety},
    {"critical_speed_share", "Share of the critical speed", "", critical_speed_share, &Limits::critical_speed_share,
     1.0, true, 0.0, 1.0, kRecommendedCriticalSpeedShare},
    {"speed_times_diameter", "Speed times diameter", "mm/min", speed_times_diameter, &Limits::speed_times_diameter,
     kMillimetrePerMinute, false},
    {"nut_diameter", "Nut diameter", "mm", of_nut<&Structure::Nut::outer_diameter>, &Limits::nut_diameter,
     per_si::millimetre, false},
    {"nut_length", "Nut length", "mm", of_nut<&Structure::Nut::length>, &Limits::nut_length, per_si::millimetre, false},
    {"weight", "Weight", "kg", weight, &Limits::weight, 1.0, false},
    {"stiffness", "Axial stiffness", "N/um", stiffness, &Limits::stiffness, per_si::newton_per_micrometre},
    {"efficiency", "Efficiency", "", efficiency, &Limits::efficiency},
    {.name = "temperature",
     .title = "Temperature",
     .unit = "degC",
     .find = temperature,
     .limit = &Limits::temperature,
     .zero = 273.15,
     .recommended = kRecommendedTemperature},
    {.name = "stroke", .title = "Stroke over the nut's length", .unit = "", .find = stroke, .recommended = 1.5},
    {.name = "film", .title = "Film ratio", .unit = "", .find = film, .recommended = 1.0},
};

Criterion criterion(std::string_view name, std::string_view title, std::string_view unit) {
  Criterion c;
  c.name = name;
  c.title = title;
  c.unit = unit;
  return c;
}

bool meets(double value, double limit, Sense sense) {
  const double rounding = kRounding * std::abs(limit);
  return sense == Sense::least ? value >= limit - rounding : value <= limit + rounding;
}

void hold_against_limit(Criterion& c, const Row& row, const std::optional<double>& physical) {
  const double value = *c.value;
  const auto set = [&](double limit, LimitSource source, Standing standing) {
    c.limit = limit;
    c.source = source;
    c.standing = standing;
  };
  if (c.limit)
    set(*c.limit, LimitSource::stated, meets(value, *c.limit, c.sense) ? Standing::green : Standing::red);
  else if (physical && !meets(value, *physical, c.sense))
    set(*physical, LimitSource::physics, Standing::red);
  else if (row.recommended)
    set(*row.recommended, LimitSource::recommended,
        meets(value, *row.recommended, c.sense) ? Standing::green : Standing::amber);
  else if (physical)
    set(*physical, LimitSource::physics, Standing::green);
}

void add(const Row& row, const VerdictFacts& f, CaseVerdict& verdict) {
  Found found = row.find(f);
  Criterion c = criterion(row.name, found.title.empty() ? row.title : found.title, row.unit);
  c.sense = found.sense;
  c.limit = row.stated(f.limits);
  verdict.is_complete = verdict.is_complete && found.asked;
  if (!found.asked || (!c.limit && !row.is_plain)) return;
  if (c.name == "life" && (f.limits.life ? f.limits.life->travel.has_value() : f.life && !f.life->revolution_rate))
    c.unit = "km";
  c.value = found.value;
  if (found.best && found.value && std::abs(*found.best - *found.value) > kRounding * std::abs(*found.value))
    c.best = found.best;
  if (c.value) {
    c.load_case = std::move(found.where);
    c.reason = std::move(found.note);
    hold_against_limit(c, row, found.physical ? found.physical : row.physical);
  } else {
    if (c.limit) c.source = LimitSource::stated;
    c.reason = std::move(found.why);
    c.standing = found.applies ? Standing::not_computed : Standing::not_applicable;
  }
  verdict.criteria.push_back(std::move(c));
}

const LoadCaseResult* named(const Result& result, const std::optional<std::string>& name) {
  const auto found =
      std::ranges::find_if(result.load_cases, [&](const LoadCaseResult& r) { return r.load_case.name == name; });
  return found == result.load_cases.end() ? nullptr : &*found;
}

/// Whether the screw locks itself; not where slip has no answer.
bool locks(const VerdictFacts& f) {
  const LoadCaseResult* const back = f.slip ? named(*f.slip, f.motor->driven_back) : nullptr;
  return back && back->slip && back->slip->converged() && back->slip->self_locking.value_or(false);
}

/// What the cycle asks of the motor, each step with the friction of its load case; none without it.
std::optional<MotorDemand> demand_of(const VerdictFacts& f, double lead) {
  const auto inertia = f.measures ? f.measures->measures.equivalent_inertia : std::nullopt;
  if (!f.slip || !inertia) return std::nullopt;
  std::vector<DrivenStep> steps;
  for (const MotorDuty::Step& step : f.motor->cycle) {
    const LoadCaseResult* const loaded = named(*f.slip, step.load_case);
    const std::optional<double> torque = loaded ? screw_torque(*loaded, lead) : 0.0;
    if (!torque) return std::nullopt;
    steps.push_back({step, loaded ? *torque * std::abs(step.force / loaded->load_case.axial_force) : 0.0});
  }
  return motor_demand(steps, f.motor->motor, lead, *inertia, f.motor->drag_torque, f.motor->brake_torque || locks(f));
}

/// The motor, the brake and the load that may drive, against the limits of the block `motor`.
void add_motor(const VerdictFacts& f, CaseVerdict& verdict) {
  if (!f.motor) return;
  const MotorDuty& d = *f.motor;
  const auto put = [&](std::string_view name, std::string_view title, std::string_view unit,
                       std::optional<double> limit, const Found& found) {
    Criterion c = criterion(name, title, unit);
    c.sense = Sense::greatest;
    c.limit = limit;
    c.value = found.value;
    c.reason = found.value ? found.note : found.why;
    c.source = LimitSource::stated;
    c.standing = !found.applies ? Standing::not_applicable : Standing::not_computed;
    if (c.value) hold_against_limit(c, {}, {});
    if (limit) verdict.criteria.push_back(std::move(c));
  };
  const double lead = std::abs(f.c.mechanism.lead), per_speed = 2.0 * std::numbers::pi * d.motor.gear_ratio / lead;
  Found speed,
      holding{.value = d.holding_force / per_speed, .why = "no force at rest", .applies = d.holding_force > 0.0};
  double largest = 0.0;
  for (const MotorDuty::Step& step : d.cycle) largest = std::max(largest, step.largest_speed());
  if (largest > 0.0) speed.value = per_speed * largest * per_si::revolution_per_minute;
  speed.applies = largest > 0.0;
  speed.why = "nothing moves";
  if (!holding.applies) holding.value.reset();
  put("motor_speed", "Motor speed", "rpm",
      d.motor.largest_speed ? std::optional(*d.motor.largest_speed * per_si::revolution_per_minute) : std::nullopt,
      speed);
  const Found asked = without(f, Command::slip, Sense::greatest);
  if (f.slip || asked.asked) {
    const std::optional<MotorDemand> demand = demand_of(f, lead);
    const std::string why = !f.slip ? asked.why : "a step has no slip, or the parts no inertia";
    Found rms{.note = "rms over motor.cycle", .why = why}, peak{.note = "motor.cycle", .why = why};
    if (demand) rms.value = demand->rms_torque, peak.value = demand->peak_torque;
    put("motor_torque", "Motor torque", "N m", d.motor.rated_torque, rms);
    put("motor_peak_torque", "Motor peak torque", "N m", d.motor.peak_torque, peak);
    if (d.back_driving != BackDriving::allowed) {
      Criterion c = criterion("back_driving", "Back driving", "");
      c.source = LimitSource::stated;
      c.standing = locks(f) == (d.back_driving == BackDriving::forbidden) ? Standing::green : Standing::red;
      c.reason = locks(f) ? "the screw locks itself" : "the load turns the screw";
      verdict.criteria.push_back(std::move(c));
    }
  } else {
    verdict.is_complete = false;
  }
  put("brake", "Brake", "N m", d.brake_torque, holding);
}

/// What did not converge, all of it told.
void add_convergence(const VerdictFacts& f, CaseVerdict& verdict) {
  if (!f.loads && !f.slip && !f.life && !without_fit(f, Sense::least)) return;
  std::string failed;
  const auto tell = [&](const std::string& what) { failed += (failed.empty() ? "" : ", ") + what; };
  const auto count = [&](const Result* result, const char* what, auto good) {
    if (!result) return;
    const auto bad = std::ranges::count_if(result->load_cases, [&](const LoadCaseResult& r) { return !good(r); });
    if (bad > 0)
      tell(fmt::format("{} of {} of {} load case{}", what, bad, result->load_cases.size(),
                       result->load_cases.size() == 1 ? "" : "s"));
  };
  count(f.loads, "thread loads", [](const LoadCaseResult& r) { return r.converged(); });
  if (const auto none = without_fit(f, Sense::least)) tell(fmt::format("preload ({})", none->why));
  count(f.preloaded, "thread loads under preload", [](const LoadCaseResult& r) { return r.converged(); });
  const Result* const steady = f.slip && f.slip->heat_cycle ? nullptr : f.slip;  // A duty never reaches it.
  count(steady, "slip", [](const LoadCaseResult& r) { return r.slip && r.slip->has_answer(); });
  count(steady, "temperatures", [](const LoadCaseResult& r) { return !r.heat || r.heat->converged(); });
  if (f.slip && f.slip->heat_cycle && !f.slip->heat_cycle->converged()) tell("the duty cycle");
  if (f.life && !f.life->converged()) tell("life");
  Criterion c = criterion("convergence", "Convergence", "");
  c.source = LimitSource::physics;
  c.standing = failed.empty() ? Standing::green : Standing::red;
  c.reason = failed.empty() ? "all converged" : "not converged: " + failed;
  verdict.criteria.push_back(std::move(c));
}

/// A nut with so few threads is no screw that anybody makes.
void add_contacts(const VerdictFacts& f, CaseVerdict& verdict) {
  if (f.c.mechanism.contacts_per_roller >= kRecommendedContacts) return;
  Criterion c = criterion("contacts_per_roller", "Contacts per roller", "");
  c.value = f.c.mechanism.contacts_per_roller;
  c.limit = kRecommendedContacts;
  c.source = LimitSource::recommended;
  c.standing = Standing::amber;
  c.reason = "makers' nuts have more: check the length of the nut";
  verdict.criteria.push_back(std::move(c));
}

/// Errors of the input that commands found. A case for which no thread loads can be had is impossible.
void add_errors(const VerdictFacts& f, CaseVerdict& verdict) {
  for (const auto& [command, what] : f.wrong) {
    if (command != Command::solve && command != Command::measures) {
      verdict.failed.emplace_back(name(command));
      continue;
    }
    verdict.impossible = what;
  }
  if (verdict.impossible.empty()) return;
  Criterion c = criterion("input", "Input", "");
  c.source = LimitSource::physics;
  c.standing = Standing::red;
  c.reason = verdict.impossible;
  verdict.criteria.push_back(std::move(c));
}

/// Threads that overlap before any load.
void add_play(const VerdictFacts& f, CaseVerdict& verdict) {
  if (!f.contacts) return;
  Found found;
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = f.contacts->interfaces[i];
    const contact::Thread& body = thread_of(f.contacts->threads, body_of(i));
    const std::string at = fmt::format("roller-{}", name(i));
    if (contact.geometry.point.ok() && contact::same_pitch(body, f.contacts->threads.roller))
      found.take(contact.geometry.point.backlash * per_si::millimetre, "", at);
    if (!contact.clearance) continue;
    for (const auto& crest : {contact.clearance->body_crest, contact.clearance->roller_crest})
      if (crest) found.take(2.0 * *crest * per_si::millimetre, "", at + ", at a crest");
  }
  if (!found.value) return;
  Criterion c = criterion("axial_play", "Axial play of the threads", "mm");
  c.value = found.value;
  c.limit = 0.0;
  c.source = LimitSource::physics;
  c.standing = *c.value < -kTouching ? Standing::red : Standing::green;
  c.reason = found.note + (c.standing == Standing::red ? ": the threads interfere" : "");
  verdict.criteria.push_back(std::move(c));
}

/// The curve that leaves its tolerance most.
void add_references(const VerdictFacts& f, CaseVerdict& verdict) {
  const ReferenceComparison* worst = nullptr;
  const auto use = [](const ReferenceComparison& r) { return r.models[r.stated].tolerance_use.value_or(0.0); };
  if (f.comparison)
    for (const ReferenceComparison& r : f.comparison->references)
      if (r.reference.tolerance && (!worst || use(r) > use(*worst))) worst = &r;
  if (!worst) return;
  Criterion c = criterion("reference", "Deviation over tolerance", "");
  c.sense = Sense::greatest;
  if (std::isfinite(use(*worst))) c.value = use(*worst);
  c.limit = 1.0;
  c.source = LimitSource::stated;
  c.standing = worst->met() ? Standing::green : Standing::red;
  c.load_case = worst->reference.load_case;
  c.reason = fmt::format("{} against {}, tolerance {}", worst->reference.response, worst->reference.name,
                         worst->reference.tolerance->text);
  verdict.criteria.push_back(std::move(c));
}

/// `Static safety, peak pressure` of a standing.
std::string titles(const CaseVerdict& verdict, auto of) {
  std::string text;
  for (const Criterion& c : verdict.criteria)
    if (of(c)) {
      std::string title(c.title);
      title.front() = static_cast<char>(title.front() | 0x20);
      text += (text.empty() ? "" : ", ") + title;
    }
  return text;
}

bool is_unknown(const Criterion& c) { return c.standing == Standing::not_computed && c.limit; }

}  // namespace

std::string_view name(Sense sense) { return sense == Sense::least ? "least" : "greatest"; }

std::string_view name(LimitSource source) {
  constexpr std::string_view kNames[] = {"case", "physics", "recommended"};
  return kNames[static_cast<std::size_t>(source)];
}

std::string_view name(Standing standing) {
  constexpr std::string_view kNames[] = {"green", "amber", "red", "no_limit", "not_computed", "not_applicable"};
  return kNames[static_cast<std::size_t>(standing)];
}

Standing CaseVerdict::standing() const {
  const auto any = [&](auto of) { return std::ranges::any_of(criteria, of); };
  const auto has = [&](Standing s) { return any([&](const Criterion& c) { return c.standing == s; }); };
  if (has(Standing::red)) return Standing::red;
  if (has(Standing::amber) || any(is_unknown) || !not_built.empty() || !failed.empty()) return Standing::amber;
  return has(Standing::green) ? Standing::green : Standing::no_limit;
}

CaseVerdict verdict_of(const VerdictFacts& f) {
  CaseVerdict verdict;
  verdict.not_built = f.not_built;
  for (const Row& row : kRows) add(row, f, verdict);
  add_motor(f, verdict);
  add_references(f, verdict);
  add_play(f, verdict);
  add_convergence(f, verdict);
  add_contacts(f, verdict);
  add_errors(f, verdict);
  return verdict;
}

std::string words(const Criterion& c) {
  const Standing standing = c.standing;
  if (standing == Standing::green) return "met";
  if (standing == Standing::amber) return c.sense == Sense::least ? "below recommended" : "above recommended";
  if (standing == Standing::red) return "not met";
  std::string text(name(standing));
  std::ranges::replace(text, '_', ' ');
  return text;
}

ShownCriterion shown(const Criterion& c) {
  if (c.name == "efficiency" || c.name == "critical_speed_share") return {"%", per_si::percent};
  if (c.unit == "MPa") return {"GPa", 1e-3};
  return {c.unit == "N/um" ? "N/µm" : c.unit == "degC" ? "°C" : c.unit};
}

std::string summary(const CaseVerdict& verdict) {
  const auto of = [&](Standing s) { return titles(verdict, [&](const Criterion& c) { return c.standing == s; }); };
  std::string text;
  const auto tell = [&](std::string_view words, const std::string& what) {
    if (!what.empty()) text += fmt::format("{}{}: {}.", text.empty() ? "" : " ", words, what);
  };
  tell("Not met", of(Standing::red));
  tell("Not as recommended", of(Standing::amber));
  tell("Not computed, so not met", titles(verdict, is_unknown));
  tell("Not assessed because of an error in the input", fmt::format("{}", fmt::join(verdict.failed, ", ")));
  tell("Not judged, because not built", fmt::format("{}", fmt::join(verdict.not_built, ", ")));
  if (!verdict.is_complete)
    text += text.empty() ? "Other criteria follow." : " Other criteria follow.";
  else if (text.empty())
    text = verdict.standing() == Standing::green ? "All limits that could be checked are met."
                                                 : "Nothing to hold against a limit.";
  return text;
}

std::string not_computed(const CaseVerdict& verdict) {
  std::string text;
  for (const Criterion& c : verdict.criteria)
    if (!c.limit && (c.standing == Standing::not_computed || c.standing == Standing::not_applicable)) {
      std::string title(c.title);
      title.front() = static_cast<char>(title.front() | 0x20);
      text += fmt::format("{}{} ({})", text.empty() ? "" : "; ", title, c.reason);
    }
  return text;
}

std::string origin(const Criterion& c) {
  if (c.source == LimitSource::stated &&
      (c.name.starts_with("motor_") || c.name == "brake" || c.name == "back_driving"))
    return "motor";
  if (c.name == "reference") return "references[].tolerance";
  if (c.source == LimitSource::stated) return fmt::format("limits.{}", c.name);
  return c.source == LimitSource::physics ? "physical limit" : "recommended";
}

namespace {

template <std::string Criterion::*text>
constexpr auto text_of =
    of<[](const Criterion& c) { return (c.*text).empty() ? std::nullopt : std::optional(c.*text); }>;

constexpr Quantity<Criterion> kCriterion[] = {
    {"name", of<&Criterion::name>, "key in `limits`, where it has one"},
    {"title", of<&Criterion::title>, "in words"},
    {"unit", of<&Criterion::unit>, "of value and limit; empty for ratios and fractions"},
    {"sense", of<&Criterion::sense>, "least | greatest: which the limit is"},
    {"value", of<&Criterion::value>, "the worst of all load cases, with the real thread loads"},
    {"best", of<&Criterion::best>, "the best value of all load cases and places"},
    {"limit", of<&Criterion::limit>, "that it is held against"},
    {"limit_source", of<&Criterion::source>,
     "case | physics | recommended: `limits` of the case, what physics allows, or what is usual"},
    {"state", of<&Criterion::standing>, "green | amber | red | no_limit | not_computed | not_applicable"},
    {"load_case", text_of<&Criterion::load_case>, "where the worst value stands"},
    {"reason", text_of<&Criterion::reason>, "what limits it, or why there is no value"},
};

constexpr Quantity<CaseVerdict> kVerdict[] = {
    {"state", of<&CaseVerdict::standing>, "the worst: green | amber | red | no_limit"},
    {"criteria", of<&CaseVerdict::criteria>, "each with its worst value"},
    {"not_built", filled<[](const CaseVerdict& v) { return v.not_built; }>,
     "commands that the case is ready for and this program leaves out; scripts/install.sh builds all"},
    {"failed", filled<[](const CaseVerdict& v) { return v.failed; }>,
     "commands that the case is ready for and that found something wrong with it"},
};

}  // namespace

PRS_RECORD(CaseVerdict, "Verdict", "Whether the case meets its limits.", kVerdict);
PRS_RECORD(Criterion, "Criterion", "A value, the limit that it is held against, and how it stands to it.", kCriterion);

}  // namespace prs
