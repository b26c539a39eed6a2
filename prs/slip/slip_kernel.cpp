#include "prs/slip/slip_kernel.h"

#include <algorithm>

#include "simd/asinh.h"
#include "simd/inlined.h"

namespace prs {
namespace {

/// Friction of one patch per lane.
template <class Number, class Real>
contact::PatchFrictionOf<Number> patch_friction_of(const SharedPoints& shared, const SharedContactNumbers<Real>& c,
                                                   const double* viscosity_ratio,
                                                   const contact::PatchMotionOf<Number>& motion) {
  const contact::SlidingFieldOf<Number> field = contact::sliding_field(motion, c.semi_major, c.semi_minor);
  const contact::RollingContactOf<Number> contact = contact::rolling_contact(c.friction, c.peak_pressure, motion);
  contact::PatchSumsOf<Number> sums;
  c.friction.visit([&]<class Law>(const Law& law, const simd::Lanes<Real>& which) PRS_INLINED {
    const auto friction = law.in(contact);
    contact::PatchSumsOf<Number> found;
    for (std::size_t k = 0; k < shared.points.size; ++k) {
      contact::PatchPoint<Real> at{Real(shared.points.along_major[k]), Real(shared.points.along_minor[k]),
                                   Real(shared.points.dome[k]), Real(shared.points.inverse_dome[k])};
      if constexpr (Law::facts.has_film())
        at.viscosity_ratio = Real::load_unaligned(viscosity_ratio + shared.dome_of_point[k] * simd::kLanes<Real>);
      contact::add_point(found, field, at, friction);
    }
    simd::take_where<Real>(which, found, sums);
  });
  return contact::patch_friction(sums, shared.cell_load, static_cast<double>(shared.points.size), c.semi_major,
                                 c.semi_minor);
}

/// A batch of screws.
template <class Real>
class Screws {
 public:
  static constexpr std::size_t kLanes = simd::kLanes<Real>;

  Screws(const SharedPoints& shared, std::span<const SlipNumbers<double>> screws, const double* viscosity_ratio,
         std::span<SlipTask> tasks, double* memory)
      : shared_(shared),
        tasks_(tasks.first(std::min(kLanes, tasks.size()))),
        numbers_(simd::side_by_side<SlipNumbers<Real>>(screws.data(), screws.size())),
        ratio_(memory) {
    for (std::size_t l = 0; l < kLanes; ++l)
      for (std::size_t k = 0; k < 2 * shared.domes; ++k)
        memory[k * kLanes + l] = viscosity_ratio[(l < tasks.size() ? l : tasks.size() - 1) * 2 * shared.domes + k];
  }

  void search() {
    for (bool busy = true; busy;) {
      const Marked slopes = waiting(true);
      if (slopes.any) take(slopes, balance(simd::Dual<Real>(slip_ratios(), Real(1.0))));
      const Marked values = waiting(false);
      if (values.any) take(values, balance(slip_ratios()));
      busy = slopes.any || values.any;
    }
  }

 private:
  struct Marked {
    bool lanes[kLanes] = {};
    bool any = false;
  };
  /// Lanes that ask for an evaluation with the slope, or for one without.
  Marked waiting(bool with_slope) const {
    Marked marked;
    for (std::size_t l = 0; l < tasks_.size(); ++l)
      if (!tasks_[l].search.done() && tasks_[l].search.wants_slope() == with_slope) marked.lanes[l] = marked.any = true;
    return marked;
  }

  Real slip_ratios() const {
    double ratios[kLanes];
    for (std::size_t l = 0; l < kLanes; ++l)
      ratios[l] = tasks_[l < tasks_.size() ? l : tasks_.size() - 1].search.slip_ratio();
    return Real::load_unaligned(ratios);
  }

  template <class Number>
  SharedSlipBalance<Number> balance(const Number& slip_ratio) const {
    SharedSlipBalance<Number> found;
    found.roller = roller_balance(
        numbers_.roller, slip_ratio, Number(Real(0.0)),
        [&](Interface i, const contact::PatchMotionOf<Number>& sliding) {
          const SharedContactNumbers<Real>& c = numbers_.contacts[i];
          const double* ratio = ratio_ + (i == Interface::screw ? 0 : shared_.domes * kLanes);
          found.friction[i] = patch_friction_of(shared_, c, ratio, sliding);
          const PatchForces<Number> forces =
              patch_forces(numbers_.roller.frames[i], found.friction[i], c.axial_load, c.alike);
          found.normal_load[i] = forces.normal_load;
          return forces.on_roller;
        },
        equal_heads<Number, Real>);
    return found;
  }

  template <class Number>
  void take(const Marked& now, const SharedSlipBalance<Number>& found) {
    using simd::select, simd::value;
    const Number residue = found.roller.moments.residue() / numbers_.residue_unit;
    const Real possible =
        select(is_possible(found.normal_load.screw) && is_possible(found.normal_load.nut), Real(1.0), Real(0.0));
    double residues[kLanes], slopes[kLanes] = {}, are_possible[kLanes];
    value(residue).store_unaligned(residues);
    possible.store_unaligned(are_possible);
    if constexpr (std::is_same_v<Number, Real>) {
      SharedSlipBalance<double> balances[kLanes];
      simd::deliver(found, balances, kLanes);
      for (std::size_t l = 0; l < tasks_.size(); ++l)
        if (now.lanes[l]) tasks_[l].balance = balances[l];
    } else {
      residue.slope.store_unaligned(slopes);
    }
    for (std::size_t l = 0; l < tasks_.size(); ++l) {
      if (!now.lanes[l]) continue;
      if (are_possible[l] > 0.0)
        tasks_[l].search.take(residues[l], slopes[l]);
      else
        tasks_[l].search.jam();
    }
  }

  const SharedPoints& shared_;
  std::span<SlipTask> tasks_;
  SlipNumbers<Real> numbers_;
  const double* ratio_;
};

}  // namespace

template <class Arch>
void SlipKernel::operator()(Arch, const SharedPoints& points, std::span<const SlipNumbers<double>> screws,
                            const double* viscosity_ratio, std::span<SlipTask> tasks, double* memory) const {
  using Real = xsimd::batch<double, Arch>;
  for (std::size_t first = 0; first < screws.size(); first += simd::kLanes<Real>)
    Screws<Real>(points, screws.subspan(first), viscosity_ratio + first * 2 * points.domes, tasks.subspan(first),
                 memory)
        .search();
}

template void SlipKernel::operator()(PRS_SIMD_ARCHITECTURE, const SharedPoints&, std::span<const SlipNumbers<double>>,
                                     const double*, std::span<SlipTask>, double*) const;

}  // namespace prs
