#pragma once

#include <algorithm>
#include <cstdlib>

#include "tests/support/sanitized.h"

namespace test {

/// Number of random samples of a test: a fixed-seed subset in the quick run, all of them if the environment requests
/// the thorough one (`ctest -L thorough` sets PRS_THOROUGH).
inline bool thorough() { return std::getenv("PRS_THOROUGH") != nullptr; }
inline int count(int quick, int all) { return thorough() ? all : quick; }

/// Number of samples that go through the same functions: sanitizers get a fifth.
inline int samples(int quick, int all) { return count(sanitized() ? std::max(1, quick / 5) : quick, all); }

}  // namespace test
