#pragma once

#include "prs/preload/preloaded_mechanism.h"
#include "prs/record/analysis.h"

namespace prs {

/// `preload.csv`: one row per load, with the curve without preload in further columns.
std::string preload_csv(const PreloadResult& result, const CsvStyle& style = {});

/// Analysis of preload. Forces and displacements are > 0 in tension; `tension` and `compression` of `sides` are the
/// contacts that carry that sense of the load.
const Analysis<PreloadResult>& preload_analysis();

}  // namespace prs
