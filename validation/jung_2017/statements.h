#pragma once

#include "validation/jung_2017/tables.h"

namespace prs::jung_2017 {

/// Statements in words on maps and rules of chapters 3 to 8: tables 3.10, 4.10, 5.3, 6.2 and the text of 7.1 by the
/// right formulas and by those with the slips of the tables; the rules of Ma et al. on the screw of table 3.1.
std::vector<ComparedStatement> compare_statements(const Case& screw, const Reference& thesis);

}  // namespace prs::jung_2017
