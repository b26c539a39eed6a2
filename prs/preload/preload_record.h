#pragma once

#include "prs/preload/preloaded_mechanism.h"
#include "prs/record/record.h"

namespace prs {

/// One equilibrium of a preloaded nut, and the result that it belongs to.
struct PreloadPointOf {
  const PreloadResult* result = nullptr;
  const PreloadPoint* point = nullptr;
};

Record<PreloadPointOf> record_of(Type<PreloadPointOf>);
Record<PreloadResult> record_of(Type<PreloadResult>);

}  // namespace prs
