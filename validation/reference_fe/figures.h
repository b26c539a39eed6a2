#pragma once

#include <vector>

#include "prs/record/figure.h"
#include "validation/reference_fe/comparison.h"

namespace prs::reference_fe {

/// For each curve with opposite contacts one figure at its largest load: load rate over the threads
/// of both interfaces and, below, the differences from the reference. The reference is drawn as
/// points with error bars, the models as lines.
std::vector<Figure> load_rate_figures(const std::vector<Model>& models,
                                      const std::vector<Curve>& reference, const ErrorBar& error);

/// For each guidance the displacement over the load, one row per configuration, one column per
/// direction. Opposite contacts.
std::vector<Figure> displacement_figures(const std::vector<Model>& models,
                                         const std::vector<Curve>& reference,
                                         const ErrorBar& error);

}  // namespace prs::reference_fe
