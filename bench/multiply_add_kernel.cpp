#include "bench/multiply_add_kernel.h"

template <class Arch>
double MultiplyAddKernel::operator()(Arch, int rounds) const {
  using Batch = xsimd::batch<double, Arch>;
  const Batch factor(0.999), term(1e-3);
  Batch a0(0.0), a1(0.1), a2(0.2), a3(0.3), a4(0.4), a5(0.5), a6(0.6), a7(0.7), a8(0.8), a9(0.9),
      a10(1.0), a11(1.1);
  for (int k = 0; k < rounds; ++k) {
    a0 = a0 * factor + term;
    a1 = a1 * factor + term;
    a2 = a2 * factor + term;
    a3 = a3 * factor + term;
    a4 = a4 * factor + term;
    a5 = a5 * factor + term;
    a6 = a6 * factor + term;
    a7 = a7 * factor + term;
    a8 = a8 * factor + term;
    a9 = a9 * factor + term;
    a10 = a10 * factor + term;
    a11 = a11 * factor + term;
  }
  return hadd(((a0 + a1) + (a2 + a3)) + ((a4 + a5) + (a6 + a7)) + ((a8 + a9) + (a10 + a11)));
}

template double MultiplyAddKernel::operator()(PRS_SIMD_ARCHITECTURE, int) const;
