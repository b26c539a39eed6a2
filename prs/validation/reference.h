#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prs/model/command.h"

namespace prs {

/// A number as a source prints it; what is known of it ends with its last digit.
struct PrintedNumber {
  std::string text;             ///< `3.6062e5`
  std::optional<int> decimals;  ///< In place of the last digit's, where the source drops zeros.

  double value() const;
  /// Half a unit of the last known digit.
  double half_unit() const;
  /// Whether a computed number, rounded, is this one.
  bool is_reproduced_by(double computed) const;
  /// Known digits, a leading zero of a number below 1 not counted; those of 0 are its decimals.
  int digits() const;
  /// How many of them a computed number shares, counted by the distance in units of the last.
  int agreeing_digits(double computed) const;

 private:
  int last_place() const;
};

/// What a source prints for a quantity, and what is known to be wrong with it.
struct PrintedValue {
  std::string quantity;  ///< Path in the JSON document: `contact.screw.hertz_constant_N_per_mm1_5`.
  std::string where;     ///< Table or equation of the source.
  PrintedNumber printed;
  std::string differs;  ///< Why the theory does not give it, where it does not; else empty.
  std::optional<PrintedNumber> corrected;  ///< What it gives instead, from an independent source.
};

/// A case, or formulas that the source's code computes without one, and the numbers printed for it.
struct ReferenceCase {
  std::filesystem::path file;        ///< Empty for formulas.
  std::string formulas;              ///< What they give: `table 7.1`; empty for a case.
  Command command = Command::solve;  ///< `solve`, `contact` or `slip`
  std::vector<PrintedValue> values;
};

/// What a source says in words, and the name of its check in the source's code.
struct PrintedStatement {
  std::string section;  ///< Where the source makes it.
  std::string text;     ///< The source's words.
  std::string check;
  std::string why = {};  ///< The mechanics behind it where it does not hold; shown only then.
};

/// `reference.yaml` of one source.
struct Reference {
  std::filesystem::path folder;
  std::string source;  ///< Citation.
  std::vector<ReferenceCase> cases;
  std::vector<PrintedStatement> statements;
};

/// Reads a `reference.yaml`; unknown, duplicate and missing keys are errors. Throws
/// input::InputError.
Reference read_reference(const std::filesystem::path& file);

}  // namespace prs
