#include "contact/patch_kernel.h"

#include "contact/lubricant.h"
#include "simd/sum.h"

namespace contact {
namespace {

template <class Batch, class Friction>
PatchSums sums(const PatchPoints& points, const SlidingField& sliding, Friction friction_at) {
  Batch traction_1(0.0), traction_2(0.0), moment_1(0.0), moment_2(0.0), power(0.0), mean(0.0);
  Batch fastest(0.0);
  for (std::size_t i = 0; i < points.size; i += Batch::size) {
    const auto load = [i](const double* values) { return Batch::load_unaligned(values + i); };
    const Batch x = load(points.along_major), y = load(points.along_minor);
    const Batch v_1 = sliding.major - sliding.spin_minor * y;
    const Batch v_2 = sliding.minor + sliding.spin_major * x;
    const Batch speed = sqrt(v_1 * v_1 + v_2 * v_2);
    const Batch friction = friction_at(load, speed);  // mu_D dome
    const Batch directed = select(speed >= Batch(kNoDirection), friction, Batch(0.0));
    const Batch along = select(speed >= Batch(kNoDirection), directed / speed, Batch(0.0));
    const Batch friction_1 = along * v_1, friction_2 = along * v_2;
    const Batch inverse_dome = load(points.inverse_dome);
    traction_1 += friction_1;
    traction_2 += friction_2;
    moment_1 += x * friction_2;
    moment_2 += y * friction_1;
    power += directed * speed;
    mean += friction * inverse_dome;
    fastest = max(fastest, select(inverse_dome > Batch(0.0), speed, Batch(0.0)));
  }
  double max_speed = 0.0;
  for (std::size_t k = 0; k < Batch::size; ++k)
    max_speed = fastest.get(k) > max_speed ? fastest.get(k) : max_speed;
  using simd::sum;
  return {sum(traction_1), sum(traction_2), sum(moment_1), sum(moment_2),
          sum(power),      sum(mean),       max_speed};
}

}  // namespace

template <class Arch>
PatchSums PatchKernel::operator()(Arch, const PatchPoints& points, const SlidingField& sliding,
                                  const PatchLaw& law) const {
  using Batch = xsimd::batch<double, Arch>;
  if (!law.viscosity_ratio)
    return sums<Batch>(points, sliding, [&](auto load, const Batch&) {
      return law.coefficient * load(points.dome);
    });
  const auto film = [&](auto load, const Batch& speed) {
    return law.scale * asinh(law.factor * load(law.viscosity_ratio) * speed);
  };
  if (law.coefficient == 0.0) return sums<Batch>(points, sliding, film);
  return sums<Batch>(points, sliding, [&](auto load, const Batch& speed) {
    return law.coefficient * load(points.dome) + film(load, speed);
  });
}

template <class Arch>
void ViscosityKernel::operator()(Arch, double viscosity, const double* pressure, std::size_t size,
                                 double* ratio) const {
  using Batch = xsimd::batch<double, Arch>;
  for (std::size_t i = 0; i < size; i += Batch::size)
    roelands_viscosity_ratio(viscosity, Batch::load_unaligned(pressure + i))
        .store_unaligned(ratio + i);
}

template PatchSums PatchKernel::operator()(PRS_SIMD_ARCHITECTURE, const PatchPoints&,
                                           const SlidingField&, const PatchLaw&) const;
template void ViscosityKernel::operator()(PRS_SIMD_ARCHITECTURE, double, const double*, std::size_t,
                                          double*) const;

}  // namespace contact
