#pragma once

#include "prs/loads/result.h"
#include "prs/reference/curve_deviations.h"
#include "prs/reference/reference.h"

namespace prs {

/// Results of a model of the bodies at the readings of a reference, and their deviations from it.
struct ReferenceAnswer {
  std::vector<double> computed;  ///< Results in the response's unit; NaN if there is none.
  std::optional<CurveDeviations> deviations;
  std::optional<double> slope;  ///< Slope over the force, in the response's unit per N.
  std::optional<double>
      tolerance_use;  ///< Largest deviation over the tolerance at its point; infinite without a result.

  bool met() const { return !tolerance_use || *tolerance_use <= 1.0; }
};

/// A reference and all models.
struct ReferenceComparison {
  ReferenceCurve reference;
  std::vector<ReferenceAnswer> models;  ///< Same order as in the comparison.
  std::size_t stated = 0;               ///< Index of the model that the case states, to which the tolerance applies.
  /// Sum over a complete set of threads, and its value by the load.
  std::optional<double> sum, expected_sum;
  std::optional<double> slope;

  bool met() const { return models[stated].met(); }
};

/// The load cases of a case, solved with each model of the bodies.
struct ModelComparison {
  std::vector<Result> models;     ///< Results, the best model last; load cases are the same in all.
  std::vector<Warning> warnings;  ///< Warnings of the geometry, and reasons why a model is left out.
  std::size_t stated = 0;         ///< Index of the model that the case states.
  std::vector<ReferenceComparison> references = {};

  const Result& best() const { return models.back(); }
  std::size_t load_cases() const { return best().load_cases.size(); }
};

/// Solves the case with bars, refined bodies and, if the case requests it or its matrices are cached, the influence
/// model. Models that the case does not state are left out if they are impossible, with the reason. A full mechanism is
/// compared with one sector of the same bodies, which has the axial force and the parts that all rollers have in
/// common. Load cases of equal shares are left out. Throws as `analyze` does.
ModelComparison compare_models(const Case& c);

/// The case with the settings of one of its models.
Case case_of(const Case& c, const Result& model);

}  // namespace prs
