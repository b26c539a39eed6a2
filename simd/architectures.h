#pragma once

#include <xsimd/xsimd.hpp>

/// Instruction sets in one binary; `simd::run_kernel` selects one at run time.
///
/// A kernel is a function object with `template <class Arch> R operator()(Arch, ...) const`, in a header that a
/// separate source file for each instruction set instantiates (see add_simd_kernel in cmake/kernels.cmake).
namespace simd {

#if defined(__x86_64__)
using Avx512 = xsimd::avx512bw;
using Avx2 = xsimd::fma3<xsimd::avx2>;
using Baseline = xsimd::sse2;
using Architectures = xsimd::arch_list<Avx512, Avx2, Baseline>;
#else
using Baseline = xsimd::default_arch;
using Architectures = xsimd::arch_list<Baseline>;
#endif

/// Size of the widest batch: arrays for kernels are padded to a multiple of it.
inline constexpr int kWidest = 8;

/// Sum of the numbers of a batch: `hadd` of xsimd 8, `reduce_add` since.
template <class Batch>
double sum_of(const Batch& x) {
  if constexpr (requires { reduce_add(x); })
    return reduce_add(x);
  else
    return hadd(x);
}

}  // namespace simd
