#pragma once

#include <vector>

#include "prs/figures/figure.h"
#include "prs/study/study_result.h"

namespace prs {

/// The figures of a study, at most 24 of each kind.
///
/// - one_at_a_time: with slip, one a factor: power by source, stacked, and efficiency beside its
/// fit
///   (Sandu 2018, fig. 3.9 and appendix C). Otherwise one a response, with a panel a factor. The
///   base case is marked. Levels without a number stand in their order.
/// - grid: one a response over the numeric factor with most values, a line for each value of a
///   second factor and a panel for each combination of the others; or, of two numeric factors with
///   many equidistant values each, a map.
/// - grid with an envelope: the envelope and each response as a map in bands of colour with lines
/// of
///   equal value, and as a surface, with the designs read off marked (Jung 2017, figs. 7.7 to 8.8).
/// - sampled plans: for each response the Pareto graph of the contributions to its linear surface
///   (Yao et al. 2023, figs. 8, 9) or the shares of its variance with 95 % intervals, and the
///   designs over the factors that matter most; histograms of all responses.
std::vector<Figure> study_figures(const StudyResult& result);

}  // namespace prs
