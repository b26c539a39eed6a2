#pragma once

#include <string_view>
#include <vector>

#include "prs/loads/result.h"
#include "prs/record/figure_parts.h"

namespace prs {

/// Load of a case [kN], tension > 0 > compression.
double signed_kN(const LoadCaseResult& result);

/// The load cases that the options choose. Throws NoFigure.
std::vector<const LoadCaseResult*> chosen(const Result& result, const FigureOptions& options);

/// The case that the options choose, else of those that `has` says have what is needed that of the
/// largest force, among equals that with the largest load of a thread; else none.
const LoadCaseResult* chosen_case(const Result& result, const FigureOptions& options,
                                  bool (*has)(const LoadCaseResult&));

}  // namespace prs
