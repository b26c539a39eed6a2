#include "bench/function_kernel.h"

#include "simd/asinh.h"

template <class Arch>
double FunctionKernel::operator()(Arch, Function function, const double* x, std::size_t size) const {
  using Batch = xsimd::batch<double, Arch>;
  const auto sum_of = [&](auto f) {
    Batch sum(0.0);
    for (std::size_t i = 0; i < size; i += Batch::size) sum += f(Batch::load_unaligned(x + i));
    return simd::sum_of(sum);
  };
  switch (function) {
    case Function::division:
      return sum_of([](const Batch& v) { return 1.0 / v; });
    case Function::sqrt:
      return sum_of([](const Batch& v) { return sqrt(v); });
    case Function::cbrt:
      return sum_of([](const Batch& v) { return cbrt(v); });
    case Function::sincos:
      return sum_of([](const Batch& v) {
        const auto [sine, cosine] = sincos(v);
        return sine + cosine;
      });
    case Function::atan2:
      return sum_of([](const Batch& v) { return atan2(v, Batch(0.7)); });
    case Function::log:
      return sum_of([](const Batch& v) { return log(v); });
    case Function::asinh:
      return sum_of([](const Batch& v) { return simd::asinh_of_positive(v); });
  }
  return 0.0;
}

template double FunctionKernel::operator()(PRS_SIMD_ARCHITECTURE, Function, const double*, std::size_t) const;
