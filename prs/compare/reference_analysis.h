#pragma once

#include "prs/compare/compare_models.h"
#include "prs/record/analysis.h"

namespace prs {

/// A reference and the models that are compared with it.
struct ComparedReference {
  const ModelComparison* comparison = nullptr;
  std::size_t index = 0;

  const ReferenceComparison& found() const { return comparison->references[index]; }
  const ReferenceCurve& reference() const { return found().reference; }
};

Record<ComparedReference> record_of(Type<ComparedReference>);

/// Adds `references` to the document, if there are any.
void put_references(Json& document, const ModelComparison& c);

/// One line per reference and model; empty without references.
std::string reference_table(const ModelComparison& c);

/// `references.csv`: one row per reading, with the result of each model.
std::string references_csv(const ModelComparison& c, const CsvStyle& style);

/// Statistics as a table of the page.
PageTable reference_page_table(const ModelComparison& c);

}  // namespace prs
