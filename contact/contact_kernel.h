#pragma once

#include "contact/contact_numbers.h"
#include "simd/architectures.h"

namespace contact {

struct ContactKernel {
  /// One mechanism per lane.
  template <class Arch>
  void operator()(Arch, std::span<const MechanismNumbers<double>> mechanisms,
                  std::span<MechanismContactNumbers<double>> contacts) const;
};

struct EllipseKernel {
  /// One load per lane; see `set_ellipses`.
  template <class Arch>
  void operator()(Arch, double semi_major_per_cbrt_load, double semi_minor_per_cbrt_load,
                  std::span<const double> normal_load, const KnownApproach& approach, double* semi_major,
                  double* semi_minor, double* peak_pressure) const;
};

}  // namespace contact
