#pragma once

#include <nlohmann/json_fwd.hpp>

#include "prs/preload/analyze_preload.h"
#include "prs/quantities/json.h"

namespace prs {

/// The document of `prs preload --json`, its results under `preload`. Forces and displacements are
/// > 0 in tension; `tension` and `compression` of `sides` are the contacts that carry that sense of
/// the load.
nlohmann::ordered_json preload_json(const PreloadResult& result, const DocumentInfo& info);

}  // namespace prs
