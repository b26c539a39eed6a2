#include "prs/figures/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "prs/figures/contact_parts.h"
#include "prs/figures/slip_parts.h"
#include "prs/figures/study_pictures.h"
#include "prs/quantities/slip_quantities.h"

namespace prs {

// Each stands in a file of prs/figures; absent, or none, where the result holds no data.
Figures contact_axial_section(const Contacts& contacts);
Figures contact_xy(const Contacts& contacts);
Figures contact_ellipses(const Result& result, const FigureOptions& options);
Figures load_distribution(const Result& result, const FigureOptions& options);
Figures peak_pressure(const Result& result, const FigureOptions& options);
Figures stiffness(const Result& result, const FigureOptions& options);
Figures displacement(const Result& result, const FigureOptions& options);
Figures butterfly(const Result& result, const FigureOptions& options);
Figures convergence(const Result& result, const FigureOptions& options);
Figures ellipses(const Result& result, const FigureOptions& options);
Figures roller_loads(const Result& result, const FigureOptions& options);
Figures roller_shares(const Result& result, const FigureOptions& options);
Figures carrier_turn(const Result& result, const FigureOptions& options);
Figures roller_power(const Result& result, const FigureOptions& options);
Figures roller_friction(const Result& result, const FigureOptions& options);
Figures mechanism_section(const Case& c, const Result& result, const FigureOptions& options);
Figures mechanism_end(const Case& c, const Result& result, const FigureOptions& options);
Figures thread_pressure(const Result& result, const FigureOptions& options);
Figures thread_stress(const Case& c, const Result& result, const FigureOptions& options);
Figures thread_friction(const Case& c, const Result& result, const FigureOptions& options);
Figures thread_power(const Result& result, const FigureOptions& options);
Figures friction(const Result& result, const FigureOptions& options);
Figures power_by_source(const Result& result, const FigureOptions& options);
Figures heat_cycle(const Result& result);
Figures yang(const MeasuresResult& result);
Figures stiffness_terms(const MeasuresResult& result);
Figures loads_by_model(const ModelComparison& result, const FigureOptions& options);
Figures preload_curves(const PreloadResult& result);
Figures load_history(const LifeResult& result);
Figures rainflow(const LifeResult& result);
Figures thread_loads(const LifeResult& result);
Figures thread_lives(const LifeResult& result);
Figures study_power(const StudyResult& result, const FigureOptions& options);
Figures study_envelope(const StudyResult& result, const FigureOptions& options);
Figures study_maps(const StudyResult& result, const FigureOptions& options);
Figures contributions(const StudyResult& result, const FigureOptions& options);
Figures histograms(const StudyResult& result, const FigureOptions& options);
Figures elasticities(const CaseDerivatives& result, const FigureOptions& options);
Figures optimization_history(const OptimizationResult& result);
Figures pareto_front(const OptimizationResult& result);

namespace {

using enum Picture::Drawn;

constexpr const char* kContactPoints = "a contact point at both interfaces";
constexpr const char* kMechanism = "a mechanism";
constexpr const char* kLoads = "a load case that converged, or equal shares";
constexpr const char* kSweep =
    "a sweep of loads, `axial_force: {from: .., to: .., steps: ..}`, that converged";
constexpr const char* kRange =
    "a range of loads, `axial_force: {from: .., to: .., steps: ..}`, not of equal shares";
constexpr const char* kAllRollers = "a load case of `model: {mechanism: full}` that converged";
constexpr const char* kSlip = "a load case whose slip converged";
constexpr const char* kSlipOfRollers =
    "a load case of `model: {mechanism: full}` whose slip converged";
constexpr const char* kEllipses =
    "a load case that converged, and contacts that come from the threads";
constexpr const char* kLives = "a load history or spectrum under which loads converge";

Figures in_kilonewtons(Figures figures) {
  for (Figure& figure : figures) figure = in_kilonewtons(std::move(figure));
  return figures;
}

/// A picture that a function makes of the result.
template <class Result_>
auto of(const Result_& result, Figures (*make)(const Result_&, const FigureOptions&)) {
  return [&result, make](const FigureOptions& options) {
    return in_kilonewtons(make(result, options));
  };
}
template <class Result_>
auto of(const Result_& result, Figures (*make)(const Result_&)) {
  return [&result, make](const FigureOptions&) { return in_kilonewtons(make(result)); };
}

/// Those of another command, asked for by their names alone.
Pictures with(Pictures own, Pictures others) {
  for (Picture& picture : others) {
    picture.drawn = by_name;
    own.push_back(std::move(picture));
  }
  return own;
}

/// Fields of the load cases, by their index: integrated once for all pictures of them.
using SlipFields = std::map<std::size_t, SlipPictures>;

/// For the load cases whose slip converged, at most four; of several, names end in `_1`, `_2`, ..
auto of_slip(const Result& result, std::function<Figure(std::size_t)> make) {
  return [&result, make = std::move(make)](const FigureOptions& options) {
    constexpr std::size_t kMost = 4;
    std::vector<std::size_t> cases;
    for (std::size_t k = 0; k < result.load_cases.size() && cases.size() < kMost; ++k)
      if (has_slip(result.load_cases[k]) && (!options.load_case || k == *options.load_case))
        cases.push_back(k);
    Figures figures;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      figures.push_back(make(cases[k]));
      if (cases.size() > 1) figures.back().name += fmt::format("_{}", k + 1);
    }
    return figures;
  };
}

Picture::Drawn drawn_if(bool suitable) { return suitable ? always : by_name; }

/// Some solve has not converged: how it went is then the answer.
bool has_failed(const Result& r) {
  return std::ranges::any_of(r.load_cases, [](const LoadCaseResult& c) { return !c.converged(); });
}

Pictures load_pictures(const Result& r) {
  return {
      {"load_distribution", kLoads, of(r, load_distribution)},
      {"peak_pressure", "load cases, and contacts that come from the threads",
       of(r, peak_pressure)},
      {"ellipses", "load cases, and contacts that come from the threads", of(r, ellipses)},
      {"displacement", kRange, of(r, displacement)},
      {"stiffness", kRange, of(r, stiffness)},
      {"butterfly", kSweep, of(r, butterfly)},
      {"roller_loads", kAllRollers, of(r, roller_loads)},
      {"roller_shares", kAllRollers, of(r, roller_shares)},
      {"carrier_turn", "`orbit` in a load case of the full mechanism", of(r, carrier_turn)},
      {"convergence", "at most a few load cases, not of equal shares", of(r, convergence),
       has_failed(r) ? always : with_all},
  };
}

}  // namespace

