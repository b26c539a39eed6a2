#pragma once

#include "prs/losses/slip_analysis.h"
#include "prs/slip/slip_at_speed.h"
#include "prs/slip/slip_pictures.h"

namespace prs {

Figure slip_patch_figure(const LoadCaseResult& result, const SlipPictures& pictures);
/// Figure of one thread of all rollers, counted from 0.
Figure thread_friction_figure(const LoadCaseResult& result, const PerInterface<PatchField>& fields, std::size_t thread);
/// Friction, power, efficiency and film over the speed (Stribeck's curve).
Figure stribeck_figure(const LoadCaseResult& result, const StribeckCurve& curve);
Figure slip_residue_figure(const LoadCaseResult& result, const SlipPictures& pictures);

/// A point to compare with, as a measurement or the case that a sweep starts from.
struct ReferencePoint {
  std::string title;
  double x = 0.0;
  std::optional<double> power_loss = std::nullopt;  ///< [W]
  std::optional<double> efficiency = std::nullopt;
};

/// Additions to the curves in a figure of a sweep.
struct PowerFigureOptions {
  std::string name = "power_by_source";
  std::string title = "Power lost by source";
  std::optional<double> relative_to = std::nullopt;  ///< Shows power as a share of this [W].
  std::vector<ReferencePoint> references = {};
  std::string comparison_title = {};
  std::vector<std::array<double, 2>> comparison = {};  ///< (x, efficiency) of another model.
};

/// Power of each source, stacked, and efficiency over a swept quantity `x`, given as it is shown
/// (Sandu 2018, fig. 3.9). Results without an answer interrupt the areas; at least one has one.
Figure power_by_source_figure(const std::vector<double>& x, const Axis& axis, const std::vector<SlipResult>& results,
                              const PowerFigureOptions& options);

/// Power of each source and efficiency over the load of each range, at most four; else a bar for
/// each load case.
Figures power_by_source(const Result& result, const FigureOptions& options);

/// Temperatures of the parts over the cycle of the duty, their means dashed.
Figures heat_cycle(const HeatCycle& cycle);
Figures heat_cycle(const Result& result);

/// Figures of `slip`, and by their names those of `solve`. Case and result must outlive the list.
Pictures slip_pictures(const Case& c, const Result& result);

}  // namespace prs
