#pragma once

#include <cstddef>
#include <cstdint>

#include "simd/architectures.h"

namespace contact {

/// Points of a contact patch in units of its semi-axes. Filled up to a multiple of simd::kWidest by
/// points outside the ellipse, which have no dome and no inverse of it.
struct PatchPoints {
  const double* along_major = nullptr;
  const double* along_minor = nullptr;
  const double* dome = nullptr;          ///< sqrt(1 - x^2 - y^2)
  const double* inverse_dome = nullptr;  ///< 1/dome at the points inside the patch.
  std::size_t size = 0;
};

/// Sliding velocity at (x, y): (major - spin_minor y, minor + spin_major x) [m/s].
struct SlidingField {
  double major = 0.0, minor = 0.0;            ///< At the centre.
  double spin_major = 0.0, spin_minor = 0.0;  ///< Spin times semi-axis.
};

/// mu_D dome at a point: coefficient dome + scale asinh(factor viscosity_ratio |v|).
struct PatchLaw {
  double coefficient = 0.0;                 ///< Of flanks that touch.
  const double* viscosity_ratio = nullptr;  ///< Eyring fluid, at the points; null: none.
  double scale = 0.0;                       ///< tau_0/p_0
  double factor = 0.0;                      ///< K [s/m]
};

/// Sums over the points.
struct PatchSums {
  double traction_major = 0.0;  ///< mu dome v_1/|v|
  double traction_minor = 0.0;  ///< mu dome v_2/|v|
  double moment_major = 0.0;    ///< x mu dome v_2/|v|
  double moment_minor = 0.0;    ///< y mu dome v_1/|v|
  double power = 0.0;           ///< mu dome |v|
  double friction = 0.0;        ///< mu
  double max_speed = 0.0;       ///< Largest |v| inside.
};

/// Sliding slower than this has no direction, as at the centre of pure spin [m/s].
inline constexpr double kNoDirection = 1e-11;

/// Sums the friction over a patch, a batch of points at a time.
struct PatchKernel {
  template <class Arch>
  PatchSums operator()(Arch, const PatchPoints& points, const SlidingField& sliding,
                       const PatchLaw& law) const;
};

/// Roelands' viscosity ratio at `size` pressures (see lubricant.h).
struct ViscosityKernel {
  template <class Arch>
  void operator()(Arch, double viscosity, const double* pressure, std::size_t size,
                  double* ratio) const;
};

}  // namespace contact
