#pragma once

#include <vector>

#include "prs/figures/figure.h"
#include "prs/preload/analyze_preload.h"

namespace prs {

/// The curve through zero, with and without preload, beside what each side carries.
std::vector<Figure> preload_figures(const PreloadResult& result);

}  // namespace prs
