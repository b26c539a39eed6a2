#pragma once

#include "prs/loads/result.h"

namespace prs {

/// Library, version and kind of what factorized the sparse equations of a load case:
/// `CHOLMOD 3.0.14, simplicial LDL'`. Absent where none were solved.
std::optional<std::string> factorization(const LoadCaseResult& result);

}  // namespace prs
