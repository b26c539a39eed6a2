#include "bench/asinh_kernel.h"

template <class Arch>
double AsinhKernel::operator()(Arch, const double* x, std::size_t size) const {
  using Batch = xsimd::batch<double, Arch>;
  Batch sum(0.0);
  for (std::size_t i = 0; i < size; i += Batch::size) sum += asinh(Batch::load_unaligned(x + i));
  return hadd(sum);
}

template double AsinhKernel::operator()(PRS_SIMD_ARCHITECTURE, const double*, std::size_t) const;
