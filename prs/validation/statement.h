#pragma once

#include <functional>
#include <string>
#include <vector>

namespace prs {

/// What a predicate found: whether the statement is true of some results, and the numbers that say
/// so.
struct Finding {
  bool holds = false;
  std::string evidence;
};

/// What the run says of a statement that a source makes in words.
struct Verdict {
  enum class Kind { holds, holds_only_with, does_not_hold };
  Kind kind = Kind::does_not_hold;
  std::vector<std::string> only_with;  ///< Variants of the model under which it holds.
  std::string evidence;                ///< From the plain model and the first variant that holds.
  std::string why;                     ///< Reason why it does not hold with the plain model.
};

struct ComparedStatement {
  std::string section;
  std::string text;
  Verdict verdict;
};

/// A statement in words, turned into a predicate on the results of one variant of the model.
template <class Results>
struct Statement {
  std::string section;  ///< Where the source makes it.
  std::string text;     ///< The source's words.
  std::function<Finding(const Results&)> predicate;
  std::string why = {};  ///< The mechanics behind it where it does not hold; shown only then.
};

/// A named set of results; the first one of a list is the plain model.
template <class Results>
struct Variant {
  std::string name;
  Results results;
};

/// Compares a statement with the plain model first, then with the variants.
template <class Results>
Verdict compare(const Statement<Results>& statement,
                const std::vector<Variant<Results>>& variants) {
  Verdict verdict;
  for (const Variant<Results>& variant : variants) {
    const bool plain = &variant == &variants.front();
    const Finding finding = statement.predicate(variant.results);
    if (plain) verdict.evidence = finding.evidence;
    if (!finding.holds) continue;
    if (plain) {
      verdict.kind = Verdict::Kind::holds;
      return verdict;
    }
    if (verdict.only_with.empty())
      verdict.evidence += "; " + variant.name + ": " + finding.evidence;
    verdict.kind = Verdict::Kind::holds_only_with;
    verdict.only_with.push_back(variant.name);
  }
  verdict.why = statement.why;
  return verdict;
}

template <class Results>
std::vector<ComparedStatement> compare(const std::vector<Statement<Results>>& statements,
                                       const std::vector<Variant<Results>>& variants) {
  std::vector<ComparedStatement> compared;
  for (const Statement<Results>& s : statements)
    compared.push_back({s.section, s.text, compare(s, variants)});
  return compared;
}

}  // namespace prs
