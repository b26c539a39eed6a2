#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace prs {

/// How a design ended.
struct DesignStatus {
  /// `refused` (the case describes no mechanism), `failed` (the program does not know why), or how
  /// the solve of the first load case that did not converge ended.
  std::string name = "converged";
  std::string reason = {};  ///< Empty where converged.

  bool converged() const { return name == "converged"; }
};

/// Answers of consecutive designs of a study.
struct RowBlock {
  /// A design without an answer.
  struct Failure {
    std::size_t row = 0;  ///< Row in the block.
    DesignStatus status;
  };

  std::size_t first = 0;          ///< Index of the first design.
  std::size_t rows = 0;           ///< Number of designs.
  std::vector<double> responses;  ///< rows x responses; NaN where a design has none.
  std::vector<Failure> failures;  ///< Ascending; all other designs converged.
};

inline constexpr double kNoResponse = std::numeric_limits<double>::quiet_NaN();

}  // namespace prs
