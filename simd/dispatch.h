#pragma once

#include <utility>

#include "simd/architectures.h"
#include "simd/instruction_set.h"

namespace simd {

/// Runs a kernel (see simd/architectures.h) with the instruction set asked for, or the best that
/// the processor has below it.
template <class Kernel, class... Arguments>
void run_kernel(InstructionSet set, Kernel kernel, Arguments&&... arguments) {
  const auto run = [&](auto architectures) {
    xsimd::dispatch<decltype(architectures)>(Kernel(kernel))(std::forward<Arguments>(arguments)...);
  };
#if defined(__x86_64__) && !defined(PRS_WITHOUT_AVX2)
  if (set == InstructionSet::avx2) return run(xsimd::arch_list<Avx2, Baseline>{});
#endif
  if (set == InstructionSet::baseline) return run(xsimd::arch_list<Baseline>{});
  run(Architectures{});
}

}  // namespace simd
