#pragma once

#include <optional>
#include <string>
#include <vector>

#include "prs/figures/figure.h"
#include "prs/loads/result.h"

namespace prs {

/// What the threads are compared by.
struct ThreadPlot {
  std::string name;
  std::string title;
  std::string y_label;
  const std::vector<double>& (*values)(const LoadCaseResult&, Interface);
  double factor;
  bool (*keep)(const LoadCaseResult&);
  /// A dashed level of the colour of its line, where a case has one, and its title.
  std::optional<double> (*level)(const LoadCaseResult&, Interface) = nullptr;
  std::string level_title = {};
};

/// A value of each thread: a row of panels a direction, a column an interface, a line a
/// configuration. A range is represented by its last point. The range of y is left to the caller.
std::optional<Figure> thread_figure(const ThreadPlot& plot, const Result& result);

}  // namespace prs
