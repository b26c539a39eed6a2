#pragma once

#include "prs/loads/result.h"
#include "prs/record/pictures.h"

namespace prs {

/// Load of a case [kN], tension > 0 > compression.
double signed_kN(const LoadCaseResult& result);

/// The load cases that the options choose. Throws NoFigure.
std::vector<const LoadCaseResult*> chosen(const Result& result, const FigureOptions& options);

/// The case that the options choose, else, of those for which `has` is true, the one with the largest force, among
/// equals with the largest load of a thread; null if there is none.
const LoadCaseResult* chosen_case(const Result& result, const FigureOptions& options,
                                  bool (*has)(const LoadCaseResult&));

/// A picture of the case that the options choose, of which `has` is true; the result must outlive it.
template <class Made>
auto of_case(const Result& result, bool (*has)(const LoadCaseResult&),
             Made (*make)(const Result&, const LoadCaseResult&)) {
  return [&result, has, make](const FigureOptions& options) {
    const LoadCaseResult* shown = chosen_case(result, options, has);
    return shown ? in_shown_units(listed(make(result, *shown))) : Figures{};
  };
}

/// Quantity compared over the threads, for pictures of analyses that add to the results of load cases.
struct ThreadPlot {
  const char* name;
  const char* title;
  const char* label;
  const char* unit;
  const std::vector<double>& (*values)(const LoadCaseResult&, Interface);
  double factor;
  bool (*keep)(const LoadCaseResult&);
  /// Value of a dashed line in the colour of the case's line, if there is one.
  std::optional<double> (*level)(const LoadCaseResult&, Interface) = nullptr;
};

/// Figure with a row of panels per direction, one column per interface, one line per configuration; none without a load
/// case for which `keep` is true.
Figure thread_figure(const ThreadPlot& plot, const Result& result, const FigureOptions& options);

/// `at rest`, `running` or `at rest and running`: the loads of all cases, for titles.
std::string state_of_loads(const Result& result);

/// Whether one roller represents all.
bool has_shares(const LoadCaseResult& result);

/// The figure with values from zero on.
Figure from_zero(Figure figure);

/// Whether the case is solved with all rollers.
bool has_rollers(const LoadCaseResult& result);

/// A quantity of every thread of every roller, in shown units, and the load cases that have it.
struct OfThreads {
  bool (*has)(const LoadCaseResult&);
  const std::vector<double>& (*values)(const LoadCaseResult&, Interface);
};

/// A map of all rollers for each interface, for the load case that the options choose.
Figure map_of_rollers(Figure figure, const Result& result, const FigureOptions& options, ColourScale colours,
                      const OfThreads& of);

// Pictures of each command. The result must outlive the list.
Pictures contact_pictures(const Result& result);
Pictures solve_pictures(const Result& result, bool butterflies_of_load = false);
/// Pictures of all rollers; full mechanism only.
Pictures roller_pictures(const Result& result);

}  // namespace prs
