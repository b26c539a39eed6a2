#pragma once

#include <cstddef>

namespace test {

/// Calls of operator new so far in this process.
std::size_t allocations();

}  // namespace test
