#pragma once

#include <cstdlib>

namespace test {

/// How many random samples a test takes: a fixed-seed subset in the quick run, all of them where
/// the environment asks for the thorough one (`ctest -L thorough` sets PRS_THOROUGH).
inline int count(int quick, int thorough) {
  return std::getenv("PRS_THOROUGH") != nullptr ? thorough : quick;
}

}  // namespace test
