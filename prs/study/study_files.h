#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "prs/loads/load_json.h"
#include "prs/model/study.h"
#include "prs/record/csv_style.h"
#include "prs/study/row_block.h"
#include "prs/study/stored_rows.h"

namespace prs {

/// Takes a block of rows and what its designs set, see `factor_values`.
using TakeRows = std::function<void(const RowBlock& block, std::span<const double> inputs)>;

/// Reads the rows of all designs once, in their order, and gives every block to `add`. With a
/// folder, `study.csv` and `study.nc` are written on the way, `envelope.csv` of a study with an
/// envelope after them; they are on the disk when this returns. Returns what was not written, and
/// why: `study.nc` by a build without netCDF. The memory needed does not depend
/// on the number of designs, maps aside. Throws std::system_error
/// that names a file that cannot be written; earlier files of that name are then as they were.
std::string write_rows(const StoredRows& rows, const Study& study, const DocumentInfo& info,
                       const std::filesystem::path* folder, std::size_t threads,
                       const TakeRows& add, const CsvStyle& style = {});

}  // namespace prs
