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
  csv.text("point");
  csv.text("design");
  for (const FactorColumn& column : columns) csv.text(column.name);
  for (const std::string& path : study.responses) csv.text(path);
  for (const MeasureMap& measure : envelope.measures)
    csv.text("normalised." + study.responses[measure.response]);
  csv.text("envelope");
  csv.end_row();

  const std::size_t row = maps.axes[1].nodes();
  for (std::size_t k = 0; k < maps.nodes(); ++k) {
    csv.text("");
    csv.integer(maps.design(k));
    input_fields(
        csv, columns,
        inputs_at(study, maps, {static_cast<double>(k / row), static_cast<double>(k % row)}));
    for (const GridMap& map : maps.responses) csv.number(map[k]);
    for (const MeasureMap& measure : envelope.measures)
      csv.number(maps.responses[measure.response][k] / measure.normalised_by);
    csv.number(envelope.values[k]);
    csv.end_row();
  }
  for (const EnvelopePoint& point : envelope.points) {
    if (!point.reason.empty()) continue;
    csv.text(point.name);
    csv.integer(point.design);
    input_fields(csv, columns, point.inputs);
    for (const double value : point.responses) csv.number(value);
    for (const double value : point.normalised) csv.number(value);
    csv.number(point.envelope);
    csv.end_row();
  }
  return csv.take();
}

}  // namespace prs
