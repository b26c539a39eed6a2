#include "prs/study/study_csv.h"

namespace prs {
namespace {

constexpr std::size_t kUsualField = 13;  ///< Characters of a number and its separator.

/// Fields of a design that differs from the base case in one value.
void setting_fields(CsvWriter& csv, const Study& study, const Design& design) {
  const Setting* setting = design.settings.empty() ? nullptr : &design.settings.front();
  const Factor* factor = setting ? &study.factors[setting->factor] : nullptr;
  const Level level = setting ? setting->level : Level{};
  if (factor)
    csv.fields(factor->path, factor->label);
  else
    csv.fields("", "");
  csv.fields(level.text, level.number, level.number ? factor->unit : "", is_base(study, design));
}

void factor_field(CsvWriter& csv, const FactorColumn& column, double value) {
  if (column.is_numeric())
    csv.number(value);
  else
    csv.text(value >= 0.0 ? column.words[static_cast<std::size_t>(value)] : "");
}

void input_fields(CsvWriter& csv, const std::vector<FactorColumn>& columns,
                  const std::vector<Level>& inputs) {
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].is_numeric())
      csv.number(inputs[k].number);
    else
      csv.text(inputs[k].text);
}

}  // namespace

std::string StudyCsv::header() const {
  CsvWriter csv(style_);
  csv.text("design");
  if (study_.plan == Plan::one_at_a_time)
    csv.fields("factor", "label", "value", "number", "unit", "base");
  else
    for (const FactorColumn& column : columns_) csv.text(column.name);
  csv.row("status", "reason", study_.responses);
  return csv.take();
}

std::string StudyCsv::rows(const RowBlock& block, const std::vector<double>& factors) const {
  CsvWriter csv(style_, CsvWriter::Part::rows);
  const std::size_t width = study_.responses.size();
  csv.reserve(block.rows * (kUsualField * (columns_.size() + width) + kUsualField));
  for (std::size_t row = 0; row < block.rows; ++row) {
    csv.integer(block.first + row);
    if (study_.plan == Plan::one_at_a_time)
      setting_fields(csv, study_, design(study_, block.first + row));
    else
      for (std::size_t f = 0; f < columns_.size(); ++f)
        factor_field(csv, columns_[f], factors[row * columns_.size() + f]);
    const DesignStatus status = block.status(row);
    csv.fields(status.name, status.reason);
    for (std::size_t k = 0; k < width; ++k) csv.number(block.responses[row * width + k]);
    csv.end_row();
  }
  return csv.take();
}

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
