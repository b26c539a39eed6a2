#pragma once

#include "validation/sandu_2018/reference_example.h"

namespace prs::sandu_2018 {

/// Statements of chapters 2 and 3 of Sandu 2018 in words, judged on the reference example of table 3.2 and around it,
/// with Jacod's friction and with Coulomb's. Ranges that the text does not give are in the evidence.
std::vector<ComparedStatement> compare_statements(const Case& reference, const Reference& thesis);

}  // namespace prs::sandu_2018
