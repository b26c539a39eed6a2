#pragma once

#include <span>

#include "contact/patch_kernel.h"
#include "prs/slip/slip_formulas.h"
#include "prs/slip/slip_search.h"

namespace prs {

/// Contact of all threads of an interface that carry the same load, as numbers; see
/// `LoadedThreads::Contact`.
template <class Real>
struct SharedContactNumbers {
  Real axial_load{}, alike{};
  Real semi_major{}, semi_minor{}, peak_pressure{};
  contact::FrictionLawOf<Real> friction{};
};

/// A screw whose threads carry equal loads, as numbers.
template <class Real>
struct SlipNumbers {
  RollerModelOf<Real> roller{};
  PerInterface<SharedContactNumbers<Real>> contacts{};
  Real residue_unit{};
};

/// Forces at one slip ratio, with one patch at each interface; see `SlipBalance`.
template <class Number>
struct SharedSlipBalance {
  RollerBalanceOf<Number> roller{};
  PerInterface<contact::PatchFrictionOf<Number>> friction{};
  PerInterface<Number> normal_load{};
};

/// Patch points common to all screws of a batch.
struct SharedPoints {
  contact::PatchPoints points;  ///< `size`: number of points inside.
  std::span<const std::uint32_t> dome_of_point;
  std::size_t domes = 0;
  double cell_load = 0.0;
};

/// A search for equilibrium and its last result.
struct SlipTask {
  SlipSearch search;
  SharedSlipBalance<double> balance;
};

/// One screw per lane: searches until all are done. A screw does not depend on its neighbours.
struct SlipKernel {
  /// `viscosity_ratio`: `domes` numbers per screw and interface. `memory`: 2 x `domes` x simd::kWidest numbers.
  template <class Arch>
  void operator()(Arch, const SharedPoints& points, std::span<const SlipNumbers<double>> screws,
                  const double* viscosity_ratio, std::span<SlipTask> tasks, double* memory) const;
};

}  // namespace prs
