#pragma once

#include <string>

#include "prs/loads/result.h"

namespace prs {

/// The warnings of a result, each once with the cases it concerns. Warnings of several cases that
/// differ in their numbers only, as those of a range do, count as one. Empty where there is none.
std::string warning_summary(const Result& result);
std::string warning_summary(const std::vector<std::string>& warnings,
                            const std::vector<LoadCaseResult>& load_cases);

/// Warnings that belong to no load case, below an empty line; empty where there are none.
std::string warning_section(const std::vector<std::string>& warnings);

}  // namespace prs
