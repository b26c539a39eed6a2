#pragma once

#include "prs/record/analysis.h"

namespace prs {

/// An amount of a response, in its unit or as a share of numbers.
struct Spread {
  enum class Of {
    value,
    mean,  ///< Share of the mean magnitude of all numbers.
    each,  ///< Share of each number.
  };

  Of of = Of::value;
  double amount = 0.0;
  std::string text = {};  ///< Text as written.

  /// Amount for a number among those with that mean.
  double at(double number, double mean) const;
};

/// A row of a reference.
struct ReferenceReading {
  double along = 0.0;               ///< Abscissa in the reference's unit; for threads from 1.
  double value = 0.0;               ///< Value in the response's unit.
  std::optional<double> deviation;  ///< Deviation of the reference itself.
  std::size_t line = 0;             ///< Line of the file.
};

/// Result of another program or of a test for a response of one load case or of the case: over the threads, over
/// an input, or as one number.
struct ReferenceCurve {
  std::string name, file;
  std::string at;         ///< Path in the document: `references[0]`.
  std::string load_case;  ///< Empty of responses of the whole case.
  Command command = Command::solve;
  std::string response;  ///< Path in a load case, `screw.load_rate_percent`, or in the document: `life.system.life_km`.
  std::string unit;      ///< Unit of the response for people: `um`; empty for ratios.
  std::string along;     ///< `thread`, the key or path of an input, or empty.
  std::string along_unit;
  std::vector<ReferenceReading> readings;  ///< Readings, ascending.
  std::optional<Spread> tolerance;
  std::vector<Case> cases = {};  ///< Cases of the readings over an input, each with its load case only.

  bool is_over_threads() const { return along == "thread"; }
  bool is_over_force() const { return along == "axial_force" || along.ends_with(".axial_force"); }
  std::vector<double> values() const;
  double mean_magnitude() const;
};

}  // namespace prs
