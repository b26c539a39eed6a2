#include "prs/life/life_criteria.h"

#include <fmt/format.h>

#include "prs/life/life_record.h"
#include "prs/life/load_history.h"
#include "prs/loads/load_criteria.h"
#include "prs/record/table_layout.h"

namespace prs {
namespace {

std::string_view loads_of(const LifeResult& r) { return r.history ? "life.history" : "life.spectrum"; }

/// A life in hours, or in kilometres if the limit is; `rated` times as long as the L10.
FoundCriterion life_criterion(CriterionKey key, const LifeResult& r, const JudgedCase& of, double revolutions,
                              double rated, const std::string& note) {
  FoundCriterion found(key);
  const auto& limit = of.limits.life;
  const LifeInUse in = in_use(r, revolutions);
  if (limit ? limit->travel.has_value() : !r.revolution_rate) found.unit = "km";
  if (!r.converged())
    found.why = "the life did not converge";
  else if (limit ? limit->travel.has_value() : !in.hours.has_value())
    found.take(rated * in.travel * "km"_per_si, loads_of(r), note);
  else if (in.hours)
    found.take(rated * *in.hours, loads_of(r), r.duration ? note : note + "; hours of motion");
  else
    found.why = "hours need `operation.speed`";
  if (found.value && !std::isfinite(*found.value)) found.value.reset(), found.why = "no load";
  return found;
}

FoundCriterion rated_life(const LifeResult& r, const JudgedCase& of) {
  const std::string note = fmt::format(
      "{:g} % reach it; {}{}", r.life.reliability * "%"_per_si,
      !r.lemor                                  ? "stated C_a already includes uneven sharing"
      : r.life.share == LoadCase::Share::solved ? "real thread loads, " + words_of_text(name(r.loads))
                                                : "equal thread loads",
      r.modified ? fmt::format("; {:.3g} times as long with film and dirt by ISO 281", r.modified->factor) : "");
  return life_criterion("life", r, of, r.screw_life(), r.rated_over_l10(), note);
}

/// The static safety by the contact pressure beside that by a stated capacity.
std::string by_pressure(const FlankLife& flank) {
  if (flank.static_rating->limit != StaticLimit::given || !flank.static_capacity) return {};
  return fmt::format("; {:.4g} by the contact pressure of the first thread",
                     *flank.static_capacity / flank.largest_force);
}

}  // namespace

std::vector<FoundCriterion> life_criteria(const LifeResult& r, const JudgedCase& of) {
  const std::string_view where = loads_of(r);
  FoundCriterion safety = static_safety_criterion(of.c), edge("flank_edge"), pressure("peak_pressure"),
                 temperature("temperature"), stroke = stroke_criterion(of.c), speed("largest_speed"),
                 compression("largest_compression"), tension("largest_tension");
  if (r.history)
    for (const LoadStep& step : r.steps)
      if (step.axial_force != 0.0)
        (step.axial_force < 0.0 ? compression : tension).take(std::abs(step.axial_force), where);
  if (r.converged()) {
    for (const Direction d : kDirections) {
      const auto& flank = r.flanks[d];
      if (!flank) continue;
      if (flank->static_safety())
        safety.take(
            flank->static_safety(), where,
            fmt::format("{} in {}, at rest{}", describe(flank->static_rating->limit), name(d), by_pressure(*flank)));
      edge.take(flank->flank_edge_margin(), where, fmt::format("in {}, at rest", name(d)));
      for (const Interface i : kInterfaces)
        if (flank->peak_pressure[i])
          take_pressure(
              pressure, *flank->peak_pressure[i], r.contacts.interfaces[i].pressure_limit, of, where,
              fmt::format("roller-{}, {}, {}", name(i), name(d),
                          flank->peak_pressure[i] == flank->running_peak_pressure[i] ? "running" : "at rest"));
    }
  }
  if (r.temperature && r.temperature_status == HeatStatus::converged)
    take_temperatures(temperature, *r.temperature, where);
  if (r.history) {
    speed.take(largest_speed(*r.history, r.contacts.mechanism.lead), where);
    if (const auto length = loaded_length(of.c); length && !of.c.life->stroke)
      if (const auto way = loaded_stroke(*r.history, 0.5 * r.mean_load))
        stroke.take(*way / *length, where, "positions under more than half of the mean load");
  }
  std::vector<FoundCriterion> all{rated_life(r, of), safety,  edge,
                                  pressure,          stroke,  speed,
                                  compression,       tension, convergence(r.converged() ? "" : "life")};
  if (temperature.value) all.push_back(temperature);
  if (!r.bearing) return all;
  if (const auto life = r.bearing_life())
    all.push_back(
        life_criterion("bearing_life", r, of, *life, r.reliability_factor,
                       fmt::format("{:g} % reach it; equivalent load {:.4g} kN", r.life.reliability * "%"_per_si,
                                   r.bearing->equivalent_load * "kN"_per_si)));
  FoundCriterion bearing("bearing_static_safety");
  bearing.take(r.bearing->static_safety, where, "C_0 over the largest force");
  if (bearing.value) all.push_back(bearing);
  return all;
}

}  // namespace prs
