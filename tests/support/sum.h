#pragma once

#include <numeric>
#include <vector>

namespace test {

inline double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

}  // namespace test
