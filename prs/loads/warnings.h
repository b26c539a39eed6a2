#pragma once

#include "prs/loads/result.h"

namespace prs {

/// Warnings with one code and path, those of several load cases, as one.
struct WarningGroup {
  Warning worst;
  std::vector<std::string> cases = {};  ///< Each once; none: it is about the whole case.
  bool differs = false;                 ///< Not all say the same.
  bool several_paths = false;           ///< By the index of the load case.

  std::string text() const;
  /// `worst in push, and 2 other load cases`, or where all say the same `in a, b[0–44]`; empty
  /// where it is about the whole case.
  std::string where() const;
};

/// Groups in the order of their first members.
std::vector<WarningGroup> grouped(const std::vector<Warning>& warnings);

/// Those of the whole case, then those of the load cases with their names.
std::vector<Warning> all_warnings(std::vector<Warning> of_case,
                                  const std::vector<LoadCaseResult>& load_cases);
std::vector<Warning> all_warnings(const Result& result);

/// Each group once with the cases it concerns, in the units of tables, below a heading. Empty where
/// there is none.
std::string warning_summary(const std::vector<Warning>& warnings);
/// The same below an empty line.
std::string warning_section(const std::vector<Warning>& warnings);

}  // namespace prs
