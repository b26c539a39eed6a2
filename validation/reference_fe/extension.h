#pragma once

#include "prs/validation/validate.h"
#include "validation/reference_fe/comparison.h"

namespace prs::reference_fe {

/// Error bar of the reference's curves, opposite contacts included (SOURCE.md, "Curves").
inline constexpr ErrorBar kReferenceError{0.002, 0.001};
/// Working accuracy of the influence model.
inline constexpr ErrorBar kInfluenceError{0.005, 0.001};
/// Claimed accuracy of the refined model.
inline constexpr ErrorBar kRefinedError{0.05, 0.010};

/// The reference and the three models on the same curves.
struct Fidelities {
  Curves reference;
  Curves bars;
  Curves refined;
  Curves influence;  ///< Empty if the program omits that model.
};

/// Statements on the gap of the bar model, and whether the other two are within their error bars.
std::vector<ComparedStatement> compare_statements(const Fidelities& fidelities);

/// Discrepancies of the models at the largest load, case by case, and over all cases and loads.
std::vector<ValidationTable> tables(const Models& models, const Curves& reference);

/// `comparison.csv`: every model at every point. `load_rates.csv`: every thread of every point.
/// `load_rates.md`: every thread at the largest load, one table per case.
std::vector<OutputFile> files(const Models& models, const Curves& reference);

/// Figures for each curve with opposite contacts at its largest load: load rate over the threads of both interfaces
/// and, below, the differences from the reference. The reference is drawn as points with error bars, the models as
/// lines.
std::vector<Figure> load_rate_figures(const Models& models, const Curves& reference, const ErrorBar& error);

/// Figures for each guidance of the displacement over the load, one row per configuration, one column per direction.
/// Opposite contacts.
std::vector<Figure> displacement_figures(const Models& models, const Curves& reference, const ErrorBar& error);

}  // namespace prs::reference_fe
