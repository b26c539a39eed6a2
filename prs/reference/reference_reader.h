#pragma once

#include "prs/reference/reference.h"

namespace prs {

/// Reads the block `references` of a source and opens its files; `c` is the case of the source. A file gives one
/// reference for each load case and, without `response`, for each column that names one. Throws InputError, with file,
/// line and column of an error in a file.
std::vector<ReferenceCurve> read_references(const input::Source& source, const Case& c);

}  // namespace prs
