#pragma once

#include "prs/loads/load_analysis.h"
#include "prs/study/derivatives.h"
#include "prs/study/recorded.h"
#include "prs/study/study_result.h"
#include "prs/study/study_run.h"

namespace prs {

/// `study.csv`: one row per design, the base case first, then status, reason and the responses under their paths. The
/// first columns are the values of all factors or, if designs differ from the base case in one value, this one:
/// `factor`, `label`, `value`, `number`, `unit`.
class StudyCsv {
 public:
  /// Study and columns must outlive the object.
  StudyCsv(const Study& study, const std::vector<FactorColumn>& columns, const CsvStyle& style = {})
      : study_(study), columns_(columns), style_(style) {}

  std::string header() const;

  /// `factors`: of the block, see `factor_values`. From any thread.
  std::string rows(const RowBlock& block, const std::vector<double>& factors) const;

 private:
  const Study& study_;
  const std::vector<FactorColumn>& columns_;
  CsvStyle style_;
};

/// `envelope.csv`: one row per node of the grid and then one per point, which is named in `point`; number of the design
/// if it is one, factors and companions, responses, measures divided by their normalisation (`normalised.PATH`) and the
/// `envelope`.
std::string envelope_csv(const Study& study, const GridMaps& maps, const EnvelopeResult& envelope,
                         const CsvStyle& style = {});

/// Receives a block of rows and the values of its designs, see `factor_values`.
using TakeRows = std::function<void(const RowBlock& block, std::span<const double> inputs)>;

/// Reads the rows of all designs once, in their order, and gives every block to `add`. With a folder, `study.csv` is
/// written meanwhile; it is on the disk when this returns. The memory needed does not depend on the number of designs.
/// Throws std::system_error that names a file that cannot be written; an earlier file of that name is then unchanged.
void write_rows(const StoredRows& rows, const Study& study, const std::filesystem::path* folder, std::size_t threads,
                const TakeRows& add, const CsvStyle& style = {});

Record<CaseDerivatives> record_of(Type<CaseDerivatives>);

/// The document of `prs study --json` with `plan: derivatives`: under `derivatives` one entry per response, with its
/// value and the effect of each factor.
Json derivatives_json(const CaseDerivatives& result, const DocumentInfo& info);

/// `derivatives.csv`: one row per response and factor.
std::string derivatives_csv(const CaseDerivatives& result, const CsvStyle& style = {});

/// One table per response: the effect of 1 % of each factor, the strongest first.
std::string derivatives_table(const CaseDerivatives& result);

/// Pictures of the derivatives of a case. The result must outlive the list.
Pictures derivatives_pictures(const CaseDerivatives& result);

/// Name in the input: `latin_hypercube`.
std::string_view name(Plan plan);

/// Contents of the document of a study.
struct StudyDocument {
  const StudyResult* result = nullptr;
  bool with_rows = true;
};
Record<StudyDocument> record_of(Type<StudyDocument>);
Record<Level> record_of(Type<Level>);

}  // namespace prs
