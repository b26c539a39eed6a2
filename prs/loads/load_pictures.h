#pragma once

#include "prs/loads/result.h"
#include "prs/record/pictures.h"

namespace prs {

/// Load of a case [kN], tension > 0 > compression.
double signed_kN(const LoadCaseResult& result);

/// The load cases that the options choose. Throws NoFigure.
std::vector<const LoadCaseResult*> chosen(const Result& result, const FigureOptions& options);

/// The case that the options choose, else of those that `has` says have what is needed that of the
/// largest force, among equals that with the largest load of a thread; else none.
const LoadCaseResult* chosen_case(const Result& result, const FigureOptions& options,
                                  bool (*has)(const LoadCaseResult&));

// Pictures over the threads of load cases, for the analyses that add to their results.

/// What the threads are compared by.
struct ThreadPlot {
  const char* name;
  const char* title;
  const char* label;
  const char* unit;
  const std::vector<double>& (*values)(const LoadCaseResult&, Interface);
  double factor;
  bool (*keep)(const LoadCaseResult&);
  /// A dashed level of the colour of its line, where a case has one.
  std::optional<double> (*level)(const LoadCaseResult&, Interface) = nullptr;
};

/// A row of panels a direction, one column per interface, one line per configuration; none without
/// a load case that `keep` holds of.
std::optional<Figure> thread_figure(const ThreadPlot& plot, const Result& result, const FigureOptions& options);

/// Whether one roller stands for all.
bool has_shares(const LoadCaseResult& result);

/// The figure with values from zero on; none of none.
Figures from_zero(std::optional<Figure> figure);

/// A thread of a load case; its number counts over all rollers, from 0.
struct ChosenThread {
  const LoadCaseResult* load_case = nullptr;
  std::size_t thread = 0;

  const InterfaceLoads& at(Interface i) const { return (*load_case->threads)[i]; }
  bool has_ellipse(Interface i) const { return thread < at(i).semi_minor.size() && at(i).semi_minor[thread] > 0.0; }
};

/// The one that the options name, else the most loaded; none without a load case that `has` holds
/// of.
std::optional<ChosenThread> chosen_thread(const Result& result, const FigureOptions& options,
                                          bool (*has)(const LoadCaseResult&));

/// Whether it is solved with all rollers.
bool has_rollers(const LoadCaseResult& result);

/// A quantity of every thread of every roller, in shown units, and which load cases have it.
struct OfThreads {
  bool (*has)(const LoadCaseResult&);
  const std::vector<double>& (*values)(const LoadCaseResult&, Interface);
};

/// A map of all rollers for each interface, of the load case that the options choose.
Figures map_of_rollers(Figure figure, const Result& result, const FigureOptions& options, ColourScale colours,
                       const OfThreads& of);

/// Pictures of travels and modes.
Pictures motion_pictures(const Result& result);

// What each command can show. The result must outlive the list.
Pictures contact_pictures(const Result& result);
Pictures solve_pictures(const Result& result, bool butterflies_of_load = false);
/// Sections of the threads through their contacts, and the contact ellipses.
Pictures contact_drawings(const Result& result);
/// Pictures of all rollers; full mechanism only.
Pictures roller_pictures(const Result& result);
/// Drawings of the mechanism, asked for by their names alone.
Pictures drawings(const Case& c, const Result& result);
Pictures with_drawings(Pictures pictures, const Case& c, const Result& result);

}  // namespace prs
