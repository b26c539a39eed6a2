#pragma once

#include "prs/study/derivatives.h"
#include "prs/study/study_parts.h"

namespace prs {

/// Whether the study records what a figure of power by source shows.
bool has_power(const StudyResult& result);

/// Whether each design differs from the file in one factor.
inline bool varies_one_at_a_time(const Study& study) {
  return study.plan == Plan::one_at_a_time ||
         (study.plan == Plan::grid && study.factors.size() == 1);
}

/// Whether a map shows more than lines do: a grid over two numeric factors of many levels.
bool suits_map(const Study& study);

/// A response over each factor, a panel each; in one panel its changes over those of the factors.
Figures one_at_a_time_lines(const StudyResult& result, const FigureOptions& options);

/// A response over the numeric factor with most values, a line for each value of a second factor
/// and a panel for each combination of the others.
Figures grid_lines(const StudyResult& result, const FigureOptions& options);

/// A response of a sampled study over the factors that matter most.
Figures design_clouds(const StudyResult& result, const FigureOptions& options);

/// What a study and the derivatives of a case can show. The result must outlive the list.
Pictures study_pictures(const StudyResult& result);
Pictures derivatives_pictures(const CaseDerivatives& result);

}  // namespace prs
