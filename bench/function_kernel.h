#pragma once

#include <cstddef>

#include "simd/architectures.h"

/// Functions used in contacts, loads and friction.
enum class Function { division, sqrt, cbrt, sincos, atan2, log, asinh };

/// Sum of a function over numbers > 0: the minimum time of a kernel that needs it.
struct FunctionKernel {
  template <class Arch>
  double operator()(Arch, Function function, const double* x, std::size_t size) const;
};
