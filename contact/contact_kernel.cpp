#include "contact/contact_kernel.h"

#include <algorithm>

namespace contact {

template <class Arch>
void ContactKernel::operator()(Arch, std::span<const MechanismNumbers<double>> mechanisms,
                               std::span<MechanismContactNumbers<double>> contacts) const {
  using Real = xsimd::batch<double, Arch>;
  for (std::size_t first = 0; first < mechanisms.size(); first += simd::kLanes<Real>) {
    const auto m = simd::side_by_side<MechanismNumbers<Real>>(mechanisms.data() + first, mechanisms.size() - first);
    simd::deliver(contact_numbers(m), contacts.data() + first, mechanisms.size() - first);
  }
}

template <class Arch>
void EllipseKernel::operator()(Arch, double semi_major_per_cbrt_load, double semi_minor_per_cbrt_load,
                               std::span<const double> normal_load, const KnownApproach& known, double* semi_major,
                               double* semi_minor, double* peak_pressure) const {
  using Real = xsimd::batch<double, Arch>;
  constexpr std::size_t kLanes = simd::kLanes<Real>;
  const std::size_t all = normal_load.size();
  for (std::size_t next = 0; next < all; next += kLanes) {
    // The last batch is filled with numbers of the previous one.
    const std::size_t first = all < kLanes ? 0 : std::min(next, all - kLanes), size = all - first;
    const auto load = simd::side_by_side<Real>(normal_load.data() + first, size);
    const Real cbrt_load =
        known.approach.empty()
            ? cbrt(load)
            : known.cbrt_constant * sqrt(simd::side_by_side<Real>(known.approach.data() + first, size));
    const EllipseNumbers<Real> e =
        ellipse_numbers(Real(semi_major_per_cbrt_load), Real(semi_minor_per_cbrt_load), load, cbrt_load);
    simd::deliver(e.semi_major, semi_major + first, size);
    simd::deliver(e.semi_minor, semi_minor + first, size);
    simd::deliver(e.peak_pressure, peak_pressure + first, size);
  }
}

template void EllipseKernel::operator()(PRS_SIMD_ARCHITECTURE, double, double, std::span<const double>,
                                        const KnownApproach&, double*, double*, double*) const;
template void ContactKernel::operator()(PRS_SIMD_ARCHITECTURE, std::span<const MechanismNumbers<double>>,
                                        std::span<MechanismContactNumbers<double>>) const;

}  // namespace contact
