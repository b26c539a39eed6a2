#pragma once

#include "prs/study/study_parts.h"

namespace prs {

/// Whether a map shows more than lines do: a grid over two numeric factors of many levels.
bool suits_map(const Study& study);

// Figures of a study; none where the result holds no data.

/// The envelope of several measures over two factors (Jung 2017, figs. 7.7 to 8.8).
Figures study_envelope(const StudyResult& result, const FigureOptions& options);

/// Responses of a grid over two factors.
Figures study_maps(const StudyResult& result, const FigureOptions& options);

/// What each factor contributes to the responses: to their linear surfaces, or to their variance.
Figures contributions(const StudyResult& result, const FigureOptions& options);

/// A response of a sampled study over the factors that matter most.
Figures design_clouds(const StudyResult& result, const FigureOptions& options);

/// How the responses scatter, the first of them in one figure.
Figures histograms(const StudyResult& result, const FigureOptions& options);

/// What a study can show. The result must outlive the list.
Pictures study_pictures(const StudyResult& result);

}  // namespace prs
