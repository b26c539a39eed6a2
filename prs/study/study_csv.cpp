#include "prs/study/study_csv.h"

#include "prs/record/csv_writer.h"
#include "prs/study/designs.h"

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
  auto failure = block.failures.begin();
  for (std::size_t row = 0; row < block.rows; ++row) {
    csv.integer(block.first + row);
    if (study_.plan == Plan::one_at_a_time)
      setting_fields(csv, study_, design(study_, block.first + row));
    else
      for (std::size_t f = 0; f < columns_.size(); ++f)
        factor_field(csv, columns_[f], factors[row * columns_.size() + f]);
    const bool failed = failure != block.failures.end() && failure->row == row;
    if (failed) {
      csv.fields(failure->status.name, failure->status.reason);
      ++failure;
    } else {
      csv.word("converged");
      csv.word("");
    }
    for (std::size_t k = 0; k < width; ++k) csv.number(block.responses[row * width + k]);
    csv.end_row();
  }
  return csv.take();
}

}  // namespace prs
