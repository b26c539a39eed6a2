#include "prs/measures/measures_criteria.h"

#include <fmt/format.h>

#include "prs/loads/load_criteria.h"

namespace prs {
namespace {

/// Safety against edge loading with the shares of threads as they are under a load case.
std::optional<double> flank_edge_estimate(const MeasuresResult& r, std::size_t k) {
  const LoadCaseResult& loaded = r.analysis.load_cases[k];
  const auto& threads = loaded.threads;
  std::optional<double> margin;
  for (const Interface i : kInterfaces) {
    const std::optional<double>& edge = r.measures.interface_flank_edge_load[i];
    const double largest = threads ? std::ranges::max((*threads)[i].axial_load) : 0.0;
    if (!edge || !(largest > 0.0)) return std::nullopt;
    const Mechanism& mechanism = r.analysis.contacts.mechanism;
    const double own = *edge / (loaded_rollers(mechanism) * mechanism.contacts_per_roller * largest);
    margin = std::min(own, margin.value_or(own));
  }
  if (margin) *margin /= rise_elsewhere(loaded);
  return margin;
}

/// Static safety, and the force at which the first ellipse reaches the edge of a flank over the largest force.
void take_static_limits(const MeasuresResult& r, const JudgedCase& of, FoundCriterion& safety, FoundCriterion& edge) {
  for (std::size_t k = 0; k < r.load_measures.size(); ++k) {
    const auto& m = r.load_measures[k];
    const LoadCaseResult& loaded = r.analysis.load_cases[k];
    const LoadCase& load = loaded.load_case;
    if (!m || of.preloaded.contains(load.name)) continue;
    const std::string_view shares =
        load.share == LoadCase::Share::equal ? "equal thread loads" : "estimate with the thread loads under this force";
    if (m->solved_static_safety)
      safety.take(m->solved_static_safety, load.name,
                  fmt::format("{}, {}", describe(*m->solved_static_safety_limit), of.at_rest()));
    else if (m->thread_static_safety)
      safety.take(*m->thread_static_safety /
                      (*m->thread_static_safety_limit == StaticLimit::given ? 1.0 : rise_elsewhere(loaded)),
                  load.name, fmt::format("{}, {}, {}", shares, describe(*m->thread_static_safety_limit), of.at_rest()));
    if (m->flank_edge_margin)
      edge.take(m->flank_edge_margin, load.name, of.at_rest());
    else
      edge.take(flank_edge_estimate(r, k), load.name, fmt::format("{}, {}", shares, of.at_rest()));
  }
}

}  // namespace

InSeriesOf in_series_of(const MeasuresResult& r, const JudgedCase& of) {
  return [&r, &of](const LoadCase& load) -> std::optional<InSeries> {
    const auto name_of = [](const LoadCaseResult& loaded) -> const std::string& { return loaded.load_case.name; };
    const auto k = static_cast<std::size_t>(std::ranges::find(r.analysis.load_cases, load.name, name_of) -
                                            r.analysis.load_cases.begin());
    if (k >= r.load_measures.size()) return std::nullopt;
    if (const auto& m = r.load_measures[k]; m && m->system_stiffness) {
      const auto& mechanism = m->system_stiffness->contributions.mechanism;
      return InSeries{"Stiffness of the axis",
                      1.0 / m->system_stiffness->total - (mechanism ? 1.0 / mechanism->stiffness : 0.0)};
    }
    const auto compliance = [](const std::optional<double>& stiffness) { return stiffness ? 1.0 / *stiffness : 0.0; };
    const double shaft = compliance(r.measures.shaft_stiffness),
                 bearing = of.c.bearings ? compliance(of.c.bearings->fixed.stiffness) : 0.0;
    if (shaft + bearing == 0.0) return std::nullopt;
    return InSeries{bearing == 0.0 ? "Stiffness with the shaft"
                    : shaft > 0.0  ? "Stiffness with shaft and bearing"
                                   : "Stiffness with the bearing",
                    shaft + bearing};
  };
}

std::vector<FoundCriterion> measures_criteria(const MeasuresResult& r, const JudgedCase& of) {
  std::vector<FoundCriterion> all = load_criteria(r.analysis, of, in_series_of(r, of));
  FoundCriterion safety = static_safety_criterion(of.c), edge("flank_edge");
  take_static_limits(r, of, safety, edge);
  const bool lacks = lacks_shaft(of.c);
  FoundCriterion weight("weight", lacks ? kAddShaft : "add structure and materials.density");
  if (const Measures& m = r.measures; m.weight && m.screw_weight_per_length && !lacks)
    weight.take(*m.weight + *m.screw_weight_per_length * of.c.measures->shaft->length, "");
  all.insert(all.end(), {safety, edge, weight});
  return all;
}

}  // namespace prs
