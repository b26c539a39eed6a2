#pragma once

#include <string>

#include "prs/life/analyze_life.h"

namespace prs {

/// How long the mechanism lasts, what decides it and the static safety, within 100 columns.
std::string life_table(const LifeResult& result);
/// With the estimates by equal thread loads.
std::string full_life_table(const LifeResult& result);

}  // namespace prs
