#pragma once

#include <string>
#include <string_view>

#include "prs/life/analyze_life.h"

namespace prs {

inline constexpr std::string_view kStatedCapacityNote =
    "A stated C_a comes from real screws, whose threads share unevenly: the life with real thread "
    "loads counts that twice and is a lower bound.";

/// How long the mechanism lasts, what decides it and the static safety, within 100 columns.
std::string life_table(const LifeResult& result);
/// With the estimates by equal thread loads.
std::string full_life_table(const LifeResult& result);

}  // namespace prs
