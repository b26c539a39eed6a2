#pragma once

#include <utility>

#include "prs/sector/chain/instruction_set.h"
#include "simd/architectures.h"

namespace prs {

/// Runs a kernel (see simd/architectures.h) with the instruction set asked for, or the best that
/// the processor has below it; its first argument says whether it takes single numbers.
template <class Kernel, class... Arguments>
void run_kernel(InstructionSet set, Kernel kernel, Arguments&&... arguments) {
  const bool scalar = set == InstructionSet::scalar;
  const auto run = [&](auto architectures) {
    xsimd::dispatch<decltype(architectures)>(Kernel(kernel))(scalar,
                                                             std::forward<Arguments>(arguments)...);
  };
#if defined(__x86_64__)
  if (set == InstructionSet::avx2) return run(xsimd::arch_list<simd::Avx2, simd::Baseline>{});
#endif
  if (set == InstructionSet::baseline) return run(xsimd::arch_list<simd::Baseline>{});
  run(simd::Architectures{});
}

}  // namespace prs
