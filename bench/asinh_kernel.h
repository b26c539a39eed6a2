#pragma once

#include <cstddef>

#include "simd/architectures.h"

/// Sum of asinh over numbers: the floor of the friction kernel.
struct AsinhKernel {
  template <class Arch>
  double operator()(Arch, const double* x, std::size_t size) const;
};
