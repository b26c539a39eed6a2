#include "contact/patch_kernel.h"

#include "simd/asinh.h"

namespace contact {
namespace {

/// The same number in each lane.
template <class Batch>
Batch spread(double x) {
  return Batch(x);
}
template <class Batch>
simd::Dual<Batch> spread(const simd::Dual<double>& x) {
  return {Batch(x.value), Batch(x.slope)};
}

/// Sum of the numbers of a batch: `hadd` of xsimd 8, `reduce_add` since.
template <class Batch>
double sum_of(const Batch& x) {
  if constexpr (requires { reduce_add(x); })
    return reduce_add(x);
  else
    return hadd(x);
}
template <class Batch>
simd::Dual<double> sum_of(const simd::Dual<Batch>& x) {
  return {sum_of(x.value), sum_of(x.slope)};
}

template <class Batch, class Number, class Friction>
PatchSumsOf<Number> sums(const PatchPoints& points, const SlidingFieldOf<Number>& sliding, Friction friction_at) {
  using Wide = decltype(spread<Batch>(Number()));
  const SlidingFieldOf<Wide> field{spread<Batch>(sliding.major), spread<Batch>(sliding.minor),
                                   spread<Batch>(sliding.spin_major), spread<Batch>(sliding.spin_minor)};
  PatchSumsOf<Wide> wide;
  for (std::size_t i = 0; i < points.size; i += Batch::size) {
    const auto load = [i](const double* values) { return Batch::load_unaligned(values + i); };
    const PatchPoint<Batch> at{load(points.along_major), load(points.along_minor), load(points.dome),
                               load(points.inverse_dome)};
    add_point(
        wide, field,
        at, [&](const Wide& speed) __attribute__((always_inline)) { return friction_at(i, at.dome, speed); });
  }
  double max_speed = 0.0;
  for (std::size_t k = 0; k < Batch::size; ++k)
    max_speed = wide.max_speed.get(k) > max_speed ? wide.max_speed.get(k) : max_speed;
  return {
      sum_of(wide.traction_major), sum_of(wide.traction_minor), sum_of(wide.moment_major), sum_of(wide.moment_minor),
      sum_of(wide.power),          sum_of(wide.friction),       sum_of(wide.sliding),      max_speed};
}

}  // namespace

template <class Arch, class Number>
PatchSumsOf<Number> PatchKernel::operator()(Arch, const PatchPoints& points, const SlidingFieldOf<Number>& sliding,
                                            const PatchLawOf<Number>& law, const double* viscosity_ratio) const {
  using Batch = xsimd::batch<double, Arch>;
  using Wide = decltype(spread<Batch>(Number()));
  const Wide coefficient = spread<Batch>(law.coefficient), scale = spread<Batch>(law.scale),
             factor = spread<Batch>(law.factor);
  const auto coulomb = [&](std::size_t, const Batch& dome, const Wide&) __attribute__((always_inline)) {
    return coefficient * dome;
  };
  if (!viscosity_ratio) return sums<Batch>(points, sliding, coulomb);
  const auto film = [&](std::size_t i, const Batch&, const Wide& speed) __attribute__((always_inline)) {
    const Batch ratio = Batch::load_unaligned(viscosity_ratio + i);
    return scale * simd::asinh_of_positive(Wide(factor * ratio * speed));
  };
  if (simd::value(law.coefficient) == 0.0) return sums<Batch>(points, sliding, film);
  return sums<Batch>(
      points, sliding, [&](std::size_t i, const Batch& dome, const Wide& speed) __attribute__((always_inline)) {
        return coefficient * dome + film(i, dome, speed);
      });
}

template <class Arch>
void ViscosityKernel::operator()(Arch, double viscosity, const double* pressure, std::size_t size,
                                 double* ratio) const {
  using Batch = xsimd::batch<double, Arch>;
  for (std::size_t i = 0; i < size; i += Batch::size)
    roelands_viscosity_ratio(viscosity, Batch::load_unaligned(pressure + i)).store_unaligned(ratio + i);
}

template PatchSums PatchKernel::operator()(PRS_SIMD_ARCHITECTURE, const PatchPoints&, const SlidingField&,
                                           const PatchLawOf<double>&, const double*) const;
template PatchSumsOf<simd::Dual<double>> PatchKernel::operator()(PRS_SIMD_ARCHITECTURE, const PatchPoints&,
                                                                 const SlidingFieldOf<simd::Dual<double>>&,
                                                                 const PatchLawOf<simd::Dual<double>>&,
                                                                 const double*) const;
template void ViscosityKernel::operator()(PRS_SIMD_ARCHITECTURE, double, const double*, std::size_t, double*) const;

}  // namespace contact