Pictures contact_pictures(const Result& r) {
  return with({{"contact_axial_section", kContactPoints, of(r.contacts, contact_axial_section)},
               {"contact_xy", kContactPoints, of(r.contacts, contact_xy)},
               {"contact_ellipses", kContactPoints, of(r, contact_ellipses)}},
              load_pictures(r));
}

Pictures solve_pictures(const Result& r) { return with(load_pictures(r), contact_pictures(r)); }

Pictures drawings(const Case& c, const Result& r) {
  const auto draw = [&c, &r](Figures (*make)(const Case&, const Result&, const FigureOptions&)) {
    return [&c, &r, make](const FigureOptions& options) { return make(c, r, options); };
  };
  return {{"section", kMechanism, draw(mechanism_section), by_name},
          {"end_view", kMechanism, draw(mechanism_end), by_name},
          {"thread_pressure", kEllipses, of(r, thread_pressure), by_name},
          {"thread_stress", kEllipses, draw(thread_stress), by_name}};
}

Pictures slip_pictures(const Case& c, const Result& r) {
  const auto fields = std::make_shared<SlipFields>();
  using OfFields = Figure (*)(const LoadCaseResult&, const SlipPictures&);
  const auto of_fields = [&](OfFields make) {
    return of_slip(r, [&c, &r, fields, make](std::size_t k) {
      if (!fields->contains(k)) fields->emplace(k, slip_pictures(c, r, k));
      return make(r.load_cases[k], fields->at(k));
    });
  };
  const bool mixed = c.friction && c.friction->model == Friction::Model::mixed;
  return with(
      {{"power_by_source", kSlip, of(r, power_by_source)},
       {"thread_power", kSlip, of(r, thread_power)},
       {"friction", kSlip, of(r, friction)},
       {"roller_power", kSlipOfRollers, of(r, roller_power)},
       {"roller_friction", kSlipOfRollers, of(r, roller_friction)},
       {"stribeck", kSlip,
        of_slip(r,
                [&c, &r](std::size_t k) {
                  return stribeck_figure(r.load_cases[k], stribeck_curve(c, r, k));
                }),
        drawn_if(mixed)},
       {"slip_patches", kSlip, of_fields(slip_patch_figure)},
       {"slip_residue", kSlip, of_fields(slip_residue_figure)},
       {"thread_friction", kSlip,
        [&c, &r](const FigureOptions& options) { return thread_friction(c, r, options); }, by_name},
       {"heat_cycle", "a `duty` in `heat` that comes to repeat itself", of(r, heat_cycle)}},
      solve_pictures(r));
}

