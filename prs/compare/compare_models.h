#pragma once

#include "prs/loads/result.h"

namespace prs {

/// The load cases of a case, solved with each model of the bodies.
struct ModelComparison {
  std::vector<Result> models;     ///< The best model last; load cases alike in all.
  std::vector<Warning> warnings;  ///< Warnings of the geometry, and why a model is left out.

  const Result& best() const { return models.back(); }
  std::size_t load_cases() const { return best().load_cases.size(); }
};

/// Solves the case with bars, refined bodies and, where the case asks for it or its matrices are
/// kept, the influence model. Models that the case does not state are left out where they cannot
/// be, with the reason. A full mechanism is compared with one sector of the same bodies, which
/// knows the axial force and the parts that all rollers have in common. Load cases of equal shares
/// are left out. Throws as `analyze` does.
ModelComparison compare_models(const Case& c);

}  // namespace prs
