#include "contact/patch_kernel.h"

#include "simd/asinh.h"
#include "simd/inlined.h"

namespace contact {
namespace {

template <class Batch, class Number>
using WideOf = std::conditional_t<std::is_same_v<Number, double>, Batch, simd::Dual<Batch>>;

/// Copies numbers to all lanes.
template <class Batch, template <class> class Of, class Number>
PRS_INLINED inline Of<WideOf<Batch, Number>> spread(const Of<Number>& one) {
  return simd::in_all_lanes<Of<WideOf<Batch, Number>>, Batch>(one);
}

using simd::sum_of;

template <class Batch>
simd::Dual<double> sum_of(const simd::Dual<Batch>& x) {
  return {sum_of(x.value), sum_of(x.slope)};
}

template <class Batch, class Law, class Number>
PatchSumsOf<Number> sums(const PatchPoints& points, const SlidingFieldOf<Number>& sliding, const Law& law,
                         const RollingContactOf<Number>& contact, const double* viscosity_ratio) {
  const auto field = spread<Batch>(sliding);
  const auto friction = spread<Batch>(law).in(spread<Batch>(contact));
  PatchSumsOf<WideOf<Batch, Number>> wide;
  for (std::size_t i = 0; i < points.size; i += Batch::size) {
    const auto load = [i](const double* values) { return Batch::load_unaligned(values + i); };
    PatchPoint<Batch> at{load(points.along_major), load(points.along_minor), load(points.dome),
                         load(points.inverse_dome)};
    if constexpr (Law::facts.has_film()) at.viscosity_ratio = load(viscosity_ratio);
    add_point(wide, field, at, friction);
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
                                            const FrictionLaw& law, const RollingContactOf<Number>& contact,
                                            const double* viscosity_ratio) const {
  PatchSumsOf<Number> found;
  law.visit([&](const auto& one, bool) {
    found = sums<xsimd::batch<double, Arch>>(points, sliding, one, contact, viscosity_ratio);
  });
  return found;
}

template <class Arch>
void ViscosityKernel::operator()(Arch, double viscosity, const double* pressure, std::size_t size,
                                 double* ratio) const {
  using Batch = xsimd::batch<double, Arch>;
  for (std::size_t i = 0; i < size; i += Batch::size)
    roelands_viscosity_ratio(viscosity, Batch::load_unaligned(pressure + i)).store_unaligned(ratio + i);
}

template PatchSums PatchKernel::operator()(PRS_SIMD_ARCHITECTURE, const PatchPoints&, const SlidingField&,
                                           const FrictionLaw&, const RollingContactOf<double>&, const double*) const;
template PatchSumsOf<simd::Dual<double>> PatchKernel::operator()(PRS_SIMD_ARCHITECTURE, const PatchPoints&,
                                                                 const SlidingFieldOf<simd::Dual<double>>&,
                                                                 const FrictionLaw&,
                                                                 const RollingContactOf<simd::Dual<double>>&,
                                                                 const double*) const;
template void ViscosityKernel::operator()(PRS_SIMD_ARCHITECTURE, double, const double*, std::size_t, double*) const;

}  // namespace contact
