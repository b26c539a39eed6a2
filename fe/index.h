#pragma once

#include <cstddef>

namespace fe {

/// Element i of a standard container, for the signed numbers that freedoms and matrices count by.
template <class Container>
auto& at(Container& c, int i) {
  return c[static_cast<std::size_t>(i)];
}

}  // namespace fe
