#include "prs/loads/load_criteria.h"

#include <fmt/format.h>

#include "prs/indices.h"
#include "prs/loads/full_result.h"
#include "prs/loads/load_record.h"
#include "prs/record/table_layout.h"

namespace prs {
namespace {

/// Largest normal load of an interface in the other positions of a turn or a travel [N]; 0 without any.
double largest_elsewhere(const LoadCaseResult& r, Interface i) {
  double largest = 0.0;
  if (!r.full) return largest;
  if (r.full->orbit && r.full->orbit->converged()) largest = r.full->orbit->loads[i].largest;
  if (r.full->travel && r.full->travel->converged()) largest = std::max(largest, r.full->travel->loads[i].largest);
  return largest;
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

/// `at rest at the temperatures of `slip``, `running`. `is_whole`: with preload and temperatures as they are.
std::string words_of_loads(const LoadCaseResult& r, const JudgedCase& of, bool is_whole) {
  return is_whole || r.loads != ModelOptions::Loads::at_rest ? words_of_text(name(r.loads)) : of.at_rest();
}

}  // namespace

double rise_elsewhere(const LoadCaseResult& r) {
  double rise = 1.0;
  for (const Interface i : kInterfaces) {
    const double here = r.threads ? std::ranges::max((*r.threads)[i].normal_load) : 0.0;
    if (here > 0.0) rise = std::max(rise, largest_elsewhere(r, i) / here);
  }
  return rise;
}

void take_pressure(FoundCriterion& found, double pressure, std::optional<double> limit, const JudgedCase& of,
                   std::string_view load_case, std::string note) {
  if (of.limits.peak_pressure) limit.reset();
  if (!of.limits.peak_pressure && !limit)
    note += fmt::format("; no limit is known, add {}", lacking_pressure_limits(of.c.materials));
  if (limit) *limit *= "MPa"_per_si;
  found.take(pressure * "MPa"_per_si, load_case, note, limit);
}

FoundCriterion pressure_criterion(const Result& result, const JudgedCase& of, bool at_rest) {
  FoundCriterion found("peak_pressure");
  for (const LoadCaseResult& r : result.load_cases) {
    if (!r.threads || (at_rest && of.preloaded.contains(r.load_case.name))) continue;
    if (r.heat && !r.heat->converged()) continue;
    for (const Interface i : kInterfaces)
      if (const auto pressure = largest_pressure(result, r, i))
        take_pressure(found, *pressure, result.contacts.interfaces[i].pressure_limit, of, r.load_case.name,
                      fmt::format("roller-{}, {}", name(i), words_of_loads(r, of, !at_rest)));
  }
  return found;
}

FoundCriterion static_safety_criterion(const Case& c) {
  FoundCriterion found("static_safety");
  const std::string lacking = lacking_pressure_limits(c.materials);
  if (!lacking.empty()) found.why = fmt::format("add {}, or life.static_capacity", lacking);
  return found;
}

FoundCriterion stiffness_criterion(const Result& result, const JudgedCase& of, const InSeriesOf& in_series,
                                   bool under_preload) {
  FoundCriterion found("stiffness", "no load case has one");
  double largest = 0.0;
  for (const LoadCase& load : of.c.load_cases) largest = std::max(largest, std::abs(load.axial_force));
  for (const LoadCaseResult& r : result.load_cases) {
    const LoadCase& load = r.load_case;
    if (std::abs(load.axial_force) < (1.0 - kLimitRounding) * largest) continue;
    // A play is no preload: the stiffness is that of one flank.
    if (!under_preload && of.preloaded.contains(load.name) && !of.c.preload->backlash) continue;
    const auto take = [&](std::optional<double> stiffness, std::string_view kind) {
      if (!stiffness) return;
      std::string note = fmt::format("largest force, {}{}{}", words_of_loads(r, of, under_preload),
                                     under_preload ? " under preload" : "", kind);
      const std::optional<InSeries> others = of.limits.stiffness && in_series ? in_series(load) : std::nullopt;
      if (others) {
        found.title = others->title;
        stiffness = 1.0 / (1.0 / *stiffness + others->compliance);
      } else if (of.limits.stiffness) {
        note += ", without the shaft: measures.shaft is missing";
      }
      found.take(*stiffness * "N/µm"_per_si, load.name, note);
    };
    // Loads across the axis move the screw too, so that force over displacement may be no stiffness; a tilted or
    // offset seat moves it without any load.
    const SpatialLoad& spatial = load.spatial;
    const bool against = r.axial_stiffness.value_or(0.0) < 0.0;
    const bool askew = spatial.nut_tilt != Lateral{} || spatial.nut_offset != Lateral{} || against;
    if (!askew) take(r.axial_stiffness, "");
    if (spatial.acts_across() || against) take(r.tangent_stiffness, ", tangent, since something acts across the axis");
  }
  return found;
}

std::string failed_cases(const Result& result, std::string_view what, bool (*good)(const LoadCaseResult&)) {
  const auto bad = std::ranges::count_if(result.load_cases, std::not_fn(good));
  if (bad == 0) return {};
  return fmt::format("{} of {} of {} load case{}", what, bad, result.load_cases.size(),
                     result.load_cases.size() == 1 ? "" : "s");
}

void take_temperatures(FoundCriterion& found, const PerPart<double>& kelvin, std::string_view where) {
  const PartNumbers t = celsius_of(kelvin);
  found.take(t.screw, where, "screw");
  found.take(t.rollers, where, "rollers");
  found.take(t.nut, where, "nut");
  found.best.reset();  // The best value is one of another part.
}

std::vector<FoundCriterion> load_criteria(const Result& result, const JudgedCase& of, const InSeriesOf& in_series) {
  return {pressure_criterion(result, of, true), stiffness_criterion(result, of, in_series),
          convergence(failed_cases(result, "thread loads", [](const LoadCaseResult& r) { return r.converged(); }))};
}

}  // namespace prs
