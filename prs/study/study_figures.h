#pragma once

#include "prs/study/study_pictures.h"

namespace prs {

// Figures of a study; none if the result holds no data.

/// Whether a map shows more than lines do: a grid over two numeric factors of many levels.
bool suits_map(const Study& study);

/// The envelope of several measures over two factors (Jung 2017, figs. 7.7 to 8.8).
Figures study_envelope(const StudyResult& result, const FigureOptions& options);

/// Responses of a grid over two factors.
Figures study_maps(const StudyResult& result, const FigureOptions& options);

/// Arrays of one factor at a time, or of a grid over its longest factor: a map of factor and entry, and the
/// same as a surface.
Figures array_surfaces(const StudyResult& result, const FigureOptions& options);

/// Contributions of each factor to the responses: to their linear surfaces, or to their variance.
Figures contributions(const StudyResult& result, const FigureOptions& options);

/// A response of a sampled study over the most important factors.
Figures design_clouds(const StudyResult& result, const FigureOptions& options);

/// Distributions of the responses, the first of them in one figure.
Figures histograms(const StudyResult& result, const FigureOptions& options);

}  // namespace prs
