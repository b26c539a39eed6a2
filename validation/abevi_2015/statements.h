#pragma once

#include "validation/extensions.h"

namespace prs::abevi_2015 {

/// Statements of Abevi et al. 2015 in words about their screw, compared with its solutions: CONFIG 1 to 3, tension and
/// compression, flexible and rigid rollers, loads up to 45 kN, for the guidance of the paper and its alternatives.
/// `screw` is the paper's screw; its load cases are not used.
std::vector<ComparedStatement> compare_statements(const Case& screw, const Reference& paper);

}  // namespace prs::abevi_2015
