#pragma once

#include <nlohmann/json_fwd.hpp>

#include "prs/life/analyze_life.h"
#include "prs/quantities/json.h"

namespace prs {

/// The document of `prs life --json`, its results under `life`; lives that are not finite, without
/// load, are absent.
nlohmann::ordered_json life_json(const LifeResult& result, const DocumentInfo& info);

}  // namespace prs
