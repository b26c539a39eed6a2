#pragma once

#include <vector>

#include "prs/validation/validate.h"

namespace prs::sandu_2018 {

/// Statements that chapters 2 and 3 of Sandu 2018 make in words, judged on the reference example of
/// table 3.2 and around it, with Jacod's friction and with Coulomb's. Ranges that the text does not
/// give stand in the evidence.
std::vector<ComparedStatement> compare_statements(const Case& reference);

}  // namespace prs::sandu_2018
