#include "prs/life/life_criteria.h"

#include <fmt/format.h>

#include "prs/life/life_record.h"
#include "prs/life/load_history.h"
#include "prs/loads/load_criteria.h"
#include "prs/record/table_units.h"

namespace prs {
namespace {

std::string_view loads_of(const LifeResult& r) { return r.history ? "life.history" : "life.spectrum"; }

FoundCriterion rated_life(const LifeResult& r, const JudgedCase& of) {
  FoundCriterion found("life");
  const auto& limit = of.limits.life;
  // A maker's capacity comes from real screws: uneven sharing is in it.
  const LifeInUse in = in_use(r, r.lemor ? r.system_life : r.catalogue_life);
  const std::string note = fmt::format(
      "{:g} % reach it; {}{}", r.life.reliability * "%"_per_si,
      !r.lemor                                  ? "stated C_a already includes uneven sharing"
      : r.life.share == LoadCase::Share::solved ? "real thread loads, " + words_of_text(name(r.loads))
                                                : "equal thread loads",
      r.modified ? fmt::format("; {:.3g} times as long with film and dirt by ISO 281", r.modified->factor) : "");
  if (limit ? limit->travel.has_value() : !r.revolution_rate) found.unit = "km";
  if (!r.converged())
    found.why = "the life did not converge";
  else if (limit ? limit->travel.has_value() : !in.hours.has_value())
    found.take(in.rated * in.travel * "km"_per_si, loads_of(r), note);
  else if (in.hours)
    found.take(in.rated * *in.hours, loads_of(r), r.duration ? note : note + "; hours of motion");
  else
    found.why = "hours need `operation.speed`";
  if (found.value && !std::isfinite(*found.value)) found.value.reset(), found.why = "no load";
  return found;
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
  FoundCriterion safety("static_safety"), edge("flank_edge"), pressure("peak_pressure"), temperature("temperature"),
      stroke("stroke"), speed("largest_speed"), compression("largest_compression");
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
          pressure.take(
              *flank->peak_pressure[i] * "MPa"_per_si, where,
              fmt::format("roller-{}, {}, {}", name(i), name(d),
                          flank->peak_pressure[i] == flank->running_peak_pressure[i] ? "running" : "at rest"));
    }
    if (const auto& flank = r.flanks.compression; flank && flank->largest_force > 0.0)
      compression.take(flank->largest_force, where);
  }
  if (r.temperature && r.temperature_status == HeatStatus::converged)
    take_temperatures(temperature, *r.temperature, where);
  if (r.history) {
    speed.take(largest_speed(*r.history, r.contacts.mechanism.lead), where);
    if (const auto length = loaded_length(of.c); length && !of.c.life->stroke)
      if (const auto way = loaded_stroke(*r.history, 0.5 * r.mean_load))
        stroke.take(*way / *length, where, "positions under more than half of the mean load");
  }
  std::vector<FoundCriterion> all{
      rated_life(r, of), safety, edge, pressure, stroke, speed, compression, convergence(r.converged() ? "" : "life")};
  if (temperature.value) all.push_back(temperature);
  return all;
}

}  // namespace prs
