#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "prs/figures/figure.h"
#include "prs/study/study_result.h"

namespace prs {

inline constexpr std::size_t kMostStudyFigures = 24;
inline constexpr std::size_t kMostStudyPanels = 12;

/// `03_flank_angle`
std::string study_figure_name(std::size_t index, const std::string& label);

/// Over these values of a factor; with its unit or, of words, what the positions 1, 2, .. stand
/// for. Whole numbers without a unit have a tic each.
Axis factor_axis(const Factor& factor, const std::vector<double>& values);

/// Of a response's values, with its unit.
Axis response_axis(const std::string& path);

/// How many panels stand beside each other.
std::size_t columns_for(std::size_t panels);

/// A filled rectangle.
Polyline rectangle(double left, double right, double bottom, double top);

// The figures of each kind of plan, see study_figures.h.
std::vector<Figure> one_at_a_time_figures(const StudyResult& result);
std::vector<Figure> grid_figures(const StudyResult& result);
std::vector<Figure> sampled_figures(const StudyResult& result);
std::vector<Figure> map_figures(const StudyResult& result);

}  // namespace prs
