#pragma once

#include <vector>

#include "prs/output/files.h"
#include "prs/validation/table.h"
#include "validation/reference_fe/comparison.h"

namespace prs::reference_fe {

/// Discrepancies of the models at the largest load, case by case, and over all cases and loads.
std::vector<ValidationTable> tables(const std::vector<Model>& models,
                                    const std::vector<Curve>& reference);

/// `comparison.csv`: every model at every point. `load_rates.csv`: every thread of every point.
/// `load_rates.md`: every thread at the largest load, one table per case.
std::vector<OutputFile> files(const std::vector<Model>& models,
                              const std::vector<Curve>& reference);

}  // namespace prs::reference_fe
