#pragma once

#include <utility>

#include "simd/architectures.h"
#include "simd/instruction_set.h"

namespace simd {

/// Runs a kernel (see simd/architectures.h) with the requested instruction set or the best available below it, and
/// returns its result.
template <class Kernel, class... Arguments>
auto run_kernel(InstructionSet set, Kernel kernel, Arguments&&... arguments) {
  switch (taken(set)) {
#if defined(__x86_64__)
    case InstructionSet::avx512:
      return kernel(Avx512{}, std::forward<Arguments>(arguments)...);
    case InstructionSet::avx2:
      return kernel(Avx2{}, std::forward<Arguments>(arguments)...);
#endif
    default:
      return kernel(Baseline{}, std::forward<Arguments>(arguments)...);
  }
}

}  // namespace simd
