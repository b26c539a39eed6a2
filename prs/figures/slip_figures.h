#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "prs/figures/figure.h"
#include "prs/loads/result.h"
#include "prs/slip/slip.h"

namespace prs {

// The figures that slip gives rise to; absent where the result holds no data for one. Numbers of
// lines are bounded as in result_figures.h.

/// Power lost at each thread of a roller [W], laid out like the load distribution, with what
/// equal shares would give at the interface that loses more.
std::optional<Figure> thread_power_figure(const Result& result);

/// Friction coefficient and sliding velocity over the patch of the most loaded thread at both
/// interfaces, in the frame of the ellipse's axes [mm] (Sandu 2018, figs. 2.8, 2.9). The longest
/// arrow of each patch is as long as two of them lie apart.
Figure slip_patch_figure(const LoadCaseResult& result, const SlipPictures& pictures);

/// Moment on a roller about its axis against the slip ratio [N mm]: its contributions and their
/// sum over the whole range and, against the distance from the ideal slip ratio, around the root
/// (fig. 3.6).
Figure slip_residue_figure(const LoadCaseResult& result, const SlipPictures& pictures);

/// All of these, and power over the load. Patches and residue are those of the load cases, given by
/// their indices, whose pictures are there; of several their names end in `_1`, `_2`, ...
std::vector<Figure> slip_figures(const Result& result,
                                 const std::vector<std::pair<std::size_t, SlipPictures>>& pictures);

/// A point to compare with, as a measurement or the case that a sweep starts from.
struct ReferencePoint {
  std::string title;
  double x = 0.0;
  std::optional<double> power_loss = std::nullopt;  ///< [W]
  std::optional<double> efficiency = std::nullopt;
};

/// What may stand beside the curves of a sweep.
struct PowerFigureOptions {
  std::string name = "power_by_source";
  std::string title = "Power lost by source";
  std::optional<double> relative_to = std::nullopt;  ///< Shows power as a share of this [W].
  std::vector<ReferencePoint> references = {};       ///< At most four.
  std::string comparison_title = {};
  std::vector<std::array<double, 2>> comparison = {};  ///< (x, efficiency) of another model.
};

/// Power of each source, stacked, and efficiency over a swept quantity `x`, given as it is shown
/// (fig. 3.9). Results without an answer interrupt the areas; at least one must have one.
Figure power_by_source_figure(const std::vector<double>& x, const std::string& x_label,
                              const std::vector<SlipResult>& results,
                              const PowerFigureOptions& options = {});

/// The same over the load [kN] of each range, one a figure, at most four.
std::vector<Figure> power_over_load_figures(const Result& result);

}  // namespace prs
