#pragma once

#include "prs/preload/analyze_preload.h"
#include "prs/record/analysis.h"

namespace prs {

/// Forces and displacements are > 0 in tension; `tension` and `compression` of `sides` are the
/// contacts that carry that sense of the load.
const Analysis<PreloadResult>& preload_analysis();

}  // namespace prs
