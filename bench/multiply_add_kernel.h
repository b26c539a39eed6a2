#pragma once

#include "simd/architectures.h"

/// Rounds of independent multiply-adds on batches: the processor's peak at a lane width.
struct MultiplyAddKernel {
  /// Multiply-adds of one batch in a round.
  static constexpr int kIndependent = 12;

  template <class Arch>
  double operator()(Arch, int rounds) const;
};
