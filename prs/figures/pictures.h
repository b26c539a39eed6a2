#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "prs/compare/compare_models.h"
#include "prs/figures/figure.h"
#include "prs/life/analyze_life.h"
#include "prs/loads/result.h"
#include "prs/measures/analyze_measures.h"
#include "prs/optimize/optimization_result.h"
#include "prs/preload/analyze_preload.h"
#include "prs/study/derivatives.h"
#include "prs/study/study_result.h"

namespace prs {

using Figures = std::vector<Figure>;

/// Which of several pictures of a kind, and what it shows.
struct FigureOptions {
  std::vector<std::size_t> load_cases = {};  ///< By their places; empty: all.
  std::optional<std::size_t> load_case = {};
  std::optional<Interface> interface = {};
  std::optional<std::string> response = {};  ///< A path; absent: one figure for each.
  std::optional<std::string> x = {};         ///< Paths of factors.
  std::optional<std::string> y = {};
  std::optional<std::size_t> thread = {};  ///< Of all rollers, from 0; absent: the most loaded.
  std::optional<std::size_t> panel = {};   ///< Only this one.
  bool one_panel = false;                  ///< All in one panel, as far as that is possible.
};

/// There is no such picture, or the result has no data for it.
class NoFigure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A picture of a result.
struct Picture {
  std::string_view name;
  std::string_view needs;  ///< What the result must have.
  std::function<Figures(const FigureOptions&)> make;
  /// When a command writes it.
  enum class Drawn { always, with_all, by_name } drawn = Drawn::always;
};
using Pictures = std::vector<Picture>;

// What each command can show. The result must outlive the list.
Pictures contact_pictures(const Result& result);
Pictures solve_pictures(const Result& result);
/// Of the mechanism, asked for by their names alone.
Pictures drawings(const Case& c, const Result& result);
Pictures slip_pictures(const Case& c, const Result& result);
Pictures measures_pictures(const MeasuresResult& result);
Pictures comparison_pictures(const ModelComparison& result);
Pictures preload_pictures(const PreloadResult& result);
Pictures life_pictures(const LifeResult& result);
Pictures study_pictures(const StudyResult& result);
Pictures derivatives_pictures(const CaseDerivatives& result);
Pictures optimization_pictures(const OptimizationResult& result);

/// All that the result has data for, as a command writes them; with `all` (`--all`), also those
/// that few readers want.
Figures figures(const Pictures& pictures, bool all = false);

/// One of them, the first where the options leave several, in one panel if they ask for it. Throws
/// NoFigure.
Figure figure(const Pictures& pictures, std::string_view name, const FigureOptions& options);

}  // namespace prs
