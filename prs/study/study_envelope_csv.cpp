#include "prs/study/study_envelope_csv.h"

#include <vector>

#include "prs/record/csv_writer.h"
#include "prs/study/study_columns.h"

namespace prs {
namespace {

void input_fields(CsvWriter& csv, const std::vector<FactorColumn>& columns,
                  const std::vector<Level>& inputs) {
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].is_numeric())
      csv.number(inputs[k].number);
    else
      csv.text(inputs[k].text);
}

}  // namespace

std::string envelope_csv(const Study& study, const GridMaps& maps, const EnvelopeResult& envelope,
                         const CsvStyle& style) {
  const std::vector<FactorColumn> columns = factor_columns(study);
  CsvWriter csv(style);
  csv.fields("point", "design");
  for (const FactorColumn& column : columns) csv.text(column.name);
  csv.fields(study.responses);
  for (const MeasureMap& measure : envelope.measures)
    csv.text("normalised." + study.responses[measure.response]);
  csv.row("envelope");

  const std::size_t row = maps.axes[1].nodes();
  for (std::size_t k = 0; k < maps.nodes(); ++k) {
    csv.fields("", maps.design(k));
    input_fields(
        csv, columns,
        inputs_at(study, maps, {static_cast<double>(k / row), static_cast<double>(k % row)}));
    for (const GridMap& map : maps.responses) csv.number(map[k]);
    for (const MeasureMap& measure : envelope.measures)
      csv.number(maps.responses[measure.response][k] / measure.normalised_by);
    csv.row(envelope.values[k]);
  }
  for (const EnvelopePoint& point : envelope.points) {
    if (!point.reason.empty()) continue;
    csv.fields(point.name, point.design);
    input_fields(csv, columns, point.inputs);
    csv.row(point.responses, point.normalised, point.envelope);
  }
  return csv.take();
}

}  // namespace prs
