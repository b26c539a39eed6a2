#include "prs/loads/load_pictures.h"

#include <algorithm>
#include <utility>

namespace prs {

// Each stands in a file `*_figures.cpp`; absent, or none, where the result holds no data.
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
Figures mechanism_section(const Case& c, const Result& result, const FigureOptions& options);
Figures mechanism_end(const Case& c, const Result& result, const FigureOptions& options);
Figures thread_pressure(const Result& result, const FigureOptions& options);
Figures thread_stress(const Case& c, const Result& result, const FigureOptions& options);

namespace {

using enum Picture::Drawn;

constexpr const char* kContactPoints = "a contact point at both interfaces";
constexpr const char* kMechanism = "a mechanism";
constexpr const char* kLoads = "a load case that converged, or equal shares";
constexpr const char* kRange =
    "a range of loads, `axial_force: {from: .., to: .., steps: ..}`, not of equal shares";
constexpr const char* kSweep =
    "a sweep of loads, `axial_force: {from: .., to: .., steps: ..}`, that converged";
constexpr const char* kAllRollers = "a load case of `model: {mechanism: full}` that converged";
constexpr const char* kEllipses =
    "a load case that converged, and contacts that come from the threads";

/// Some solve has not converged: how it went is then the answer.
bool has_failed(const Result& r) {
  return std::ranges::any_of(r.load_cases, [](const LoadCaseResult& c) { return !c.converged(); });
}

/// A single thread carries all: its picture is a dot.
bool has_several_threads(const Result& r) {
  return std::ranges::any_of(r.load_cases, [](const LoadCaseResult& c) {
    return c.threads && c.threads->screw.axial_load.size() > 1;
  });
}

/// Titles name the loads that figures stand on where a screw runs.
Pictures with_loads_in_titles(Pictures pictures, const Result& r) {
  const auto runs = [](const LoadCaseResult& c) { return c.loads == ModelOptions::Loads::running; };
  if (std::ranges::none_of(r.load_cases, runs)) return pictures;
  const char* loads =
      std::ranges::all_of(r.load_cases, runs) ? ", running loads" : ", static and running loads";
  for (Picture& picture : pictures)
    picture.make = [make = std::move(picture.make), loads](const FigureOptions& options) {
      Figures figures = make(options);
      for (Figure& figure : figures)
        if (!figure.title.empty()) figure.title += loads;
      return figures;
    };
  return pictures;
}

Pictures load_pictures(const Result& r) {
  const Picture::Drawn of_threads = drawn_if(has_several_threads(r));
  return {
      {"load_distribution", kLoads, of_result(r, load_distribution), of_threads},
      {"peak_pressure", "load cases, and contacts that come from the threads",
       of_result(r, peak_pressure), of_threads},
      {"ellipses", "load cases, and contacts that come from the threads", of_result(r, ellipses),
       of_threads},
      {"displacement", kRange, of_result(r, displacement)},
      {"stiffness", kRange, of_result(r, stiffness)},
      {"butterfly", kSweep, of_result(r, butterfly)},
      {"roller_loads", kAllRollers, of_result(r, roller_loads)},
      {"roller_shares", kAllRollers, of_result(r, roller_shares)},
      {"carrier_turn", "`orbit` in a load case of the full mechanism", of_result(r, carrier_turn)},
      {"convergence", "at most a few load cases, not of equal shares", of_result(r, convergence),
       has_failed(r) ? always : with_all},
  };
}

}  // namespace

Pictures contact_pictures(const Result& r) {
  return with(
      {{"contact_axial_section", kContactPoints, of_result(r.contacts, contact_axial_section)},
       {"contact_xy", kContactPoints, of_result(r.contacts, contact_xy)},
       {"contact_ellipses", kContactPoints, of_result(r, contact_ellipses)}},
      load_pictures(r));
}

Pictures solve_pictures(const Result& r) {
  return with(with_loads_in_titles(load_pictures(r), r), contact_pictures(r));
}

Pictures drawings(const Case& c, const Result& r) {
  const auto draw = [&c, &r](Figures (*make)(const Case&, const Result&, const FigureOptions&)) {
    return [&c, &r, make](const FigureOptions& options) { return make(c, r, options); };
  };
  return {{"section", kMechanism, draw(mechanism_section), by_name},
          {"end_view", kMechanism, draw(mechanism_end), by_name},
          {"thread_pressure", kEllipses, of_result(r, thread_pressure), by_name},
          {"thread_stress", kEllipses, draw(thread_stress), by_name}};
}

Pictures with_drawings(Pictures pictures, const Case& c, const Result& r) {
  std::ranges::move(drawings(c, r), std::back_inserter(pictures));
  return pictures;
}

}  // namespace prs
