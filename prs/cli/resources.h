#pragma once

#include "prs/cli/program.h"

namespace prs::cli {

/// Keeps the matrices of `influence` between runs, and shows how many are being computed.
void open_matrix_cache(bool quiet);

/// Reason why they could not be kept; empty if they were.
std::string matrix_cache_refusal();

/// Reports early that the module for PNG files is missing. Throws modules::Missing.
void require_png();

}  // namespace prs::cli
