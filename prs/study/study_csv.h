#pragma once

#include "prs/record/csv_writer.h"
#include "prs/study/envelope_result.h"

namespace prs {

/// `study.csv`: one row per design, the base case first, then status, reason and the responses
/// under their paths. Before them stand the values of all factors or, where designs differ from the
/// base case in one value, this one: `factor`, `label`, `value`, `number`, `unit`.
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

/// `envelope.csv`: one row per node of the grid and then one per point that was read off, which is
/// named in `point`; number of the design where it is one, factors and companions, responses,
/// measures divided by what normalises them (`normalised.PATH`) and the `envelope`.
std::string envelope_csv(const Study& study, const GridMaps& maps, const EnvelopeResult& envelope,
                         const CsvStyle& style = {});

}  // namespace prs
