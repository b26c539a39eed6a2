#pragma once

#include "contact/patch_formulas.h"
#include "simd/architectures.h"

namespace contact {

/// Points of a contact patch in units of its semi-axes, filled up to a multiple of simd::kWidest. The
/// points that fill it lie inside; their dome and its inverse are 0, so that they add nothing.
struct PatchPoints {
  const double* along_major = nullptr;
  const double* along_minor = nullptr;
  const double* dome = nullptr;          ///< sqrt(1 - x^2 - y^2)
  const double* inverse_dome = nullptr;  ///< 1/dome
  std::size_t size = 0;
};

using SlidingField = SlidingFieldOf<double>;
using PatchSums = PatchSumsOf<double>;

/// Sums the friction over a patch, a batch of points at a time; with slopes for Newton's method.
struct PatchKernel {
  /// `viscosity_ratio`: at the points; not used by a dry law.
  template <class Arch, class Number>
  PatchSumsOf<Number> operator()(Arch, const PatchPoints& points, const SlidingFieldOf<Number>& sliding,
                                 const FrictionLaw& law, const RollingContactOf<Number>& contact,
                                 const double* viscosity_ratio) const;
};

/// Roelands' viscosity ratio at `size` pressures (see film.h).
struct ViscosityKernel {
  template <class Arch>
  void operator()(Arch, double viscosity, const double* pressure, std::size_t size, double* ratio) const;
};

}  // namespace contact
