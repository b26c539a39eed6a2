#pragma once

#include <string>

#include "prs/preload/analyze_preload.h"
#include "prs/record/csv_style.h"

namespace prs {

/// The preload and the curve through zero, within 100 columns. Of many loads, an evenly spaced few
/// are shown.
std::string preload_table(const PreloadResult& result);

/// `preload.csv`: one row per load, with the curve without preload in further columns.
std::string preload_csv(const PreloadResult& result, const CsvStyle& style = {});

}  // namespace prs
