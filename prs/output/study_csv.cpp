#include "prs/output/csv_writer.h"
#include "prs/output/study_files.h"

namespace prs {
namespace {

/// Of a design that differs from the base case in one value.
void setting_fields(CsvWriter& csv, const Study& study, const Design& design) {
  const Setting* setting = design.settings.empty() ? nullptr : &design.settings.front();
  const Factor* factor = setting ? &study.factors[setting->factor] : nullptr;
  csv.text(factor ? factor->path : "");
  csv.text(factor ? factor->label : "");
  csv.text(setting ? setting->level.text : "");
  csv.number(setting ? setting->level.number : std::nullopt);
  csv.text(setting && setting->level.number ? factor->unit : "");
}

}  // namespace

std::string study_csv(const StudyResult& result) {
  CsvWriter csv;
  for (const char* key :
       {"design", "factor", "label", "value", "number", "unit", "base", "status", "reason"})
    csv.text(key);
  for (const std::string& path : result.study.responses) csv.text(path);
  csv.end_row();
  for (std::size_t k = 0; k < result.rows.size(); ++k) {
    const StudyRow& row = result.rows[k];
    csv.integer(k);
    setting_fields(csv, result.study, row.design);
    csv.text(is_base(result.study, row.design) ? "true" : "false");
    csv.text(row.status.name);
    csv.text(row.status.reason);
    for (const std::optional<double>& value : row.responses) csv.number(value);
    csv.end_row();
  }
  return csv.take();
}

}  // namespace prs