Pictures measures_pictures(const MeasuresResult& r) {
  return with({{"yang", "load cases that converged, and what Yang's formula needs", of(r, yang)},
               {"stiffness_terms", "loads, structure or `shaft`", of(r, stiffness_terms)}},
              solve_pictures(r.analysis));
}

Pictures comparison_pictures(const ModelComparison& r) {
  return {{"loads_by_model", "a load case that converged with every model", of(r, loads_by_model)}};
}

Pictures preload_pictures(const PreloadResult& r) {
  return {{"preload", "an equilibrium without external load", of(r, preload_curves)}};
}

Pictures life_pictures(const LifeResult& r) {
  return {{"loads", "a load history or spectrum", of(r, load_history)},
          {"rainflow", "a load history, not a spectrum, with cycles", of(r, rainflow)},
          {"thread_loads", kLives, of(r, thread_loads)},
          {"thread_lives", kLives, of(r, thread_lives)}};
}

Pictures study_pictures(const StudyResult& r) {
  const Study& study = r.study;
  const bool map = r.summary.envelope || suits_map(study);
  const bool sampled = is_sampled(study.plan);
  const auto lines = varies_one_at_a_time(study) ? one_at_a_time_lines
                     : study.plan == Plan::grid  ? grid_lines
                                                 : design_clouds;
  const bool power = varies_one_at_a_time(study) && has_power(r);
  return {
      {"envelope", "`study.envelope` in the case", of(r, study_envelope)},
      {"map", "`plan: grid` with two factors of numbers", of(r, study_maps), drawn_if(map)},
      {"power", "`plan: one_at_a_time` of slip", of(r, study_power)},
      {"contributions", "a plan that draws samples, and a response that varies",
       of(r, contributions)},
      {"lines", "designs with an answer", of(r, lines), drawn_if(sampled || (!map && !power))},
      {"histogram", "several designs whose responses differ", of(r, histograms), drawn_if(sampled)},
  };
}

Pictures derivatives_pictures(const CaseDerivatives& r) {
  return {{"elasticities", "factors and responses other than 0 in the file", of(r, elasticities)}};
}

Pictures optimization_pictures(const OptimizationResult& r) {
  return {{"history", "designs", of(r, optimization_history)},
          {"front", "several objectives", of(r, pareto_front)}};
}

Figures figures(const Pictures& pictures, bool all) {
  Figures drawn;
  for (const Picture& picture : pictures)
    if (picture.drawn == always || (all && picture.drawn == with_all))
      for (Figure& figure : picture.make({})) drawn.push_back(std::move(figure));
  return drawn;
}

Figure figure(const Pictures& pictures, std::string_view name, const FigureOptions& options) {
  const auto found = std::ranges::find(pictures, name, &Picture::name);
  if (found == pictures.end()) {
    std::vector<std::string_view> names;
    for (const Picture& picture : pictures) names.push_back(picture.name);
    throw NoFigure(fmt::format("no picture {}; there is {}", name, fmt::join(names, ", ")));
  }
  Figures made = found->make(options);
  if (made.empty()) throw NoFigure(fmt::format("no picture {}: it needs {}", name, found->needs));
  if (options.panel) return only_panel(std::move(made.front()), *options.panel);
  return options.one_panel ? folded(made.front()) : std::move(made.front());
}

bool has_data(const Figure& figure) {
  return std::ranges::any_of(figure.panels, [](const Panel& panel) {
    return !panel.map.grid.empty() || std::ranges::any_of(panel.series, [](const Series& series) {
      return std::ranges::any_of(series.parts, [](const Polyline& p) { return !p.empty(); });
    });
  });
}

}  // namespace prs
