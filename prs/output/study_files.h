#pragma once

#include <filesystem>
#include <functional>

#include "prs/quantities/json.h"
#include "prs/study/row_block.h"
#include "prs/study/stored_rows.h"
#include "prs/model/study.h"

namespace prs {

/// Reads the rows of all designs once, in their order, and gives every block to `add`. With a
/// folder, `study.csv` and `study.nc` are written on the way, `envelope.csv` of a study with an
/// envelope after them; they are on the disk when this returns. The memory needed does not depend
/// on the number of designs, maps aside. Throws std::system_error
/// that names a file that cannot be written; earlier files of that name are then as they were.
void write_rows(const StoredRows& rows, const Study& study, const DocumentInfo& info,
                const std::filesystem::path* folder, std::size_t threads,
                const std::function<void(const RowBlock&)>& add);

}  // namespace prs
