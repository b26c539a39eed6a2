#include "bench/multiply_add_kernel.h"

#include "fe/lanes.h"
#include "simd/inlined.h"

template <class Arch>
double MultiplyAddKernel::operator()(Arch, int rounds) const {
  using Batch = xsimd::batch<double, Arch>;
  const Batch factor(0.999), term(1e-3);
  Batch a[kIndependent];
  fe::unroll<kIndependent>([&](auto i) { a[i] = Batch(0.1 * i); });
  for (int k = 0; k < rounds; ++k) fe::unroll<kIndependent>([&](auto i) PRS_INLINED { a[i] = a[i] * factor + term; });
  Batch sum = a[0];
  for (int i = 1; i < kIndependent; ++i) sum += a[i];
  return simd::sum_of(sum);
}

template double MultiplyAddKernel::operator()(PRS_SIMD_ARCHITECTURE, int) const;
