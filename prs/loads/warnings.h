#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "prs/loads/result.h"

namespace prs {

/// Warnings of several load cases that differ in their numbers only, as one.
struct WarningGroup {
  std::string pattern;             ///< The text without its numbers.
  std::string place;               ///< Path of the load case, with which the text begins; or empty.
  std::string text;                ///< The rest, with the worst numbers of all.
  std::vector<std::string> cases;  ///< All load cases; none where it is about the whole case.
  std::string worst = {};          ///< The load case of the text.
  bool differs = false;            ///< Not all cases have these numbers.

  std::string whole() const { return place + text; }
  /// `in a, b[0–44]; worst in b[44]`; empty where it is about the whole case.
  std::string where() const;
};

/// Gathers warnings. Of numbers that differ the first one decides: the larger is the worse, but for
/// what a text gives `at the least`.
class WarningGroups {
 public:
  void add(std::string text, const std::string& load_case = {});
  std::vector<WarningGroup> take() && { return std::move(groups_); }

 private:
  std::vector<WarningGroup> groups_;
  std::set<std::pair<std::string, std::string>> known_;  ///< Pattern and load case.
};

/// The warnings of a result, each once with the cases it concerns. Warnings of several cases that
/// differ in their numbers only, as those of a range do, count as one. Empty where there is none.
std::string warning_summary(const Result& result);
std::string warning_summary(const std::vector<std::string>& warnings,
                            const std::vector<LoadCaseResult>& load_cases);

/// Warnings that belong to no load case, below an empty line; empty where there are none.
std::string warning_section(const std::vector<std::string>& warnings);

}  // namespace prs
