#include "prs/sector/chain/refined_designs.h"

#include <cassert>
#include <tuple>

#include "prs/sector/chain/chain_solver.h"
#include "prs/sector/chain/nut_condensation.h"
#include "prs/sector/chain/refined_kernel.h"
#include "simd/dispatch.h"

namespace prs {
namespace {

/// Designs of one call of the kernel.
constexpr std::size_t kMostAtOnce = 256;

/// What sectors side by side must have in common, in an order.
auto kind(const SectorModel& sector) {
  const RefinedBodies& bodies = sector.bodies;
  const RefinedEffects& e = bodies.effects;
  return std::tuple<decltype(bodies.line.thrust), const decltype(bodies.line.contacts)&,
                    const decltype(bodies.same)&, std::array<bool, 6>>(
      bodies.line.thrust, bodies.line.contacts, bodies.same,
      {e.hoop, e.poisson, e.flange, e.radial, e.concentration, bodies.has_ring});
}

}  // namespace

void RefinedDesignSolver::solve(std::span<const SectorModel> sectors,
                                std::span<const double> axial_forces,
                                std::span<LoadDistribution> results) {
  assert(axial_forces.size() == sectors.size() && results.size() == sectors.size());
  order_.clear();
  for (std::size_t k = 0; k < sectors.size(); ++k)
    if (takes(sectors[k])) order_.push_back(k);
  const auto before = [&](std::size_t a, std::size_t b) {
    const auto one = kind(sectors[a]), other = kind(sectors[b]);
    return one != other ? one < other : a < b;
  };
  if (!std::ranges::is_sorted(order_, before)) std::ranges::sort(order_, before);
  for (std::size_t first = 0, end = 0; first < order_.size(); first = end) {
    sectors_.clear();
    forces_.clear();
    for (; end < order_.size() && sectors_.size() < kMostAtOnce; ++end) {
      const SectorModel& s = sectors[order_[end]];
      if (end > first && kind(sectors[order_[first]]) != kind(s)) break;
      sectors_.push_back({&s,
                          &s.bodies.numbers,
                          s.bodies.line.sections.data(),
                          s.bodies.line.outer_radius.data(),
                          s.bodies.bore.root.data(),
                          {s.gaps.screw.data(), s.gaps.nut.data()}});
      forces_.push_back(axial_forces[order_[end]]);
    }
    if (set_ == InstructionSet::scalar) {
      for (std::size_t k = first; k < end; ++k) {
        SectorModel sector = sectors[order_[k]];
        work_out(sector);
        ChainSolver solver(sector);
        solver.options = options;
        solver.solve(axial_forces[order_[k]], results[order_[k]]);
      }
      continue;
    }
    solve_side_by_side(sectors[order_[first]]);
    for (std::size_t k = first; k < end; ++k)
      loads_.copy(k - first, options.residual_tolerance, results[order_[k]]);
  }
}

void RefinedDesignSolver::solve_side_by_side(const SectorModel& first) {
  const NutShape shape = first.bodies.shape();
  set_segments_of(shape, segment_of_);
  loads_.resize(sectors_.size(), shape.contacts.size(), tangent_stiffness);
  double* const memory =
      workspace_.reserve((RefinedKernel::kNumbersOfContact * shape.contacts.size() +
                          RefinedKernel::kNumbersOfNode * shape.nodes()) *
                         static_cast<std::size_t>(batch_size(set_)));
  simd::run_kernel(set_, RefinedKernel{}, RefinedDesigns{sectors_, forces_, shape, segment_of_},
                   options, loads_, memory);
}

}  // namespace prs
