#pragma once

#include "prs/compare/compare_models.h"

namespace prs {

/// Adds the references of a case with the results of each model, and warnings on sums that the load does not explain.
/// Throws InputError.
void compare_references(const input::Source& source, const Case& c, std::vector<ReferenceCurve> references,
                        ModelComparison& comparison);

}  // namespace prs
